// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "app/lab.hpp"
#include "gl/recorder.hpp"

namespace texel::app {

/// What --stats prints: a contract with scripts, see docs/architecture.md.
struct Statistics {
  std::string lab, renderer, version;
  std::string drawn_by;  ///< both, without what changes no pixel
  Notes notes;           ///< of the lab: repairs, missing files
  gl::Record record;
  std::vector<std::pair<std::string, double>> milliseconds;  ///< by stage
  long long peak_bytes = 0;                                  ///< of resident memory
};

/// The most memory that this process has had at once.
long long peak_resident_bytes();

std::string to_json(const Statistics& statistics);

/// What --frames prints of frames that took so many milliseconds each, at least one.
std::string frame_times_as_text(std::vector<double> milliseconds, glm::ivec2 size);

/// What --measure prints: {"lab", "parameters", "view", "truth", "unit", "mean", "rms", "p99", "max",
/// "pixels", "non_finite"}.
std::string to_json(AnyLab& lab, const ErrorFigures& figures);

/// The lab's programs that were compiled, each with where its constants and uniforms come from.
std::string shaders_as_text(const gl::ProgramCache& programs, const params::Set& parameters, View view);

/// --list-parameters, for people and for programs.
std::string parameters_as_text(const params::Set& parameters);
std::string parameters_as_json(const params::Set& parameters);

}  // namespace texel::app
