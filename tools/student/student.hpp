// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "check/check.hpp"
#include "report.hpp"

namespace texel::tools {

/// The student's own tree and its build.
check::OwnTree own_tree();

/// What check::check finds in it. Where that takes long, as with a loop that never ends, a line on the
/// terminal says that it goes on. Errors as check::check.
std::vector<judge::LabResult> checked(const std::vector<course::Lab>& labs, const std::string& context);

/// The step's hints that were shown before and one more, as text. The build remembers how many. Throws Error
/// (exit 3) when it cannot.
std::string next_hint(const course::Step& step);

}  // namespace texel::tools
