// SPDX-License-Identifier: MIT
#include "cache.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sodium.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstring>
#include <vector>

#include "core/error.hpp"
#include "core/files.hpp"

namespace texel::grade {
namespace {

namespace fs = std::filesystem;

using Digest = std::array<unsigned char, 32>;

Digest digest_of(std::initializer_list<std::string_view> texts) {
  std::string all;
  for (const std::string_view text : texts) {
    const std::uint64_t size = text.size();
    all.append(reinterpret_cast<const char*>(&size), sizeof size).append(text);
  }
  Digest digest{};
  // It fails only where the system has no source of random numbers; hashing needs none.
  crypto_generichash(digest.data(), digest.size(), reinterpret_cast<const unsigned char*>(all.data()),
                     all.size(), nullptr, 0);
  return digest;
}

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

std::string fingerprint(std::initializer_list<std::string_view> texts) {
  return fmt::format("{:02x}", fmt::join(digest_of(texts), ""));
}

std::string fingerprint_of_folder(const fs::path& folder,
                                  const std::function<bool(const fs::path&)>& counts) {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::recursive_directory_iterator it(folder, error), end; !error && it != end; it.increment(error))
    if (it->is_regular_file() && counts(it->path())) files.push_back(it->path());
  if (error) throw Error::failed(fmt::format("cannot be read: {}", error.message()), {folder.string()});
  std::sort(files.begin(), files.end());
  std::string print;
  for (const fs::path& file : files)
    print = fingerprint({print, file.lexically_relative(folder).generic_string(), read_file(file)});
  return print;
}

std::uint64_t draw(std::initializer_list<std::string_view> texts) {
  const Digest digest = digest_of(texts);
  std::uint64_t number = 0;
  std::memcpy(&number, digest.data(), sizeof number);
  return number;
}

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
