// SPDX-License-Identifier: MIT
#include "judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <optional>

#include "core/error.hpp"
#include "image/difference.hpp"
#include "image/flip.hpp"
#include "image/load.hpp"
#include "judge_mesh.hpp"
#include "text.hpp"

namespace texel::grade {
namespace {

namespace fs = std::filesystem;
using image::Image8;
using image::ImageF;

/// A mean error that makes a picture useless, where the starter's own is not below it. Set by the pictures of
/// tests/unit/grade_judge_test.cpp: a mirrored picture of bricks has FLIP 0.25 to 0.4 over the object, one
/// shifted by a pixel 0.05 to 0.1, one brighter by 5 steps 0.1.
constexpr double kUselessFlip = 0.25;
constexpr double kUselessSteps = 40;
/// The score of a picture that is nearly right.
constexpr double kMostOfWrong = 0.95;

double useless_mean(const std::string& unit) {
  if (unit == "degrees") return 40;
  if (unit == "levels") return 2;
  if (unit == "texture widths") return 0.25;
  return std::numeric_limits<double>::infinity();  // distances: as far off as the starter's
}

image::Unit compared_as(const std::string& view) {
  return unit_of(view) == "degrees" ? image::Unit::degrees : image::Unit::own;
}

struct Size {
  int width = 0, height = 0;
};

Size size_of(const Shot& shot) {
  Size size;
  if (std::sscanf(shot.graded.size.c_str(), "%dx%d", &size.width, &size.height) != 2)
    throw Error::failed(fmt::format("case '{}' has no size", shot.graded.name));
  return size;
}

Image8 load(const fs::path& file, Size size, const Image8*) {
  return image::load_png(file, size.width, size.height);
}

ImageF load(const fs::path& file, Size size, const ImageF*) {
  // A float picture is as large as its file; more than this is no picture of that size.
  const auto most = static_cast<std::uintmax_t>(size.width) * static_cast<std::uintmax_t>(size.height) * 12 + 100;
  if (fs::file_size(file) > most) throw Error::failed("is larger than a picture of the size asked for", {file.string()});
  ImageF picture = image::load_pfm(file);
  if (picture.width != size.width || picture.height != size.height)
    throw Error::failed(fmt::format("is {}x{} pixels, not {}x{}", picture.width, picture.height, size.width,
                                    size.height),
                        {file.string()});
  return picture;
}

/// One part of the picture: the object or the background.
struct Part {
  const char* name;
  Image8 mask;
  bool any = false;
};

std::vector<Part> parts_of(const fs::path& mask_file, Size size) {
  const Image8 mask = image::load_png(mask_file, size.width, size.height);
  std::vector<Part> parts = {{"object", Image8(size.width, size.height, 1)},
                             {"background", Image8(size.width, size.height, 1)}};
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) {
      Part& part = parts[mask.at(x, y) > 127 ? 0 : 1];
      part.mask.at(x, y) = 255;
      part.any = true;
    }
  parts.erase(std::remove_if(parts.begin(), parts.end(), [](const Part& part) { return !part.any; }), parts.end());
  return parts;
}

/// The mean errors of a picture over a part, each as a share of what makes it useless.
std::vector<double> mean_errors(const Image8& reference, const Image8& picture, const Part& part,
                                const std::string&) {
  const double flip = image::flip_figures(image::flip_errors(reference, picture), &part.mask).mean;
  const double steps = image::compare(reference, picture, {.mask = &part.mask, .edge_tolerance = true}).mean;
  return {flip / kUselessFlip, steps / kUselessSteps};
}

std::vector<double> mean_errors(const ImageF& reference, const ImageF& picture, const Part& part,
                                const std::string& view) {
  const image::Difference difference =
      image::compare(reference, picture, {.mask = &part.mask, .edge_tolerance = true, .unit = compared_as(view)});
  if (difference.non_finite > 0) return {1};
  const double useless = useless_mean(unit_of(view));
  return {std::isfinite(useless) ? difference.mean / useless : difference.mean};
}

/// 1 without an error, 0 with the starter's or a useless one.
double share_of_right(const std::vector<double>& errors, const std::vector<double>& starter, bool is_bounded) {
  double score = 1;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    double most = is_bounded ? 1 : std::numeric_limits<double>::infinity();
    if (i < starter.size()) most = std::min(most, starter[i]);
    if (errors[i] > 0) score = std::min(score, most > 0 && std::isfinite(most) ? 1 - errors[i] / most : 0);
  }
  return std::clamp(score, 0.0, 1.0);
}

