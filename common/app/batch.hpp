// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <vector>

#include "canvas.hpp"
#include "settings.hpp"

namespace texel::app {

/// Writes the lab's vertex stream as drawn with its present parameters. Throws Error (exit 2) when the lab
/// has none.
void write_mesh(AnyLab& lab, const Assets& assets, const std::filesystem::path& file);

/// A snapshot of a list; a vertex stream where the file ends in .ply.
struct BatchEntry {
  std::filesystem::path file;
  View view;
  glm::ivec2 size;
  Settings values;
};
using Batch = std::vector<BatchEntry>;

/// Reads a JSON list `[{"name", "view", "size", "set": {parameter: value}}]`. `name` becomes name.png, unless
/// it ends in .png or .pfm itself, or in .ply. Throws Error (exit 2) that names the entry that is wrong.
Batch read_batch(AnyLab& lab, const std::filesystem::path& list);

/// How many pixels each of its shader programs draws, in the mean: views, choices and toggles are constants
/// in a program.
double pixels_per_program(const Batch& batch, const params::Set& parameters);

/// Draws all from one process into `folder`, which is made when it is missing. Each starts from the lab's
/// present parameters. One that cannot be drawn is a line `file: why` on standard error and does not keep the
/// others from being drawn; in the end Error (exit 3) says how many there were. With one thread
/// (TEXEL_THREADS=1) each is written before the next is begun.
void draw_batch(Canvas& canvas, AnyLab& lab, const Assets& assets, const Batch& batch,
                const std::filesystem::path& folder, int samples);

}  // namespace texel::app
