// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace texel::course {

/// What a student needs beside the picture: the step's own lines, and what the handout says of it.
struct StepText {
  std::filesystem::path file;  ///< on this machine
  std::string shown_file;      ///< in the tree: "shaders/05_normal_map/decode_normal.glsl"
  int line = 0;                ///< of the first marker, counted from 1
  struct Line {
    int number;  ///< from 1
    std::string text;
    bool is_given;  ///< not the student's to write
  };
  std::vector<Line> lines;  ///< of each place of the step, from the function's head on; none without the file
  // The handout's, as plain text; "" and none without it.
  std::string task;                           ///< its explanation, "Where:" and "Write:"
  std::string question;                       ///< to be answered before the picture shows it
  std::vector<std::string> choices, answers;  ///< what may be chosen, and what is said to each
  std::string after;                          ///< what is said once the step is right
};

/// Reads the step's places in its file, and the section "### ID …" of the lab's README.md, both below `root`.
StepText read_step_text(const std::filesystem::path& root, const std::string& lab_folder,
                        const std::string& step, const std::string& file, int line);

/// A handout's text without Markdown's marks; formulas in Unicode: "$T_1 = \sqrt{a^2}$" is "T₁ = √(a²)".
std::string without_markdown(const std::string& text);

}  // namespace texel::course
