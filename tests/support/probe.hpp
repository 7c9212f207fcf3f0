// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

#include "gl/shader_source.hpp"

namespace texel::test {

/// Runs a step function in GLSL over a table of inputs and reads its values back exactly (32-bit floats).
///
/// `file` below `shader_root` holds the function; `expression` is a GLSL expression of type vec4 in which
/// `a`, `b`, `c`, … (one for each column of the table, vec4 each) stand for the row's inputs:
/// "vec4(decode_normal(a.rgb), 1.0)". All columns have the same length, which is that of the result.
/// Functions that need derivatives (dFdx) cannot be asked so: a table has no neighbours. Throws Error (exit
/// 3) with the shader's file and line.
std::vector<glm::vec4> probe(const std::filesystem::path& shader_root, const std::string& file,
                             const std::string& expression, const std::vector<gl::Define>& defines,
                             std::span<const std::vector<glm::vec4>> columns);

}  // namespace texel::test
