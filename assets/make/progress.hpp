// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <functional>

namespace texel::assets {

/// Called with each file, relative to the asset folder, before it is made.
using Progress = std::function<void(const std::filesystem::path&)>;

}  // namespace texel::assets
