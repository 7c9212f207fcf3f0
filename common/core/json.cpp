// SPDX-License-Identifier: MIT
#include "core/json.hpp"

namespace texel {

Json parse_json(const std::string& text) {
  return Json::parse(text);
}

Json json_or_null(const std::string& text) {
  const Json json = Json::parse(text, nullptr, false);
  return json.is_discarded() ? Json() : json;
}

std::string to_text(const Json& json, int indent) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace texel
