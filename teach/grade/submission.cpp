// SPDX-License-Identifier: MIT
#include "grade/submission.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <string_view>
#include <tuple>

#include "core/error.hpp"
#include "core/files.hpp"
#include "core/plain_text.hpp"
#include "unpack.hpp"

namespace texel::grade {
namespace {

namespace fs = std::filesystem;

/// The parts of a path from the last on: "a/b/c" gives "c", "b/c", "a/b/c".
std::vector<std::string_view> endings_of(std::string_view path) {
  std::vector<std::string_view> endings;
  for (std::size_t bar = path.rfind('/'); bar != std::string_view::npos && bar > 0;
       bar = path.rfind('/', bar - 1))
    endings.push_back(path.substr(bar + 1));
  endings.push_back(path);
  return endings;
}

/// The allowed files that end in a path, by it in small letters: all of them, so that a file of a common name
/// stands for none.
using Endings = std::map<std::string, std::vector<std::string>>;

/// An older file needs its folder: by its name alone it may be one of today.
Endings endings_of(const std::vector<std::string>& allowed, const std::set<std::string>& older) {
  Endings endings;
  for (const std::string& file : allowed)
    for (const std::string_view ending : endings_of(file)) endings[lower_case(ending)].push_back(file);
  for (const std::string& file : older)
    for (const std::string_view ending : endings_of(file))
      if (ending.find('/') != ending.npos) endings[lower_case(ending)].push_back(file);
  return endings;
}

/// A folder of the submission as the tree's root: for each allowed file the items that stand for it. Several
/// differ in capitals alone, so that nobody knows which is meant.
struct Root {
  std::string folder;  ///< "" or ending in '/'
  std::map<std::string, std::vector<const Item*>> files;
  std::set<std::string> begun;  ///< steps, where there is a choice

