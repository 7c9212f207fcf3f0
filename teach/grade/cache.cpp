// SPDX-License-Identifier: MIT
#include "cache.hpp"

#include <chrono>
#include <string>
#include <vector>

namespace texel::grade {
namespace {

namespace fs = std::filesystem;

/// Whether a name is `kind` and the first digits of a fingerprint. Nothing else may go: the cache may be any
/// folder, in which somebody has things of their own.
bool is_ours(const std::string& name, const std::string& kind) {
  constexpr std::size_t fewest = 16;
  return name.starts_with(kind) && name.size() >= kind.size() + fewest &&
         name.find_first_not_of("0123456789abcdef", kind.size()) == name.npos;
}

/// Another process may remove or use the same things: what fails is left to the next.
void remove_older(const fs::path& folder, const std::string& kind, std::chrono::days age) {
  std::error_code error;
  std::vector<fs::path> old;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    const auto used = it->last_write_time(error);
    if (!error && is_ours(it->path().filename().string(), kind) &&
        used < fs::file_time_type::clock::now() - age)
      old.push_back(it->path());
  }
  for (const fs::path& thing : old) fs::remove_all(thing, error);
}

}  // namespace

bool is_cached(const fs::path& folder) {
  if (!fs::exists(folder)) return false;
  std::error_code ignored;  // a cache may be another user's
  fs::last_write_time(folder, fs::file_time_type::clock::now(), ignored);
  return true;
}

void remove_unused(const fs::path& cache) {
  for (const char* things : {"objects", "programs", "references", "solutions/objects", "solutions/programs"})
    remove_older(cache / things, "", std::chrono::days(30));
  remove_older(cache, "starter-", std::chrono::days(7));
}

}  // namespace texel::grade
