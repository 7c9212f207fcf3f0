// SPDX-License-Identifier: MIT
#pragma once
#include <map>
#include <string>

#include "core/json.hpp"
#include "embedded.hpp"
#include "pictures.hpp"
#include "store/class_results.hpp"

/// The pages of the report. Each holds its data as JSON, and a script that shows them.
namespace texel::reports {

/// A whole page. It may load nothing and run nothing but its own style and script, whatever its data say:
/// Content-Security-Policy with their hashes. The data's texts are cleaned; the script escapes them.
std::string page(const std::string& title, const Json& data, const Embedded& script);

/// What both kinds of page show of a step: how it stands, its points, and the mistake that it looks like.
Json step_data(const judge::StepResult& step);

/// A mistake's title and the rest of its sentence; null where no mistake is known.
Json mistake_data(const std::string& name, const std::string& says);

std::string class_page(const store::ClassResult& results);
std::string student_page(const store::StudentResult& student, const std::map<std::string, std::string>& facts,
                         Pictures& pictures);

}  // namespace texel::reports
