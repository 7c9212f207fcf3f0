// SPDX-License-Identifier: MIT
// The labs' programs, and what a test asks of any of them.
#pragma once
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "../support/picture_files.hpp"
#include "../support/places.hpp"
#include "../support/process.hpp"
#include "../support/said.hpp"
#include "image/image.hpp"

namespace texel::test {

/// Their names in order, from labs/CMakeLists.txt.
inline constexpr const char* kLabs[] = {TEXEL_LABS};
static_assert(std::size(kLabs) >= 9, "a lab is missing");

/// A suite that runs once for each lab; GetParam() is the program's name.
class EveryLab : public testing::TestWithParam<const char*> {
 protected:
  [[nodiscard]] static std::string lab() { return GetParam(); }
  /// Of this test alone, gone when it ends.
  TemporaryFolder folder_{unique_name()};

 private:
  static std::string unique_name();
};

/// INSTANTIATE_TEST_SUITE_P's arguments after the suite.
inline const auto each_lab = testing::ValuesIn(kLabs);
inline std::string lab_name(const testing::TestParamInfo<const char*>& lab) {
  return std::string(lab.param).substr(0, 5);
}

/// Runs a lab without Mesa's shader cache, which would keep what earlier runs compiled. `before` stands
/// before the program's name: variables, or "cd / &&".
Result run_lab(const std::string& lab, const std::string& arguments, const std::string& before = {});

using Settings = std::vector<std::pair<std::string, std::string>>;

/// Both, the later ones counting where both name a parameter.
Settings operator+(Settings first, const Settings& then);

/// One picture of a batch.
struct Shot {
  std::string name;  ///< the file; .png is added unless it ends in .pfm
  Settings values = {};
  std::string view = "color";
  std::string size = "128x128";
};

/// Draws the pictures from one process into `folder`.
Result run_batch(const std::string& lab, const std::vector<Shot>& shots, const TemporaryFolder& folder,
                 const std::string& arguments = {}, const std::string& before = {});

/// The same; a failure, or anything that is said, fails the running test.
void draw(const std::string& lab, const std::vector<Shot>& shots, const TemporaryFolder& folder,
          const std::string& arguments = {}, const std::string& before = {});

/// The float pictures of the shots, whose names need no ".pfm", by name; drawn from one process.
using Pictures = std::map<std::string, image::ImageF>;
Pictures float_pictures(const std::string& lab, std::vector<Shot> shots);
/// The settings as flags of the command line.
std::string flags(const Settings& settings);

/// What --list-parameters --json says of a parameter.
struct Parameter {
  std::string name, type, initial, unit, help;
  double least = 0, most = 0;
  std::vector<std::string> choices;
  [[nodiscard]] std::string flag() const;
};
std::vector<Parameter> parameters_of(const std::string& lab);
bool has_parameter(const std::string& lab, const std::string& name);

/// What --stats - prints of a look.
struct Stats {
  std::string lab, renderer, version;
  double vertices = 0, triangles = 0, draw_calls = 0, peak_bytes = 0;
  std::vector<std::string> attributes, textures, notes, warnings;
  std::map<std::string, double> stages;  ///< milliseconds
};
Stats stats_of(const std::string& lab, const std::string& arguments = {});

}  // namespace texel::test
