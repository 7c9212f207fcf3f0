// SPDX-License-Identifier: MIT
#include "check/files.hpp"

#include <optional>

#include "core/files.hpp"

namespace texel::grade {
namespace {

namespace fs = std::filesystem;

/// Larger than any picture or vertex stream that can be right.
constexpr std::uintmax_t kMostBytes = 64U << 20U;

}  // namespace

Verdict judge(const course::Case& of, const ExpectedFiles& expected, const fs::path& picture) {
  const MappedFile reference(expected.reference);
  std::optional<MappedFile> mask, own;
  if (!expected.mask.empty()) mask.emplace(expected.mask);
  if (fs::is_regular_file(fs::symlink_status(picture))) own.emplace(picture);
  return judge(of, {reference.bytes(), mask ? mask->bytes() : std::string_view()},
               own ? std::optional(own->bytes()) : std::nullopt);
}

std::string picture_bytes(const fs::path& picture) {
  if (!fs::is_regular_file(fs::symlink_status(picture)) || fs::file_size(picture) > kMostBytes) return {};
  return read_file(picture);
}

}  // namespace texel::grade
