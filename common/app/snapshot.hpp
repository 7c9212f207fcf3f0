// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>

#include "canvas.hpp"

namespace texel::app {

/// Draws one picture and writes it: .png (with the lab, its parameters, the view, the size and the renderer
/// as text chunks) or .pfm (the values of a data view). Throws Error (usage) for any other ending.
void write_snapshot(Canvas& canvas, AnyLab& lab, View view, glm::ivec2 size, int samples,
                    const std::filesystem::path& file);

/// Writes the picture that the canvas holds, as write_snapshot does.
void write_picture(const Canvas& canvas, AnyLab& lab, View view, glm::ivec2 size,
                   const std::filesystem::path& file, const std::string& renderer);

/// Throws Error (usage) unless a picture of `view` can be written to such a file.
void check_ending(const std::filesystem::path& file, View view);

}  // namespace texel::app
