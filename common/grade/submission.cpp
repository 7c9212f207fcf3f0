// SPDX-License-Identifier: MIT
#include "grade/submission.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <string_view>

#include "core/error.hpp"
#include "core/files.hpp"
#include "core/plain_text.hpp"
#include "submission_source.hpp"

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

/// Which allowed files end in a path: all of them, so that a file of a common name stands for none.
class Endings {
 public:
  explicit Endings(const std::vector<std::string>& allowed) {
    for (const std::string& file : allowed)
      for (const std::string_view ending : endings_of(file)) files_[std::string(ending)].push_back(file);
  }
  [[nodiscard]] const std::vector<std::string>& find(std::string_view ending) const {
    static const std::vector<std::string> none;
    const auto found = files_.find(std::string(ending));
    return found == files_.end() ? none : found->second;
  }

 private:
  std::map<std::string, std::vector<std::string>> files_;
};

/// A folder of the submission as the tree's root: for each allowed file the item that stands for it.
struct Root {
  std::string folder;  ///< "" or ending in '/'
  std::map<std::string, const Item*> files;

  [[nodiscard]] std::ptrdiff_t depth() const { return std::count(folder.begin(), folder.end(), '/'); }
};

bool is_better(const Root& a, const Root& b) {
  if (a.files.size() != b.files.size()) return a.files.size() > b.files.size();
  if (a.depth() != b.depth()) return a.depth() < b.depth();
  return a.folder < b.folder;
}

Root find_root(const std::vector<Item>& items, const Endings& endings) {
  std::map<std::string, Root> roots;
  for (const Item& item : items) {
    if (!item.refused.empty()) continue;
    for (const std::string_view ending : endings_of(item.path)) {
      const std::vector<std::string>& files = endings.find(ending);
      if (files.size() != 1) continue;
      Root& root = roots[item.path.substr(0, item.path.size() - ending.size())];
      const Item*& taken = root.files[files[0]];
      // Below one root the longer path names more of the file's place.
      if (taken == nullptr || taken->path.size() <= item.path.size()) taken = &item;
    }
  }
  Root best;
  for (auto& [folder, root] : roots) {
    root.folder = folder;
    if (is_better(root, best)) best = root;
  }
  return best;
}

/// Why an item that is not refused was not taken.
std::string reason(const Item& item, const Root& root, const Endings& endings, const Endings& small_endings) {
  const bool is_below_root = item.path.starts_with(root.folder);
  const std::string_view below = std::string_view(item.path).substr(is_below_root ? root.folder.size() : 0);
  if (const std::vector<std::string>& files = endings.find(below); is_below_root && !files.empty()) {
    if (files.size() > 1)
      return fmt::format("could be any of {}; hand in the folder that contains labs and shaders",
                         fmt::join(files, ", "));
    return fmt::format("is not used: '{}' is used for {}", root.files.at(files[0])->path, files[0]);
  }
  for (const std::string_view ending : endings_of(item.path))
    if (endings.find(ending).size() == 1)
      return fmt::format("is outside {}, which has most of the labs",
                         root.folder.empty() ? "the top folder" : "'" + root.folder + "'");
  if (const std::vector<std::string>& files = small_endings.find(lower_case(below)); !files.empty())
    return fmt::format("should be called {}: upper and lower case matter", files[0]);
  for (const char* ending : {".zip", ".gz", ".tgz", ".tar", ".rar", ".7z", ".xz", ".bz2", ".zst"})
    if (lower_case(item.path).ends_with(ending))
      return "is an archive inside the submission; it is not opened";
  return "is not a file with steps";
}

/// By its byte-order mark. No compiler reads such a file.
bool is_utf16(std::string_view bytes) {
  return bytes.starts_with("\xff\xfe") || bytes.starts_with("\xfe\xff");
}

std::vector<std::string> all_lower_case(const std::vector<std::string>& texts) {
  std::vector<std::string> lower;
  for (const std::string& text : texts) lower.push_back(lower_case(text));
  return lower;
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
  constexpr fs::perms read = fs::perms::owner_read | fs::perms::group_read | fs::perms::others_read;
  constexpr fs::perms enter = fs::perms::owner_exec | fs::perms::group_exec | fs::perms::others_exec;
  const bool can_enter = (fs::status(path).permissions() & fs::perms::owner_exec) != fs::perms::none;
  fs::permissions(path, can_enter ? read | enter : read, fs::perm_options::add);
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

void make_folder(const fs::path& folder) {
  fs::create_directories(folder);
  open_to_all(folder);
}

}  // namespace

Submission unpack(const Entry& entry, const std::vector<std::string>& allowed, const UnpackLimits& limits) {
  Submission submission;
  Listing listing = list(entry, limits);
  submission.fault = listing.fault;
  if (!submission.fault.empty()) return submission;
  const Endings endings(allowed);
  const Endings small_endings(all_lower_case(allowed));
  const Root root = find_root(listing.items, endings);
  submission.root = root.folder;
  std::map<std::size_t, std::string> wanted;
  for (const auto& [file, item] : root.files) wanted[item->position] = file;
  for (const Item& item : listing.items) {
    if (item.refused.empty() && wanted.count(item.position) > 0) continue;
    const std::string path = item.refused.empty() ? item.path : name_to_show(item.path);
    submission.ignored.push_back(
        {path, item.refused.empty() ? reason(item, root, endings, small_endings) : item.refused});
    submission.sizes[path] = item.size;
  }
  read(entry, wanted, limits, submission);
  if (!submission.fault.empty()) submission.files.clear();
  for (const auto& [file, item] : root.files)
    if (const auto taken = submission.files.find(file);
        taken != submission.files.end() && is_utf16(taken->second)) {
      submission.ignored.push_back({item->path, "is saved as UTF-16; save it as UTF-8"});
      submission.files.erase(taken);
    }
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
    make_folder(to);
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(trusted_tree)) {
      const fs::path relative = entry.path().lexically_relative(trusted_tree);
      if (entry.is_symlink() || (!entry.is_directory() && !entry.is_regular_file()))
        throw Error::failed("is neither a file nor a folder", {entry.path().string()},
                            "remove links and devices from the trusted tree");
      if (entry.is_directory())
        make_folder(to / relative);
      else if (files.count(relative.generic_string()) == 0)
        link_or_copy(entry.path(), to / relative);
    }
    for (const auto& [path, bytes] : files) {
      make_folder((to / path).parent_path());
      write_file(to / path, bytes);
      open_to_all(to / path);
    }
  } catch (const fs::filesystem_error& error) {
    throw Error::failed(fmt::format("cannot write: {}", error.code().message()), {error.path1().string()},
                        "check that the folder is writable and the disk has free space");
  }
}

}  // namespace texel::grade
