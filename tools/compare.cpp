// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>

#include "commands.hpp"
#include "image/difference.hpp"
#include "image/load.hpp"
#include "image/save.hpp"

namespace texel::tools {
namespace {

struct Comparison {
  image::Difference difference;
  std::string unit;  ///< "8-bit steps", "degrees" or "own unit"
};

bool is_float(const std::filesystem::path& file) {
  return file.extension() == ".pfm";
}

/// Whether a float picture is a view of directions: unit vectors, and zero where there is no object.
bool holds_directions(const image::ImageF& picture) {
  constexpr double kTolerance = 1e-3;  // float targets keep 24 bits, 16-bit ones 11
  if (picture.channels < 3) return false;
  bool any = false;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const double length =
          std::hypot(static_cast<double>(picture.at(x, y, 0)), static_cast<double>(picture.at(x, y, 1)),
                     static_cast<double>(picture.at(x, y, 2)));
      if (!std::isfinite(length) || length == 0) continue;
      if (std::abs(length - 1) > kTolerance) return false;
      any = true;
    }
  return any;
}

void save_heatmap(const CompareOptions& options, const auto& make) {
  if (!options.heatmap.empty()) image::save_png(options.heatmap, make());
}

Comparison compare_floats(const CompareOptions& options, const image::Image8* mask) {
  const image::ImageF reference = image::load_pfm(options.reference), image = image::load_pfm(options.image);
  const bool degrees = options.unit == "degrees" || (options.unit == "auto" && holds_directions(reference));
  const image::Unit unit = degrees ? image::Unit::degrees : image::Unit::own;
  const image::Difference difference = image::compare(reference, image, unit, mask);
  save_heatmap(options, [&] { return image::heatmap(reference, image, unit, 0, mask); });
  return {difference, degrees ? "degrees" : "own unit"};
}

Comparison compare_colours(const CompareOptions& options, const image::Image8* mask) {
  const image::Image8 reference = image::load8(options.reference), image = image::load8(options.image);
  const image::Difference difference = image::compare(reference, image, mask);
  save_heatmap(options, [&] { return image::heatmap(reference, image, 0, mask); });
  return {difference, "8-bit steps"};
}

void print_json(const Comparison& result) {
  const image::Difference& d = result.difference;
  fmt::print(
      "{{\"width\": {}, \"height\": {}, \"max\": {}, \"mean\": {}, \"p99\": {}, \"non_finite\": {}, "
      "\"unit\": \"{}\"}}\n",
      d.width, d.height, d.max, d.mean, d.p99, d.non_finite, result.unit);
}

void print_text(const Comparison& result) {
  const image::Difference& d = result.difference;
  fmt::print(
      "{}x{}, in {}\nmax         {:.6g}\nmean        {:.6g}\np99         {:.6g}\nnon-finite  {} pixels\n",
      d.width, d.height, result.unit, d.max, d.mean, d.p99, d.non_finite);
}

/// Says on standard error which limits are passed.
bool within_limits(const CompareOptions& options, const image::Difference& d) {
  bool within = true;
  const auto check = [&](const char* name, double value, const std::optional<double>& limit) {
    if (!limit || value <= *limit) return;
    fmt::print(stderr, "texel: {} is {:.6g}, over the limit {:.6g}\n", name, value, *limit);
    within = false;
  };
  check("max", d.max, options.max);
  check("mean", d.mean, options.mean);
  check("p99", d.p99, options.p99);
  if (d.non_finite > 0) fmt::print(stderr, "texel: {} pixels are NaN or infinite\n", d.non_finite);
  return within && d.non_finite == 0;
}

}  // namespace

Exit compare(const CompareOptions& options) {
  if (is_float(options.reference) != is_float(options.image))
    throw Error::failed("a .pfm cannot be compared with a picture of colours", {options.image.string()},
                        "draw both in the same format");
  if (!options.heatmap.empty() && options.heatmap.extension() != ".png")
    throw Error::usage(fmt::format("--heatmap cannot write '{}'", options.heatmap.string()),
                       "end the name in .png");
  std::optional<image::Image8> mask;
  if (!options.mask.empty()) mask = image::load8(options.mask);
  const image::Image8* mask_or_none = mask ? &*mask : nullptr;
  const Comparison result = is_float(options.reference) ? compare_floats(options, mask_or_none)
                                                        : compare_colours(options, mask_or_none);
  if (options.json)
    print_json(result);
  else
    print_text(result);
  const bool any_limit = options.max || options.mean || options.p99;
  const bool same = any_limit || result.difference.max == 0;
  return within_limits(options, result.difference) && same ? Exit::holds : Exit::differs;
}

}  // namespace texel::tools
