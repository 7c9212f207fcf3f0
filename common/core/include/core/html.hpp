// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>

namespace texel {

/// Text as it stands in HTML or XML, within elements and within attributes in quotes.
std::string html_escaped(std::string_view text);

}  // namespace texel
