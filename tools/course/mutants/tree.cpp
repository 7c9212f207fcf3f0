// SPDX-License-Identifier: MIT
#include "course/mutants/tree.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <set>

#include "core/error.hpp"
#include "core/files.hpp"

namespace texel::tools {
namespace {

namespace fs = std::filesystem;

/// What is made from the rest, and what is not the tree's.
bool is_left_out(const fs::path& name) {
  return name == ".git" || name == ".cache" || name == "build" || name == "out";
}

/// The regular files below `folder` but those left out, relative to it.
std::set<fs::path> files_below(const fs::path& folder) {
  std::set<fs::path> files;
  fs::recursive_directory_iterator entry(folder), end;
  for (; entry != end; ++entry) {
    if (entry.depth() == 0 && is_left_out(entry->path().filename()))
      entry.disable_recursion_pending();
    else if (entry->is_regular_file())
      files.insert(entry->path().lexically_relative(folder));
  }
  return files;
}

bool same_bytes(const fs::path& a, const fs::path& b) {
  return fs::exists(b) && fs::file_size(a) == fs::file_size(b) && read_file(a) == read_file(b);
}

}  // namespace

Tree::Tree(fs::path root, fs::path copy)
    : root_(fs::weakly_canonical(root)), copy_(fs::weakly_canonical(copy)) {
  const fs::path below = copy_.lexically_relative(root_);
  const bool is_inside = !below.empty() && *below.begin() != "..";
  if (is_inside && !is_left_out(*below.begin()))
    throw Error::usage(fmt::format("the work folder {} is part of the tree", copy_.string()),
                       "choose one outside, or below its build folder");
}

void Tree::update() const {
  try {
    fs::create_directories(copy_);
    const std::set<fs::path> wanted = files_below(root_);
    for (const fs::path& file : files_below(copy_))
      if (!wanted.contains(file)) fs::remove(copy_ / file);
    for (const fs::path& file : wanted) {
      if (same_bytes(root_ / file, copy_ / file)) continue;
      fs::create_directories((copy_ / file).parent_path());
      fs::copy_file(root_ / file, copy_ / file, fs::copy_options::overwrite_existing);
    }
  } catch (const fs::filesystem_error& error) {
    throw Error::failed(fmt::format("cannot copy the tree: {}", error.what()), {copy_.string()});
  }
}

std::string Tree::state() const {
  // FNV-1a (G. Fowler, L. Noll, K.-P. Vo), 64 bits: nobody here looks for two trees that collide.
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const fs::path& file : files_below(root_))
    for (const std::string& text : {file.string(), read_file(root_ / file)})
      for (const char c : text + '\0') hash = (hash ^ static_cast<std::uint8_t>(c)) * 0x100000001b3U;
  return fmt::format("{:016x}", hash);
}

AppliedMutant::AppliedMutant(const Tree& tree, const course::Mutant& mutant)
    : file_(tree.folder() / mutant.file), original_(read_file(file_)) {
  write_file(file_, course::mutated(mutant, original_));
}

AppliedMutant::~AppliedMutant() {
  try {
    write_file(file_, original_);
  } catch (const Error&) {  // a full disk: the next update mends the copy
  }
}

}  // namespace texel::tools
