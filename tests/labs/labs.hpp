// SPDX-License-Identifier: MIT
// The labs' programs, and the pictures that a test has them draw.
#pragma once
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "../support/picture_files.hpp"
#include "image/image.hpp"

namespace texel::test {

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
/// The settings as flags of the command line, for messages.
std::string flags(const Settings& settings);

}  // namespace texel::test
