// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>

#include "app/lab.hpp"

namespace texel::app {

/// Reads parameters from a TOML file: `name = value` each, as save_config writes them. Those that it does not
/// name keep their values. Throws Error with file, line and column; then nothing has changed.
void load_config(const std::filesystem::path& file, const Info& info, params::Set& parameters);

/// Writes all parameters with their help as comments.
void save_config(const std::filesystem::path& file, const Info& info, const params::Set& parameters);

}  // namespace texel::app
