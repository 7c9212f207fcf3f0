// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "store/class_results.hpp"

/// What all reports say in the same words, and how text is made harmless for each of them.
namespace texel::reports {

/// Text of any origin as it can be shown: lines stay lines, a tab becomes two spaces, and what else cannot be
/// shown U+FFFD. Still to be escaped.
std::string clean(std::string_view text);

/// At most so many bytes of a text, cut between characters, with a remark where something was left out.
std::string shortened(const std::string& text, std::size_t bytes);

/// Cleaned text as it stands in HTML or XML, within elements and within quoted attributes.
std::string escaped(std::string_view text);

std::string base64(std::string_view bytes);

/// A number with at most so many decimals, without zeros at its end: "2.5".
std::string number(double value, int decimals = 2);

/// "1 case", "2 cases".
std::string counted(std::size_t count, const std::string& what);

/// "This looks like: Green is inverted: …", or "" where no mistake is known.
std::string cause(const std::string& says);

/// The hint that fits a step that is not right: the first where it is not begun; else the one of its first
/// wrong case (Step::hint_of); else the plainest where some cases are right, or the second. "" for none.
std::string hint(const judge::StepResult& step);

/// How far off a case is, in its unit: "12.3 degrees off; full marks up to 0.2", or "judged alone, 12.3
/// degrees off; …". "" where nothing could be compared.
std::string distance(const judge::CaseResult& result);

/// What a step's mark is of, where it is not simply that of the student's tree: "5.5 is right: with 5.1
/// mended it has full marks.", or "".
std::string judging(const judge::StepResult& step);

/// Where a step is written: "labs/05_normal_map/lab.cpp:42", or "".
std::string place(const judge::StepResult& step);

/// The command that draws a case's picture, or "" where it would tell what is secret.
std::string command(const judge::CaseResult& result);

/// How many public or hidden cases there are, or how many of them failed.
std::size_t count(const std::vector<judge::CaseResult>& cases, bool hidden, bool only_failed = false);

/// What is said of a student whom the grader failed.
inline constexpr const char* kIncident =
    "The grader could not finish. This is a fault of the grader or its machine, and not a mark. It will try "
    "again.";

}  // namespace texel::reports
