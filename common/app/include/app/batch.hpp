// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <functional>
#include <vector>

#include "app/canvas.hpp"
#include "app/settings.hpp"

namespace texel::app {

/// Throws Error (usage) unless a picture of `view` can be written to such a file: .png, or .pfm for a data
/// view.
void check_ending(const std::filesystem::path& file, View view);

/// Reads the picture that the canvas holds, which was drawn with the lab's present parameters. What it
/// returns writes it, on any thread: it throws Error (exit 3) when the file cannot be written.
std::function<void()> take_snapshot(const Canvas& canvas, AnyLab& lab, View view, glm::ivec2 size,
                                    const std::filesystem::path& file);

/// Writes the lab's vertex stream as drawn with its present parameters. Throws Error (exit 2) when the lab
/// has none.
void write_mesh(AnyLab& lab, const Assets& assets, const std::filesystem::path& file);

/// Snapshots; a vertex stream where the case is a mesh.
using Batch = std::vector<course::Case>;

/// Reads a list for --batch, as course::parse_batch does. Throws Error (exit 2) that names the entry that is
/// wrong, also where the lab has no such view or parameter.
Batch read_batch(AnyLab& lab, const std::filesystem::path& list);

/// How many pixels each of its shader programs draws, in the mean: views, choices and toggles are constants
/// in a program.
double pixels_per_program(const Batch& batch, const params::Set& parameters);

/// Draws all from one process into `folder`, which is made when it is missing, and says what became of each
/// in its results.json (course/batch.hpp), anew after each. Each starts from the lab's present parameters.
/// One that cannot be drawn is a line `file: why` on standard error too, and does not keep the others from
/// being drawn; in the end Error (exit 3) says how many there were. With one thread (TEXEL_THREADS=1) each is
/// written before the next is begun.
void draw_batch(Canvas& canvas, AnyLab& lab, const Assets& assets, const Batch& batch,
                const std::filesystem::path& folder, int samples);

}  // namespace texel::app
