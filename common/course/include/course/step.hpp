// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "course/case.hpp"

/// What a student writes, and the pictures that judge it: the tables [[step]] and [[case]] of a lab.toml.
///
///     [[step]]
///     id = "5.1"                                    # as the markers in the sources have it
///     title = "Decode the map's colour"
///     points = 2
///     needs = ["1.3", "4.2"]                        # optional: earlier steps, of earlier labs too, without
///                                                   # which this one cannot be seen
///     hints = ["A vague one", "A plain one"]        # one to three
///     set = { normal_map = "bump" }                 # optional: the look in which one sees the step, for the
///     view = "normal"                               # handout's line "See it" and its picture
///     seen_with = ["5.5"]                           # optional: later steps that are solved in the picture
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
  Case see = {};                            ///< the look in which one sees it: its settings and view
  std::vector<std::string> seen_with = {};  ///< later steps of this lab, without which one does not see it
};

/// A parameter whose value is drawn from the secret seed.
struct Hidden {
  std::string parameter;
  double least = 0, most = 0;       ///< between these, or
  std::vector<std::string> values;  ///< one of these
};

/// A model that nobody has seen, made from the seed: the value `unseen:polygons` of a parameter.
inline constexpr const char* kUnseen = "unseen:";

/// A picture (or vertex stream) of the student's beside the solution's.
struct GradedCase : Case {
  std::string why;                      ///< where the limit comes from
  std::vector<Hidden> hidden_settings;  ///< what is drawn for it
};

}  // namespace texel::course
