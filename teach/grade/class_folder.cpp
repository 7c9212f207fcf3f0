// SPDX-License-Identifier: MIT
// Who is who in a class folder.
#include <fcntl.h>
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <regex>
#include <set>
#include <string_view>

#include "core/error.hpp"
#include "core/plain_text.hpp"
#include "grade/submission.hpp"
#include "sandbox/descriptor.hpp"

namespace texel::grade {
namespace {

namespace fs = std::filesystem;

/// What an archive's name ends in.
constexpr std::pair<std::string_view, Entry::Kind> kEndings[] = {{".zip", Entry::Kind::zip},
                                                                 {".tar.gz", Entry::Kind::tar},
                                                                 {".tgz", Entry::Kind::tar},
                                                                 {".tar", Entry::Kind::tar}};

Entry::Kind kind_of(const fs::path& path) {
  const fs::file_status status = fs::symlink_status(path);
  if (fs::is_directory(status)) return Entry::Kind::folder;
  const std::string name = lower_case(path.filename().string());
  for (const auto& [ending, kind] : kEndings)
    if (fs::is_regular_file(status) && name.ends_with(ending)) return kind;
  return Entry::Kind::other;
}

/// A file name without what says its kind.
std::string stem_of(const std::string& file_name) {
  for (const auto& [ending, kind] : kEndings)
    if (lower_case(file_name).ends_with(ending)) return file_name.substr(0, file_name.size() - ending.size());
  return file_name;
}

/// How an LMS names what it gives out: the student's name, and the number that it knows the student by.
bool is_of_lms(const std::string& stem, std::smatch& name_and_number) {
  static const std::regex moodle(R"(([\s\S]+?)_([0-9]{1,20})_assignsubmission_)");
  // LATE stands behind the name; then the numbers of user and submission, and the file. No name has a '_'.
  static const std::regex canvas("([^_]+)_(?:late_)?([0-9]{1,20})_[0-9]{1,20}_", std::regex::icase);
  constexpr auto from_the_first = std::regex_constants::match_continuous;
  return std::regex_search(stem, name_and_number, moodle, from_the_first) ||
         std::regex_search(stem, name_and_number, canvas, from_the_first);
}

/// FNV-1a (G. Fowler, L. Noll, K.-P. Vo), 64 bits, of which 32 are shown.
std::string hash_of(const std::string& bytes) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char c : bytes) hash = (hash ^ static_cast<std::uint8_t>(c)) * 0x100000001b3U;
  return fmt::format("{:08x}", static_cast<std::uint32_t>(hash ^ hash >> 32U));
}

/// What of a name can stand in an id.
std::string slug_of(const std::string& name) {
  constexpr std::size_t longest = 60;
  std::string slug;
  for (const char c : lower_case(name)) {
    const bool kept = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
    // Not '-' at the beginning, where a command would take it for an option, nor one after the other.
    if (kept && !(slug.empty() && (c == '-' || c == '_')))
      slug += c;
    else if (!slug.empty() && slug.back() != '-')
      slug += '-';
  }
  slug.resize(std::min(slug.size(), longest));
  while (!slug.empty() && slug.back() == '-') slug.pop_back();
  return slug.empty() ? "student" : slug;
}

/// The only thing in a folder when that is an archive; else the folder.
fs::path archive_alone_in(const fs::path& folder) {
  fs::path found;
  std::error_code unreadable;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, unreadable)) {
    if (entry.path().filename().string().starts_with(".")) continue;
    const Entry::Kind kind = kind_of(entry.path());
    if (!found.empty() || (kind != Entry::Kind::zip && kind != Entry::Kind::tar)) return folder;
    found = entry.path();
  }
  return found.empty() ? folder : found;
}

Entry read_entry(const fs::path& path) {
  Entry entry;
  entry.kind = kind_of(path);
  entry.path = entry.kind == Entry::Kind::folder ? archive_alone_in(path) : path;
  const std::string file_name = path.filename().string();
  const std::string stem = entry.kind == Entry::Kind::folder ? file_name : stem_of(file_name);
  entry.kind = kind_of(entry.path);
  std::string name = stem;
  if (std::smatch found; is_of_lms(stem, found)) name = found[1], entry.number = found[2];
  entry.id = slug_of(name);
  if (!entry.number.empty())
    entry.id += "-" + entry.number;
  else if (entry.id != name)
    entry.id += "-" + hash_of(file_name);
  entry.name = plain_text(name);
  return entry;
}

}  // namespace

std::vector<Entry> read_class(const fs::path& folder) {
  const Descriptor opened(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!opened.is_open())
    throw Error::failed("is not a readable folder", {folder.string()},
                        "name the folder that contains the students' folders and archives");
  std::vector<Entry> entries;
  std::vector<std::string> file_names;
  std::map<std::string, int> wanted;
  for (const std::string& name : sandbox::names_in(opened, std::numeric_limits<std::size_t>::max())) {
    if (name.starts_with(".")) continue;
    entries.push_back(read_entry(folder / name));
    file_names.push_back(name);
    ++wanted[entries.back().id];
  }
  std::set<std::string> taken;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    std::string id = entries[i].id;
    if (wanted[id] > 1) id += "-" + hash_of(file_names[i]);
    entries[i].id = id;
    for (int n = 2; !taken.insert(entries[i].id).second; ++n) entries[i].id = fmt::format("{}-{}", id, n);
  }
  return entries;
}

}  // namespace texel::grade
