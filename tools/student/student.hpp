// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "check/check.hpp"

namespace texel::tools {

/// The student's own tree and its build.
check::OwnTree own_tree();

/// What check::check finds in it. Where that takes long, as with a loop that never ends, a line on the
/// terminal says that it goes on. Errors as check::check.
std::vector<judge::LabResult> checked(const std::vector<course::Lab>& labs, const std::string& context);

/// The step's hints that were shown before and one more, as text. The build remembers how many. Throws Error
/// (exit 3) when it cannot.
std::string next_hint(const course::Step& step);

/// The handout's question of a step with its choices, or with the answer to one, counted from 1; "" where it
/// has none. Throws Error (exit 2) for a step or choice that is not there.
std::string prediction(const std::string& step, std::size_t choice, std::size_t indent);

/// What the handout says once a step is right.
std::string after_step(const std::string& step);

// What a check found, for people; judge/results.hpp is for programs.

/// The steps of these labs, one after the other.
std::vector<judge::StepResult> all_steps(const std::vector<judge::LabResult>& labs);

/// A lab's steps, each in a line: done, wrong, next, to do or waiting; below the next one and below each that
/// was begun, what is wrong and what helps. Lines end in '\n'. With colours for a terminal.
std::string report(const judge::LabResult& lab);

/// The course as one line, a line for each lab, and what comes next.
std::string progress_report(const std::vector<judge::LabResult>& labs);

}  // namespace texel::tools
