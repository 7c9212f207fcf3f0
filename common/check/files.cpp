// SPDX-License-Identifier: MIT
#include "check/files.hpp"

#include <optional>

#include "core/files.hpp"
#include "image/load.hpp"

namespace texel::check {
namespace {

namespace fs = std::filesystem;

/// Larger than any picture or vertex stream that can be right.
constexpr std::uintmax_t kMostBytes = 64U << 20U;

}  // namespace

judge::Verdict judge(const course::Case& of, const ExpectedFiles& expected, const fs::path& picture) {
  const MappedFile reference(expected.reference);
  std::optional<MappedFile> mask, own;
  if (!expected.mask.empty()) mask.emplace(expected.mask);
  if (fs::is_regular_file(fs::symlink_status(picture))) own.emplace(picture);
  return judge::judge(of, {reference.bytes(), mask ? mask->bytes() : std::string_view()},
                      own ? std::optional(own->bytes()) : std::nullopt);
}

std::string picture_bytes(const fs::path& picture) {
  if (!fs::is_regular_file(fs::symlink_status(picture)) || fs::file_size(picture) > kMostBytes) return {};
  return read_file(picture);
}

image::Compared compared(const judge::CaseResult& one) {
  if (one.is_mesh()) throw Error::failed("this case compares vertices, not pictures");
  if (one.picture.empty()) throw Error::failed("your picture is missing: " + one.message);
  // What renderers differ by is dark.
  const double scale = judge::kNothingLeft * one.limit;
  if (one.view == course::View::color)
    return image::compared(image::load8(one.picture, 3), image::load8(one.reference, 3), scale, one.error);
  return image::compared(image::load_pfm(one.picture), image::load_pfm(one.reference), scale, one.error,
                         name_of(one.view),
                         one.unit() == course::Unit::degrees ? image::Unit::degrees : image::Unit::own);
}

}  // namespace texel::check