std::string where(const image::Difference& difference) {
  const char* column = 3 * difference.worst_x < difference.width         ? "left"
                       : 3 * difference.worst_x < 2 * difference.width ? "middle"
                                                                         : "right";
  const char* row = 3 * difference.worst_y < difference.height         ? "lower"
                    : 3 * difference.worst_y < 2 * difference.height ? "centre"
                                                                       : "upper";
  return fmt::format("worst at pixel {}, {} from the lower left ({} {})", difference.worst_x, difference.worst_y,
                     row, column);
}

/// A number with the digits that matter.
std::string short_number(double value) {
  return fmt::format("{:.3g}", value);
}

template <class Picture>
Verdict judge_picture(const Shot& shot, const Expected& expected, const fs::path& file) {
  const Size size = size_of(shot);
  const std::string& view = shot.graded.view;
  const auto reference = load(expected.reference, size, static_cast<Picture*>(nullptr));
  Verdict verdict;
  Picture picture;
  try {
    picture = load(file, size, static_cast<Picture*>(nullptr));
  } catch (const Error& error) {
    // Its text begins with the place, which is no business of the student's.
    std::string text = error.what();
    if (text.starts_with(file.string())) text = text.substr(std::min(text.size(), file.string().size() + 2));
    verdict.error = std::numeric_limits<double>::quiet_NaN();
    verdict.message = "the picture " + plain_text(text);
    return verdict;
  }
  std::optional<Picture> starter;
  if (!expected.starter.empty() && fs::exists(expected.starter))
    starter = load(expected.starter, size, static_cast<Picture*>(nullptr));

  verdict.passed = true;
  verdict.score = 1;
  long long non_finite = 0;
  std::string worst;
  for (const Part& part : parts_of(expected.mask, size)) {
    const image::Difference difference = image::compare(
        reference, picture, {.mask = &part.mask, .edge_tolerance = true, .unit = compared_as(view)});
    non_finite += difference.non_finite;
    if (difference.p999 > verdict.error || worst.empty()) {
      verdict.error = std::max(verdict.error, difference.p999);
      worst = fmt::format("{} in the {}", where(difference), part.name);
    }
    if (difference.p999 <= shot.graded.limit && difference.non_finite == 0) continue;
    verdict.passed = false;
    const std::vector<double> errors = mean_errors(reference, picture, part, view);
    const std::vector<double> own = starter ? mean_errors(reference, *starter, part, view) : std::vector<double>();
    const bool is_bounded = view == "color" || std::isfinite(useless_mean(unit_of(view)));
    verdict.score = std::min(verdict.score, share_of_right(errors, own, is_bounded));
  }
  if (verdict.passed) return verdict;
  verdict.score = std::min(verdict.score, kMostOfWrong);
  if (non_finite > 0) {
    verdict.score = 0;
    verdict.message = fmt::format("{} pixels are not finite (NaN or infinity)", non_finite);
  } else {
    verdict.message = fmt::format("off by {} {} where {} is the limit; {}", short_number(verdict.error),
                                  unit_of(view), short_number(shot.graded.limit), worst);
  }
  return verdict;
}

template <class Picture>
bool is_same(const Shot& shot, const fs::path& a_file, const fs::path& b_file) {
  const Size size = size_of(shot);
  const auto a = load(a_file, size, static_cast<Picture*>(nullptr));
  const auto b = load(b_file, size, static_cast<Picture*>(nullptr));
  const image::Difference difference =
      image::compare(a, b, {.edge_tolerance = true, .unit = compared_as(shot.graded.view)});
  return difference.p999 <= shot.graded.limit && difference.non_finite == 0;
}

}  // namespace

std::string unit_of(const std::string& view) {
  if (view == "color") return "steps";
  if (view == "normal" || view == "tangent" || view == "direction" || view == "mesh") return "degrees";
  if (view == "lod") return "levels";
  if (view == "texcoord") return "texture widths";
  return "units";
}

Verdict judge(const Shot& shot, const Expected& expected, const fs::path& picture) {
  if (!fs::is_regular_file(fs::symlink_status(picture))) {
    Verdict verdict;
    verdict.error = std::numeric_limits<double>::quiet_NaN();
    verdict.message = "there is no picture";
    return verdict;
  }
  if (shot.is_mesh()) return judge_mesh(shot.graded.limit, expected.reference, expected.starter, picture);
  return shot.graded.view == "color" ? judge_picture<Image8>(shot, expected, picture)
                                     : judge_picture<ImageF>(shot, expected, picture);
}

bool looks_like(const Shot& shot, const Expected& expected, const fs::path& picture) {
  try {
    if (shot.is_mesh()) return judge_mesh(shot.graded.limit, expected.reference, {}, picture).passed;
    return shot.graded.view == "color" ? is_same<Image8>(shot, expected.reference, picture)
                                       : is_same<ImageF>(shot, expected.reference, picture);
  } catch (const Error&) {
    return false;
  }
}

}  // namespace texel::grade
