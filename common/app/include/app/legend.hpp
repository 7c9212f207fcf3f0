// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "course/case.hpp"
#include "image/image.hpp"
#include "params/set.hpp"

namespace texel::app {

/// The smallest of 1, 2 and 5 times a power of ten that is not below `value`: the end or the step of a scale.
/// 1 for 0.
double round_up(double value);

/// How the colours of a data view are read. Window, page and gallery draw it, each in its own type.
struct Legend {
  std::string title;  ///< what is shown, with its unit: "depth in units"; "" where there is nothing to say
  image::Image8 picture;  ///< RGB, bottom row first: a bar from left to right, a square or a ball
  bool is_ball = false;   ///< what lies outside of the circle is not meant
  std::vector<std::pair<double, std::string>> ticks;  ///< of a bar: places, 0 (left) to 1, and their values
};

/// Of an error from 0 to `full_scale`, in the colours of image::heat.
Legend error_legend(double full_scale, course::Unit unit);

/// Of another view, in the colours of shaders/app/present.frag. `values` are those of the view `lod` or
/// `depth`, RGBA with alpha 1 where the object is: the bar has the range that is there. The ball of
/// directions is seen by the camera of `parameters`, world space.
Legend legend_of(course::View view, params::Set& parameters, const image::ImageF& values);

/// {"title", "width", "height", "colors": RRGGBB of all pixels in a row, "ball", "ticks": [[place, text], …]}
std::string to_json(const Legend& legend);

}  // namespace texel::app
