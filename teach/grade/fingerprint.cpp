// SPDX-License-Identifier: MIT
#include "fingerprint.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sodium.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <vector>

#include "core/error.hpp"
#include "core/files.hpp"

namespace texel::grade {
namespace {

namespace fs = std::filesystem;

using Digest = std::array<unsigned char, 32>;

class Hash {
 public:
  Hash() {
    // It fails only where the system has no source of random numbers; hashing needs none.
    crypto_generichash_init(&state_, nullptr, 0, Digest().size());
  }
  void add(std::string_view text) {
    const std::uint64_t size = text.size();
    std::array<unsigned char, sizeof size> bytes{};
    std::memcpy(bytes.data(), &size, sizeof size);
    crypto_generichash_update(&state_, bytes.data(), bytes.size());
    crypto_generichash_update(&state_, reinterpret_cast<const unsigned char*>(text.data()), text.size());
  }
  Digest digest() {
    Digest digest{};
    crypto_generichash_final(&state_, digest.data(), digest.size());
    return digest;
  }

 private:
  crypto_generichash_state state_{};
};

Digest digest_of(std::initializer_list<std::string_view> texts) {
  Hash hash;
  for (const std::string_view text : texts) hash.add(text);
  return hash.digest();
}

std::string hexadecimal(const Digest& digest) {
  return fmt::format("{:02x}", fmt::join(digest, ""));
}

}  // namespace

std::string fingerprint(std::initializer_list<std::string_view> texts) {
  return hexadecimal(digest_of(texts));
}

std::string fingerprint_of_folder(const fs::path& folder,
                                  const std::function<bool(const fs::path&)>& counts) {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::recursive_directory_iterator it(folder, error), end; !error && it != end; it.increment(error))
    if (it->is_regular_file() && counts(it->path())) files.push_back(it->path());
  if (error) throw Error::failed(fmt::format("cannot be read: {}", error.message()), {folder.string()});
  std::sort(files.begin(), files.end());
  Hash hash;
  for (const fs::path& file : files) {
    hash.add(file.lexically_relative(folder).generic_string());
    hash.add(read_file(file));
  }
  return hexadecimal(hash.digest());
}

std::uint64_t draw(std::initializer_list<std::string_view> texts) {
  const Digest digest = digest_of(texts);
  std::uint64_t number = 0;
  std::memcpy(&number, digest.data(), sizeof number);
  return number;
}

}  // namespace texel::grade
