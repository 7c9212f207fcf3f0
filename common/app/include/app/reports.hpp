// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "app/canvas.hpp"

namespace texel::app {

/// The lab's programs that were compiled, each with where its constants and uniforms come from.
std::string shaders_as_text(const gl::ProgramCache& programs, const params::Set& parameters, View view);

/// What stands behind its flag in --help: "Depth; 0 to 4 units [1]".
std::string describe(const params::Parameter& p);

/// --list-parameters, for people and for programs.
std::string parameters_as_text(const params::Set& parameters);
std::string parameters_as_json(const params::Set& parameters);

}  // namespace texel::app
