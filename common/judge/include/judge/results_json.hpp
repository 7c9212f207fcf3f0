// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "judge/results.hpp"

namespace texel::judge {

/// A lab's results as `texel check --json` prints them: {"lab", "title", "steps": [{"id", "status", "error",
/// "unit", "limit", "message", …, "cases": [{"name", "status", "view", "set", …}]}]}. A step's error is that
/// of its clearest_case.
std::string to_json(const LabResult& lab);
/// Of several labs, a list.
std::string to_json(const std::vector<LabResult>& labs);

/// The steps of one lab's results. Throws Error (exit 3) for any other text.
std::vector<StepResult> parse_steps(const std::string& json);

}  // namespace texel::judge
