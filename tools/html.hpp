// SPDX-License-Identifier: MIT
#pragma once
#include <string>

namespace texel::tools {

/// Text as it stands in HTML, within elements and within attributes in double quotes.
std::string escaped(const std::string& text);

}  // namespace texel::tools
