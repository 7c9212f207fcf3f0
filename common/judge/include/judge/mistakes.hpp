// SPDX-License-Identifier: MIT
// What known mistakes look like, in a few samples of their pictures: so that a student's tree can name a
// mistake without holding the catalogue, in which the solutions can be read.
#pragma once
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "course/lab_file.hpp"

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

/// Digits of samples that are kept: float32 has seven, the limits need four.
constexpr double kSampleDigits = 1e5;

/// The values of all pixels or vertices of a file.
struct Values {
  std::size_t count = 0, each = 0;
  std::vector<double> all;

  [[nodiscard]] std::span<const double> at(std::size_t index) const {
    return std::span(all).subspan(index * each, each);
  }
};

/// Of bytes that may be anything; nothing when they are no picture of the case.
Values parse_values(const course::Case& of, std::string_view bytes);
/// How far two values of the case may be apart: its limit, of directions as the length of the chord.
double tolerance(const course::Case& of);
/// Whether no value is further from the other than `most`, and the same are not finite.
bool are_same(std::span<const double> a, std::span<const double> b, double most);

/// What was drawn in a case and is wrong, or why nothing was.
struct Failed {
  std::string picture;         ///< the file's bytes, or ""
  std::string refused;         ///< Drawn::refused
  std::string reference = {};  ///< the expected file's bytes
  std::string mask = {};       ///< and its mask's; none for meshes
  bool is_secret = false;  ///< no numbers of the picture may be told: it was drawn beside the solution's text
};

/// What a failed case shows.
struct Seen {
  std::string mistake;  ///< the catalogue's name, or "" where it has none
  std::string says;     ///< the sentence, or ""
};

/// What the failed cases of a step show, by case. First the mistake of the catalogue that shows in all of
/// them; then what makes all of their pictures of the expected ones; then for each case what it shows itself,
/// by the catalogue or by its values, after the case's name. Of two explanations that fit alike both are
/// said, of more none. A case of which nothing is known is left out.
std::map<std::string, Seen> explain(const std::vector<Mistake>& mistakes, const course::Lab& lab,
                                    const std::string& step, const std::map<std::string, Failed>& failed);

/// A lab's mistakes from a file that material::to_json wrote. Throws Error (exit 3) with its name when it is
/// broken.
std::vector<Mistake> parse_mistakes(const std::string& text, const std::string& name);

}  // namespace texel::judge
