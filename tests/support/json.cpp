// SPDX-License-Identifier: MIT
#include "json.hpp"

namespace texel::test {

nlohmann::json parse_json(const std::string& text) {
  return nlohmann::json::parse(text);
}

}  // namespace texel::test
