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
  gl::Record record;
  Notes notes;                                               ///< of the lab: repairs, missing files
  std::vector<std::pair<std::string, double>> milliseconds;  ///< by stage
};

std::string to_json(const Statistics& statistics);

/// What --measure prints: {"lab", "parameters", "view", "truth", "unit", "mean", "rms", "p99", "max",
/// "pixels", "non_finite"}.
std::string to_json(AnyLab& lab, const ErrorFigures& figures);

/// --list-parameters, for people and for programs.
std::string parameters_as_text(const params::Set& parameters);
std::string parameters_as_json(const params::Set& parameters);

}  // namespace texel::app
