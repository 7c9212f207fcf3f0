// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>

#include "course_commands.hpp"
#include "image/difference.hpp"
#include "image/load.hpp"
#include "image/save.hpp"
#include "perception/perception.hpp"

namespace texel::commands {
namespace {

/// What only pictures of colours have.
struct Perceived {
  perception::FlipFigures flip;
  double ssim = 0;
};

struct Comparison {
  image::Difference difference;
  std::string unit;  ///< "8-bit steps", "degrees" or "own unit"
  std::optional<Perceived> perceived;
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

Comparison compare_floats(const CompareOptions& options, image::Comparing comparing) {
  const image::ImageF reference = image::load_pfm(options.reference), image = image::load_pfm(options.image);
  comparing.in_degrees = holds_directions(reference);
  return {image::compare(reference, image, comparing), comparing.in_degrees ? "degrees" : "own unit", {}};
}

Comparison compare_colors(const CompareOptions& options, const image::Comparing& comparing) {
  const image::Image8 reference = image::load8(options.reference), image = image::load8(options.image);
  const image::Difference difference = image::compare(reference, image, comparing);
  const Perceived perceived = {
      perception::flip_figures(perception::flip_errors(reference, image), comparing.mask),
      perception::ssim(reference, image, comparing.mask)};
  return {difference, "8-bit steps", perceived};
}

void print_json(const Comparison& result) {
  const image::Difference& d = result.difference;
  const auto& [flip, ssim] = result.perceived.value_or(Perceived());
  const auto number = [&](double figure) { return result.perceived ? fmt::format("{}", figure) : "null"; };
  fmt::print(
      "{{\"width\": {}, \"height\": {}, \"max\": {}, \"mean\": {}, \"p99\": {}, \"flip_mean\": {}, "
      "\"flip_p99\": {}, \"ssim\": {}, \"non_finite\": {}, \"unit\": \"{}\"}}\n",
      d.width, d.height, d.max, d.mean, d.p99, number(flip.mean), number(flip.p99), number(ssim),
      d.non_finite, result.unit);
}

void print_text(const Comparison& result) {
  const image::Difference& d = result.difference;
  fmt::print("{}x{}, in {}\nmax         {:.6g}\nmean        {:.6g}\np99         {:.6g}\n", d.width, d.height,
             result.unit, d.max, d.mean, d.p99);
  if (result.perceived) {
    const auto& [flip, ssim] = *result.perceived;
    fmt::print("FLIP mean   {:.6g}\nFLIP p99    {:.6g}\nSSIM        {:.6g}\n", flip.mean, flip.p99, ssim);
  }
  fmt::print("non-finite  {} pixels\n", d.non_finite);
}

/// Says on standard error which limits are passed.
bool within_limits(const CompareOptions& options, const Comparison& result) {
  bool within = true;
  const auto check = [&](const char* name, double value, const std::optional<double>& limit) {
    if (!limit || value <= *limit) return;
    fmt::print(stderr, "texel: {} is {:.6g}, over the limit {:.6g}\n", name, value, *limit);
    within = false;
  };
  const image::Difference& d = result.difference;
  check("max", d.max, options.max);
  check("mean", d.mean, options.mean);
  check("p99", d.p99, options.p99);
  if (result.perceived) check("flip", result.perceived->flip.mean, options.flip);
  if (d.non_finite > 0) fmt::print(stderr, "texel: {} pixels are NaN or infinite\n", d.non_finite);
  return within && d.non_finite == 0;
}

/// Throws Error (usage) for options that do not fit the files.
void check_options(const CompareOptions& options) {
  if (is_float(options.reference) != is_float(options.image))
    throw Error::failed("a .pfm cannot be compared with a colour picture", {options.image.string()},
                        "draw both in the same format");
  if (!options.heatmap.empty() && options.heatmap.extension() != ".png")
    throw Error::usage(fmt::format("--heatmap cannot write '{}'", options.heatmap.string()),
                       "end the name in .png");
  if (is_float(options.reference) && options.flip)
    throw Error::usage("FLIP compares colour pictures, not .pfm files", "leave out --flip");
}

}  // namespace

Exit compare(const CompareOptions& options) {
  check_options(options);
  std::optional<image::Image8> mask;
  if (!options.mask.empty()) mask = image::load8(options.mask);
  const image::Comparing comparing = {.mask = mask ? &*mask : nullptr};
  const Comparison result =
      is_float(options.reference) ? compare_floats(options, comparing) : compare_colors(options, comparing);
  if (!options.heatmap.empty()) image::save_png(options.heatmap, image::heatmap(result.difference));
  if (options.json)
    print_json(result);
  else
    print_text(result);
  const bool any_limit = options.max || options.mean || options.p99 || options.flip;
  const bool same = any_limit || result.difference.max == 0;
  return within_limits(options, result) && same ? Exit::holds : Exit::differs;
}

}  // namespace texel::commands
