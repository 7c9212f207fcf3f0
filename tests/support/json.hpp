// SPDX-License-Identifier: MIT
#pragma once
#include <nlohmann/json.hpp>
#include <string>

namespace texel::test {

/// A text as JSON. Throws nlohmann::json::exception. In one file for all tests: the parser takes a second to
/// compile, and eight with the sanitizers.
nlohmann::json parse_json(const std::string& text);

}  // namespace texel::test
