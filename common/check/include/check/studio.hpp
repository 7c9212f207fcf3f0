// SPDX-License-Identifier: MIT
// Where a lab's program draws its cases, and what became of each.
#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/process.hpp"
#include "course/case.hpp"

namespace texel::check {

/// The variables of this process that choose and steer the driver, as LIBGL_ALWAYS_SOFTWARE or
/// GALLIUM_DRIVER, by name. Unless they say otherwise, they ask for a renderer in software: expected pictures
/// are its, and a sandbox has no other.
std::vector<std::pair<std::string, std::string>> driver_variables();

/// What draws.
struct Studio {
  std::filesystem::path program;                     ///< alone in its folder
  std::filesystem::path root;                        ///< the folder with shaders/ and assets/
  std::string context = "auto";                      ///< the program's --context
  Run run = run_plainly;                             ///< or in a sandbox, a program that nobody trusts
  std::vector<std::filesystem::path> readable = {};  ///< what it may read besides
  std::filesystem::path shader_cache = {};           ///< where the driver keeps compiled shaders, if it does
  int timeouts = 2;                                  ///< after so many nothing more is drawn
  TimeBudget* budget = nullptr;                      ///< what all its programs may take; null: no such limit
};

/// The reasons why files are missing, by the file's name, and remarks on the whole.
struct Drawn {
  std::map<std::string, std::string> faults;
  /// Of those that the lab's program refused to draw: the file and line that it blames, as "cube.obj:9", or
  /// "". Not of those at which it died or never ended, as it does by many mistakes.
  std::map<std::string, std::string> refused;
  /// Of those at which a plain process died, and those after them: where, as "labs/03_obj/a.cpp:41", or "".
  std::map<std::string, std::string> crashed_at;
  std::vector<std::string> notes;
  std::string renderer;  ///< the driver that drew, as the program says it, or ""
};

/// Draws the cases into the folder `out`, from one process as long as it lives: the case at which it dies or
/// runs out of time gets that as its reason, and another process draws what is left, three times at the most.
/// Throws Error (exit 3) for faults of the machine.
Drawn draw(const Studio& studio, const std::vector<course::Case>& cases, const std::filesystem::path& out);

}  // namespace texel::check
