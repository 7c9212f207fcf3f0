// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "embedded.hpp"
#include "pictures.hpp"
#include "store/class_results.hpp"

/// The pages of the report.
namespace texel::reports {

/// A whole page. It may load nothing and run nothing but its own style and script, whatever its body says:
/// Content-Security-Policy with their hashes.
std::string page(const std::string& title, const std::string& body, const Embedded& script);

/// A command, broken between flags and not within them, with a button that copies it.
std::string command_line(const std::string& command);

/// The facts as a list; without the command that graded the class, unless it is wanted.
std::string facts_list(const std::map<std::string, std::string>& facts, bool with_command);

/// How a step stands, as a symbol and in a word.
struct Standing {
  const char* style;   ///< the class of its colour
  const char* symbol;  ///< one character, so that it is told without colours
  const char* word;
};
Standing standing(const judge::StepResult& step);

std::string class_page(const store::ClassResult& results);
std::string student_page(const store::StudentResult& student, const std::map<std::string, std::string>& facts,
                         Pictures& pictures);

}  // namespace texel::reports
