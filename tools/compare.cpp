// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>

#include "commands.hpp"
#include "image/difference.hpp"
#include "image/flip.hpp"
#include "image/load.hpp"
#include "image/save.hpp"
#include "image/ssim.hpp"

namespace texel::tools {
namespace {

/// What only pictures of colours have.
struct Perceived {
  image::FlipFigures flip;
  double ssim = 0;
};

struct Comparison {
  image::Difference difference;
  std::string unit;  ///< "8-bit steps", "degrees", "texels" or "own unit"
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

void save_heatmap(const std::filesystem::path& file, const auto& make) {
  if (!file.empty()) image::save_png(file, make());
}

image::Unit unit_of(const std::string& name, const image::ImageF& reference) {
  if (name == "texels") return image::Unit::texels;
  const bool degrees = name == "degrees" || (name == "auto" && holds_directions(reference));
  return degrees ? image::Unit::degrees : image::Unit::own;
}

const char* name_of(image::Unit unit) {
  switch (unit) {
    case image::Unit::degrees:
      return "degrees";
    case image::Unit::texels:
      return "texels";
    case image::Unit::own:
      break;
  }
  return "own unit";
}

Comparison compare_floats(const CompareOptions& options, image::Comparing comparing) {
  const image::ImageF reference = image::load_pfm(options.reference), image = image::load_pfm(options.image);
  comparing.unit = unit_of(options.unit, reference);
  if (!options.texels.empty()) {
    comparing.texture_width = options.texels.front();
    comparing.texture_height = options.texels.back();
  }
  const image::Difference difference = image::compare(reference, image, comparing);
  save_heatmap(options.heatmap, [&] { return image::heatmap(reference, image, 0, comparing); });
  return {difference, name_of(comparing.unit), {}};
}

Comparison compare_colors(const CompareOptions& options, const image::Comparing& comparing) {
  const image::Image8 reference = image::load8(options.reference), image = image::load8(options.image);
  const image::Difference difference = image::compare(reference, image, comparing);
  const image::ImageF errors = image::flip_errors(
      reference, image, options.pixels_per_degree.value_or(image::default_pixels_per_degree));
  const Perceived perceived = {image::flip_figures(errors, comparing.mask),
                               image::ssim(reference, image, comparing.mask)};
  save_heatmap(options.heatmap, [&] { return image::heatmap(reference, image, 0, comparing); });
  save_heatmap(options.flip_heatmap, [&] { return image::flip_heatmap(errors, comparing.mask); });
  return {difference, "8-bit steps", perceived};
}

void print_json(const Comparison& result) {
  const image::Difference& d = result.difference;
  std::string flip_mean = "null", flip_p99 = "null", flip_quartiles = "null", ssim = "null";
  if (result.perceived) {
    const image::FlipFigures& flip = result.perceived->flip;
    flip_mean = fmt::format("{}", flip.mean);
    flip_p99 = fmt::format("{}", flip.p99);
    flip_quartiles = fmt::format("[{}, {}, {}]", flip.first_quartile, flip.median, flip.third_quartile);
    ssim = fmt::format("{}", result.perceived->ssim);
  }
  fmt::print(
      "{{\"width\": {}, \"height\": {}, \"max\": {}, \"mean\": {}, \"p99\": {}, \"flip_mean\": {}, "
      "\"flip_p99\": {}, \"ssim\": {}, \"non_finite\": {}, \"flip_weighted_quartiles\": {}, "
      "\"forgiven\": {}, \"unit\": \"{}\"}}\n",
      d.width, d.height, d.max, d.mean, d.p99, flip_mean, flip_p99, ssim, d.non_finite, flip_quartiles,
      d.forgiven, result.unit);
}

void print_text(const Comparison& result, bool edge_tolerance) {
  const image::Difference& d = result.difference;
  fmt::print("{}x{}, in {}\nmax         {:.6g}\nmean        {:.6g}\np99         {:.6g}\n", d.width, d.height,
             result.unit, d.max, d.mean, d.p99);
  if (result.perceived) {
    const auto& [flip, ssim] = *result.perceived;
    fmt::print("FLIP mean   {:.6g}\nFLIP p99    {:.6g}\nSSIM        {:.6g}\n", flip.mean, flip.p99, ssim);
  }
  fmt::print("non-finite  {} pixels\n", d.non_finite);
  if (edge_tolerance) fmt::print("forgiven    {} pixels at edges\n", d.forgiven);
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

void check_png(const char* option, const std::filesystem::path& file) {
  if (!file.empty() && file.extension() != ".png")
    throw Error::usage(fmt::format("{} cannot write '{}'", option, file.string()), "end the name in .png");
}

/// Throws Error (usage) for options that do not fit the files.
void check_options(const CompareOptions& options) {
  if (is_float(options.reference) != is_float(options.image))
    throw Error::failed("a .pfm cannot be compared with a colour picture", {options.image.string()},
                        "draw both in the same format");
  check_png("--heatmap", options.heatmap);
  check_png("--flip-heatmap", options.flip_heatmap);
  const bool asks_for_flip = options.flip || options.pixels_per_degree || !options.flip_heatmap.empty();
  if (is_float(options.reference) && asks_for_flip)
    throw Error::usage("FLIP compares colour pictures, not .pfm files",
                       "leave out --flip, --flip-heatmap and --ppd");
  if (!is_float(options.reference) && options.unit != "auto")
    throw Error::usage("--unit is for .pfm files", "leave it out");
  if ((options.unit == "texels") == options.texels.empty())
    throw Error::usage("--unit texels and --texels go together",
                       "give the texture's size, as in --unit texels --texels 512");
}

}  // namespace

Exit compare(const CompareOptions& options) {
  check_options(options);
  std::optional<image::Image8> mask;
  if (!options.mask.empty()) mask = image::load8(options.mask);
  const image::Comparing comparing = {.mask = mask ? &*mask : nullptr,
                                      .edge_tolerance = options.edge_tolerance};
  const Comparison result =
      is_float(options.reference) ? compare_floats(options, comparing) : compare_colors(options, comparing);
  if (options.json)
    print_json(result);
  else
    print_text(result, options.edge_tolerance);
  const bool any_limit = options.max || options.mean || options.p99 || options.flip;
  const bool same = any_limit || result.difference.max == 0;
  return within_limits(options, result) && same ? Exit::holds : Exit::differs;
}

}  // namespace texel::tools
