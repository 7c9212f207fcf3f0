// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "check/check.hpp"

namespace texel::tools {

/// The student's own tree and its build.
check::OwnTree own_tree();

/// What `grade::check` finds in it. Where that takes long, as with a loop that never ends, a line on the
/// terminal says that it goes on. Errors as grade::check.
std::vector<judge::LabResult> checked(const std::vector<course::Lab>& labs, const std::string& context);

}  // namespace texel::tools
