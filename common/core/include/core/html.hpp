// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>

namespace texel {

/// Text escaped for HTML or XML, for elements and for attributes in quotes.
std::string html_escaped(std::string_view text);

}  // namespace texel
