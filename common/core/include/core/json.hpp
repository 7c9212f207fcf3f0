// SPDX-License-Identifier: MIT
#pragma once
#include <nlohmann/json.hpp>
#include <string>

/// JSON as all of the course reads and writes it. Reader and writer are compiled once, in json.cpp: they take
/// two seconds in each file that has its own, and eight with the sanitizers.
namespace texel {

/// Keys stay in the order in which they are written.
using Json = nlohmann::ordered_json;

/// Throws Json::exception, which names the line and column.
Json parse_json(const std::string& text);

/// The same for a text that may be anything: null if it is no JSON.
Json json_or_null(const std::string& text);

/// With `indent` spaces a level; without, in one line. Bytes that are no UTF-8 become U+FFFD: a compiler's
/// message may quote any file.
std::string to_text(const Json& json, int indent = -1);

}  // namespace texel
