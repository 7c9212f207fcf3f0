// SPDX-License-Identifier: MIT
#include "kept.hpp"

#include <chrono>
#include <string>
#include <vector>

namespace texel::grade {
namespace {

namespace fs = std::filesystem;

/// Another process may remove or use the same things: what fails is left to the next.
template <class Chosen>
void remove_older(const fs::path& folder, std::chrono::days age, const Chosen& chosen) {
  std::error_code error;
  std::vector<fs::path> old;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    const auto used = it->last_write_time(error);
    if (!error && chosen(it->path().filename().string()) && used < fs::file_time_type::clock::now() - age)
      old.push_back(it->path());
  }
  for (const fs::path& thing : old) fs::remove_all(thing, error);
}

}  // namespace

bool is_kept(const fs::path& folder) {
  if (!fs::exists(folder)) return false;
  std::error_code ignored;  // a cache may be another user's
  fs::last_write_time(folder, fs::file_time_type::clock::now(), ignored);
  return true;
}

void remove_unused(const fs::path& cache) {
  for (const char* things : {"objects", "programs", "references", "solutions/objects", "solutions/programs"})
    remove_older(cache / things, std::chrono::days(30), [](const std::string&) { return true; });
  const auto is_large_or_half_made = [](const std::string& name) {
    for (const char* kind : {"starter-", "references-", "mutant-", "compile-", "link-"})
      if (name.starts_with(kind)) return true;
    return false;
  };
  remove_older(cache, std::chrono::days(7), is_large_or_half_made);
  remove_older(cache / "solutions", std::chrono::days(7), is_large_or_half_made);
}

}  // namespace texel::grade
