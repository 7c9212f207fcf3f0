// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "course/setting.hpp"

/// What a student writes, and the pictures that judge it: the tables [[step]] and [[case]] of a lab.toml.
///
///     [[step]]
///     id = "5.1"                                    # as the markers in the sources have it
///     title = "Decode the map's colour"
///     points = 2
///     needs = ["1.3", "4.2"]                        # optional: earlier steps, of earlier labs too, without
///                                                   # which this one cannot be seen
///     hints = ["A vague one", "A plain one"]        # one to three
///     [[case]]
///     name = "decode_bump"                          # unique in the lab
///     step = "5.1"
///     set = { normal_map = "bump" }                 # optional
///     view = "normal"                               # a view, or "mesh" for the vertex stream of --mesh
///     size = "128x128"                              # optional; not for meshes
///     limit = 0.2                                   # full marks up to this difference, in the view's unit
///     why = "0.05 between OSMesa and EGL"           # where the limit comes from
///     hidden = { turn = [-180, 180], normal_map = ["brick", "wood"] }   # optional
///
/// A hidden parameter has a value that students cannot know, drawn from the course's secret seed: a
/// number between two, or one of several words.
namespace texel::course {

struct Step {
  std::string id, title;
  double points = 1;
  std::vector<std::string> needs;  ///< earlier steps, of this lab or an earlier one
  std::vector<std::string> hints;
};

/// A parameter whose value is drawn from the secret seed.
struct Hidden {
  std::string parameter;
  double least = 0, most = 0;       ///< between these, or
  std::vector<std::string> values;  ///< one of these
};

/// A picture (or vertex stream) of the student's beside the solution's.
struct GradedCase {
  std::string name, step;
  std::vector<Setting> settings;
  std::string view = "color";
  std::string size = "128x128";
  double limit = 0;
  std::string why;
  std::vector<Hidden> hidden;
};

}  // namespace texel::course
