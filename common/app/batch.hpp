// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>

#include "canvas.hpp"

namespace texel::app {

/// Draws every snapshot of a JSON list `[{"name", "view", "size", "set": {parameter: value}}]` from one
/// process into `folder`, which is made when it is missing. `name` becomes name.png, unless it ends in .png
/// or .pfm itself. The whole list is checked before the first is drawn. Each starts from the lab's present
/// parameters. Throws Error that names the entry.
void draw_batch(Canvas& canvas, AnyLab& lab, const std::filesystem::path& list,
                const std::filesystem::path& folder, int samples);

}  // namespace texel::app
