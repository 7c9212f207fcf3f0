// SPDX-License-Identifier: MIT
#include "judge/judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "core/plain_text.hpp"
#include "difference.hpp"
#include "image/difference.hpp"
#include "image/load.hpp"
#include "mesh/ply.hpp"

namespace texel::judge {
namespace {

using course::Case;
using course::Size;
using course::Unit;
using course::View;
using image::Image8;
using image::ImageF;

/// Of a case that is past its limit.
constexpr double kMostOfWrong = 0.5;

/// Four times what right pictures are moved against each other: data views by a GPU (NVIDIA's driver 580) are
/// those by llvmpipe moved by at most 1/256 of a pixel, but for one pixel in a thousand.
constexpr double kMovedPixels = 1.0 / 64;

Image8 parse_color(std::string_view bytes, const std::string& name, Size size) {
  return image::parse_png(bytes, name, size.width, size.height);
}

ImageF parse_data(std::string_view bytes, const std::string& name, Size size) {
  // A float picture is as large as its file; more than this is no picture of that size.
  const auto most = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height) * 12 + 100;
  if (bytes.size() > most) throw Error::failed("is larger than a picture of this size can be", {name});
  ImageF picture = image::parse_pfm(bytes, name);
  if (picture.width != size.width || picture.height != size.height)
    throw Error::failed(
        fmt::format("is {}x{} pixels, not {}x{}", picture.width, picture.height, size.width, size.height),
        {name});
  // As all data views are written; pictures of other channels cannot be compared.
  if (picture.channels != 3)
    throw Error::failed(fmt::format("has {} channel, not 3", picture.channels), {name});
  return picture;
}

/// Whether the mask is the same in the 3x3 pixels around one. Where the object's edge passes between others
/// is the rasteriser's choice: OpenGL leaves it how finely it rounds a vertex's place in the window.
bool is_inside(const Image8& mask, int x, int y) {
  for (int near_y = std::max(y - 1, 0); near_y <= std::min(y + 1, mask.height - 1); ++near_y)
    for (int near_x = std::max(x - 1, 0); near_x <= std::min(x + 1, mask.width - 1); ++near_x)
      if ((mask.at(near_x, near_y) > 127) != (mask.at(x, y) > 127)) return false;
  return true;
}

Verdict nothing_to_compare(std::string message) {
  return {false, 0, std::numeric_limits<double>::quiet_NaN(), std::move(message)};
}

Verdict unreadable(const std::string& name, const Error& error) {
  std::string text = error.what();
  if (text.starts_with(name + ": ")) text = text.substr(name.size() + 2);
  return nothing_to_compare(fmt::format("The {} {}", name, plain_text(text)));
}

/// A number with the digits that matter.
std::string short_number(double value) {
  return value >= 999.5 && value < 1e7 ? fmt::format("{:.0f}", value) : fmt::format("{:.3g}", value);
}

/// Whether a picture that can be read has no NaN and no infinity.
bool is_finite(const Case& of, std::string_view bytes) {
  if (of.view == View::color) return true;
  const ImageF picture = parse_data(bytes, "the reference", of.size);
  return std::ranges::all_of(picture.samples, [](float value) { return std::isfinite(value); });
}

template <class Picture>
Verdict judge_picture(const Case& of, const Expected& expected, std::string_view bytes,
                      Picture (*parse)(std::string_view, const std::string&, Size)) {
  const bool in_degrees = unit_of(of.view) == Unit::degrees;
  const Picture reference = parse(expected.reference, "the reference", of.size);
  Verdict verdict;
  Picture picture;
  try {
    picture = parse(bytes, "picture", of.size);
  } catch (const Error& error) {
    return unreadable("picture", error);
  }

  const long long non_finite = image::compare(reference, picture).non_finite;
  verdict.passed = non_finite == 0;
  std::string place;
  const Image8 mask = parse_color(expected.mask, "the mask", of.size);
  for (const bool is_object : {true, false}) {
    const Image8 part = part_of(mask, is_object);
    const auto in_part = std::ranges::count(part.samples, 255);
    if (in_part == 0) continue;
    const image::Difference difference = image::compare(
        reference, picture,
        {.mask = &part, .edge_tolerance = true, .moved_pixels = kMovedPixels, .in_degrees = in_degrees});
    if (difference.p999 > verdict.error || place.empty()) {
      verdict.error = std::max(verdict.error, difference.p999);
      const auto wrong = std::ranges::count_if(difference.pixels, [&](double off) { return off > of.limit; });
      const double share = 100.0 * static_cast<double>(wrong) / static_cast<double>(in_part);
      place = fmt::format("in {} % of the {}, as at the pixel {}, {} from the lower left",
                          share < 1 ? "less than 1" : fmt::format("{:.0f}", share),
                          is_object ? "object" : "background", difference.telling_x, difference.telling_y);
    }
    if (difference.p999 > of.limit) verdict.passed = false;
  }
  verdict.score = verdict.passed ? 1 : non_finite > 0 ? 0 : score(verdict.error / of.limit);
  if (verdict.passed) return verdict;
  verdict.message = non_finite > 0
                        ? fmt::format("{} pixels are not finite (NaN or infinity).", non_finite)
                        : fmt::format("Off by {} {} {}. At most {} is right.", short_number(verdict.error),
                                      name_of(unit_of(of.view)), place, short_number(of.limit));
  return verdict;
}

Verdict judge_stream(const Case& of, const Expected& expected, std::string_view bytes) {
  constexpr std::size_t most = 64U << 20U;
  mesh::Mesh reference = mesh::parse_ply(expected.reference, "the reference"), own;
  try {
    if (bytes.size() > most) throw Error::failed("is larger than 64 MiB", {"vertex stream"});
    own = mesh::parse_ply(bytes, "vertex stream");
  } catch (const Error& error) {
    return unreadable("vertex stream", error);
  }
  Verdict verdict = compare_streams(of.limit, std::move(reference), std::move(own));
  verdict.score = verdict.passed ? 1 : score(verdict.error / of.limit);
  return verdict;
}

}  // namespace

Image8 part_of(const Image8& mask, bool is_object) {
  Image8 part(mask.width, mask.height, 1);
  for (int y = 0; y < mask.height; ++y)
    for (int x = 0; x < mask.width; ++x)
      if ((mask.at(x, y) > 127) == is_object && is_inside(mask, x, y)) part.at(x, y) = 255;
  return part;
}

Verdict judge(const Case& of, const Expected& expected, std::optional<std::string_view> picture) {
  if (!picture) return nothing_to_compare("There is no picture.");
  if (of.is_mesh()) return judge_stream(of, expected, *picture);
  // Most right pictures have the same bytes.
  if (expected.reference == *picture && is_finite(of, *picture)) return {true, 1, 0, {}};
  if (of.view != View::color) return judge_picture(of, expected, *picture, parse_data);
  return judge_picture(of, expected, *picture, parse_color);
}

double score(double times_limit) {
  if (times_limit <= 1) return 1;
  if (!(times_limit < kNothingLeft)) return 0;
  return kMostOfWrong * (kNothingLeft - times_limit) / (kNothingLeft - 1);
}

}  // namespace texel::judge