  [[nodiscard]] std::ptrdiff_t depth() const { return std::count(folder.begin(), folder.end(), '/'); }
  [[nodiscard]] std::ptrdiff_t clear() const {
    return std::ranges::count_if(files, [](const auto& file) { return file.second.size() == 1; });
  }
};

bool is_better(const Root& a, const Root& b) {
  return std::tuple(b.begun.size(), b.clear(), a.depth(), a.folder) <
         std::tuple(a.begun.size(), a.clear(), b.depth(), b.folder);
}

/// Below one root the longer path names more of the file's place, then the one with the right capitals; of
/// two equal paths the later is taken, as tar does.
void stand(Root& root, const Item& item, const std::string& file) {
  std::vector<const Item*>& taken = root.files[file];
  const auto rank = [&](const Item& one) {
    return std::pair(one.path.size(), file.ends_with(one.path.substr(root.folder.size())));
  };
  if (taken.empty() || rank(*taken[0]) < rank(item)) {
    taken = {&item};
  } else if (rank(*taken[0]) == rank(item)) {
    std::erase_if(taken, [&](const Item* one) { return one->path == item.path; });
    taken.push_back(&item);
  }
}

/// The allowed file for which an item stands, and the root that names most of it.
struct Meaning {
  std::string file, folder;
};

/// What stands for the allowed files, wherever it lies.
struct Found {
  std::map<std::string, Root> roots;                         ///< by folder
  std::map<std::string, std::vector<const Item*>> anywhere;  ///< by allowed file: different paths
  std::map<const Item*, Meaning> meanings;
};

Found find_roots(const std::vector<Item>& items, const Endings& endings) {
  Found found;
  for (const Item& item : items) {
    if (!item.refused.empty()) continue;
    for (const std::string_view ending : endings_of(item.path)) {
      const auto files = endings.find(lower_case(ending));
      if (files == endings.end() || files->second.size() != 1) continue;
      const std::string& file = files->second[0];
      const std::string folder = item.path.substr(0, item.path.size() - ending.size());
      Root& root = found.roots[folder];
      root.folder = folder;
      stand(root, item, file);
      found.meanings[&item] = {file, folder};
    }
    const auto own = found.meanings.find(&item);
    if (own == found.meanings.end()) continue;
    std::vector<const Item*>& all = found.anywhere[own->second.file];
    std::erase_if(all, [&](const Item* one) { return one->path == item.path; });
    all.push_back(&item);
  }
  return found;
}

/// Of two copies of the labs the one with more of the work is meant: counts the steps that were begun in
/// each, where there are two.
void count_begun(const Entry& entry, const UnpackLimits& limits, const FirstText& first_text, Found& found) {
  if (std::ranges::all_of(found.anywhere, [](const auto& file) { return file.second.size() == 1; })) return;
  std::set<const Item*> items;
  for (const auto& [item, meaning] : found.meanings) items.insert(item);
  std::map<const Item*, std::set<std::string>> steps;
  Submission unused;
  read(entry, items, limits, unused, [&](const Item& item, const std::string& text) {
    steps[&item] = begun_steps(found.meanings.at(&item).file, text, first_text);
  });
  for (auto& [folder, root] : found.roots)
    for (const auto& [file, all] : root.files)
      if (all.size() == 1) root.begun.insert(steps[all[0]].begin(), steps[all[0]].end());
}

std::string named(const std::string& folder) {
  return folder.empty() ? "the top folder" : "'" + folder + "'";
}

/// Why an item that is not refused was not taken.
std::string reason(const Item& item, const Root& root, const Found& found, const Endings& endings,
                   const std::map<std::string, const Item*>& taken) {
  if (const auto own = found.meanings.find(&item); own != found.meanings.end()) {
    const std::string& file = own->second.file;
    if (const auto used = taken.find(file); used != taken.end())
      return fmt::format("is not used: '{}' is used for {}", used->second->path, file);
    if (root.files.contains(file))
      return fmt::format("should be called {}: upper and lower case matter where there are two", file);
    const std::size_t count = found.anywhere.at(file).size();
    if (count == 1) return fmt::format("is outside {}, which is graded", named(root.folder));
    return fmt::format("is one of {} files for {}, and none of them is in {}, which is graded", count, file,
                       named(root.folder));
  }
  for (const std::string_view ending : endings_of(item.path))
    if (const auto files = endings.find(lower_case(ending));
        files != endings.end() && files->second.size() > 1)
      return fmt::format("could be any of {}; hand in the folder that contains labs and shaders",
                         fmt::join(files->second, ", "));
  for (const char* ending : {".zip", ".gz", ".tgz", ".tar", ".rar", ".7z", ".xz", ".bz2", ".zst"})
    if (lower_case(item.path).ends_with(ending))
      return "is an archive inside the submission; it is not opened";
  return "is not a file with steps";
}

/// By its byte-order mark. No compiler reads such a file.
bool is_utf16(std::string_view bytes) {
  return bytes.starts_with("\xff\xfe") || bytes.starts_with("\xfe\xff");
}

std::string name_to_show(const std::string& path) {
  constexpr std::size_t longest = 200;
  if (path.empty()) return "(an entry without a name)";
  return plain_text(path.substr(0, longest)) + (path.size() > longest ? "…" : "");
}

void check_place(const std::string& path) {
  const fs::path file(path);
  if (path.empty() || file.is_absolute() || file != file.lexically_normal() || *file.begin() == ".." ||
      !file.has_filename())
    throw Error::failed(fmt::format("'{}' is not the path of a file in the tree", plain_text(path)));
}

/// Lets everybody read a file and enter a folder: in the sandbox the reader is nobody in particular.
void open_to_all(const fs::path& path) {
  const bool can_enter = (fs::status(path).permissions() & fs::perms::owner_exec) != fs::perms::none;
  fs::permissions(path, fs::perms(can_enter ? 0555 : 0444), fs::perm_options::add);
}

/// A link would share the permissions, so that a file which is closed to others is copied.
void link_or_copy(const fs::path& from, const fs::path& to) {
  const fs::perms permissions = fs::status(from).permissions();
  std::error_code error;
  if ((permissions & fs::perms::others_read) != fs::perms::none) fs::create_hard_link(from, to, error);
  if (fs::exists(to)) return;
  fs::copy_file(from, to);
  open_to_all(to);
}

void make_open_folder(const fs::path& folder) {
  fs::create_directories(folder);
  open_to_all(folder);
}

}  // namespace

Submission unpack(const Entry& entry, const std::vector<std::string>& allowed, const FirstText& first_text,
                  const UnpackLimits& limits) {
  Submission submission;
  Listing listing = list(entry, limits);
  submission.fault = listing.fault;
  submission.is_empty = listing.items.empty() && listing.fault.empty();
  if (submission.is_empty) submission.fault = "is empty: nothing was handed in";
  if (!submission.fault.empty()) return submission;
  const Endings endings = endings_of(allowed, older_files(allowed));
  Found found = find_roots(listing.items, endings);
  count_begun(entry, limits, first_text, found);
  Root root;
  for (const auto& [folder, one] : found.roots)
    if (is_better(one, root)) root = one;
  submission.root = root.folder;
  std::map<std::string, const Item*> taken;
  for (const auto& [file, items] : root.files)
    if (items.size() == 1) taken[file] = items[0];
  // Where there is no other it is clear what is meant, but not by a file's name alone: the course has others
  // of the same names.
  for (const auto& [file, items] : found.anywhere)
    if (items.size() == 1 &&
        items[0]->path.find('/', found.meanings.at(items[0]).folder.size()) != std::string::npos)
      taken[file] = items[0];
  std::set<const Item*> wanted;
  for (const auto& [file, item] : taken) wanted.insert(item);

  std::set<std::string> copies;
  for (const Item& item : listing.items) {
    if (wanted.contains(&item)) continue;
    const std::string path = item.refused.empty() ? item.path : name_to_show(item.path);
    submission.ignored.push_back(
        {path, item.refused.empty() ? reason(item, root, found, endings, taken) : item.refused});
    submission.sizes[path] = item.size;
    if (const auto own = found.meanings.find(&item); own != found.meanings.end())
      copies.insert(own->second.folder);
  }
  for (const std::string& folder : copies) {
    const Root& copy = found.roots.at(folder);
    if (folder == root.folder || (copy.files.size() == 1 && copy.begun.empty())) continue;
    submission.copies.push_back(
        {folder.empty() ? "/" : folder,
         fmt::format("is another copy of the labs, and is not graded: {} steps are begun in it, and {} in {}",
                     copy.begun.size(), root.begun.size(), named(root.folder))});
  }
  read(entry, wanted, limits, submission, [&](const Item& item, std::string text) {
    if (is_utf16(text))
      submission.ignored.push_back({item.path, "is saved as UTF-16; save it as UTF-8"});
    else
      submission.files[found.meanings.at(&item).file] = std::move(text);
  });
  if (!submission.fault.empty()) submission.files.clear();
  take_older_steps(submission, allowed, first_text);
  if (submission.files.empty() && submission.fault.empty())
    submission.fault = fmt::format(
        "contains no file with steps, so nothing was taken ({} not used); hand in the folder that contains "
        "labs and shaders",
        submission.ignored.size() == 1 ? "1 file is"
                                       : fmt::format("{} files are", submission.ignored.size()));
  return submission;
}

void overlay(const fs::path& trusted_tree, const std::map<std::string, std::string>& files,
             const fs::path& to) {
  if (fs::exists(to) && !fs::is_empty(to))
    throw Error::failed("is not empty", {to.string()}, "name a new folder");
  for (const auto& [path, bytes] : files) check_place(path);
  try {
    make_open_folder(to);
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(trusted_tree)) {
      const fs::path relative = entry.path().lexically_relative(trusted_tree);
      if (entry.is_symlink() || (!entry.is_directory() && !entry.is_regular_file()))
        throw Error::failed("is neither a file nor a folder", {entry.path().string()},
                            "remove links and devices from the trusted tree");
      if (entry.is_directory())
        make_open_folder(to / relative);
      else if (files.count(relative.generic_string()) == 0)
        link_or_copy(entry.path(), to / relative);
    }
    for (const auto& [path, bytes] : files) {
      make_open_folder((to / path).parent_path());
      write_file(to / path, bytes);
      open_to_all(to / path);
    }
  } catch (const fs::filesystem_error& error) {
    throw Error::failed(fmt::format("cannot write: {}", error.code().message()), {error.path1().string()},
                        "check that the folder is writable and the disk has free space");
  }
}

void make_root(const fs::path& trusted_tree, const std::map<std::string, std::string>& files,
               const fs::path& root) {
  constexpr std::string_view kShaders = "shaders/";
  std::map<std::string, std::string> shaders;
  for (const auto& [path, text] : files)
    if (path.starts_with(kShaders)) shaders[path.substr(kShaders.size())] = text;
  overlay(trusted_tree / "shaders", shaders, root / "shaders");
  fs::create_directory_symlink(trusted_tree / "assets", root / "assets");
}

}  // namespace texel::grade
