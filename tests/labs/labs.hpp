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
#include "core/json.hpp"
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

/// Draws the pictures from one process into `folder`. A failure, or anything that is said, fails the running
/// test.
void draw(const std::string& lab, const std::vector<Shot>& shots, const TemporaryFolder& folder);

/// The float pictures of the shots, whose names need no ".pfm", by name; drawn from one process.
using Pictures = std::map<std::string, image::ImageF>;
Pictures float_pictures(const std::string& lab, std::vector<Shot> shots);
/// The settings as flags of the command line.
std::string flags(const Settings& settings);

bool has_parameter(const std::string& lab, const std::string& name);
/// What --stats - prints of a look.
Json stats_of(const std::string& lab, const std::string& arguments = {});

}  // namespace texel::test
