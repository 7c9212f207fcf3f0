// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <vector>

#include "app/canvas.hpp"
#include "image/save.hpp"

namespace texel::app {

/// A picture that was drawn, and its file. Nothing of OpenGL or of the lab: any thread may write it.
struct Snapshot {
  std::filesystem::path file;
  image::Image8 colors;            ///< as seen, for a .png
  image::ImageF values;            ///< of a data view, for a .pfm
  std::vector<image::Text> texts;  ///< of a .png: lab, parameters, view, size and renderer

  /// Throws Error (exit 3) when the file cannot be written.
  void write() const;
};

/// Reads the picture that the canvas holds, which was drawn with the lab's present parameters.
Snapshot take_snapshot(const Canvas& canvas, AnyLab& lab, View view, glm::ivec2 size,
                       const std::filesystem::path& file);

/// Throws Error (usage) unless a picture of `view` can be written to such a file: .png, or .pfm for a data
/// view.
void check_ending(const std::filesystem::path& file, View view);

}  // namespace texel::app
