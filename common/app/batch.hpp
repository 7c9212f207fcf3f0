// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>

#include "canvas.hpp"

namespace texel::app {

/// Writes the lab's vertex stream as drawn with its present parameters. Throws Error (exit 2) when the lab
/// has none.
void write_mesh(AnyLab& lab, const Assets& assets, const std::filesystem::path& file);

/// Draws every snapshot of a JSON list `[{"name", "view", "size", "set": {parameter: value}}]` from one
/// process into `folder`, which is made when it is missing. `name` becomes name.png, unless it ends in .png
/// or .pfm itself, or in .ply for the vertex stream. The whole list is checked before the first is drawn, and
/// an Error (exit 2) names the entry that is wrong. Each starts from the lab's present parameters. One that
/// cannot be drawn is a line `file: why` on standard error and does not keep the others from being drawn; in
/// the end Error (exit 3) says how many there were.
void draw_batch(Canvas& canvas, AnyLab& lab, const Assets& assets, const std::filesystem::path& list,
                const std::filesystem::path& folder, int samples);

}  // namespace texel::app
