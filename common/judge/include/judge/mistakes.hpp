// SPDX-License-Identifier: MIT
// What known mistakes look like, in a few samples of their pictures: so that a student's tree can name a
// mistake without holding the catalogue, in which the solutions can be read.
#pragma once
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "judge/plan.hpp"

namespace texel::judge {

/// Some of the values of a picture or vertex stream: of pixels, row by row from the bottom, or of vertices.
struct Samples {
  std::string refused;    ///< where the program refuses to draw (Drawn::refused): then there are no samples
  std::size_t count = 0;  ///< of all pixels or vertices
  struct Sample {
    std::size_t index = 0;
    std::vector<double> values;  ///< RGB; or position, normal, texcoord, tangent, those that there are
  };
  std::vector<Sample> samples;
};

/// A mistake and its pictures, by case; only of cases in which it is not right.
struct Mistake {
  std::string name, step, says;
  std::map<std::string, Samples> cases;
};

/// Samples of the picture `wrong`: most from where it differs from `reference` by more than the case's limit,
/// the others from where it does not. None when it differs nowhere, or is no picture. Both are a file's
/// bytes.
Samples sampled(const course::Case& of, std::string_view reference, std::string_view wrong);

/// What was drawn in a case and is wrong, or why nothing was.
struct Failed {
  std::string picture;  ///< the file's bytes, or ""
  std::string refused;  ///< Drawn::refused
};

/// The mistake of the step that has most of what all its failed cases show, and fails no others; or none.
const Mistake* recognize(const std::vector<Mistake>& mistakes, const LabPlan& plan, const std::string& step,
                         const std::map<std::string, Failed>& failed);

/// A lab's mistakes as a file. Reading throws Error (exit 3) with its name when it is broken.
std::string to_json(const std::vector<Mistake>& mistakes);
std::vector<Mistake> parse_mistakes(const std::string& text, const std::string& name);

}  // namespace texel::judge
