// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "image/image.hpp"

namespace texel::app {

/// A lab's notes on its input.
struct Notes {
  std::vector<std::string> warnings;  ///< what is wrong with it: repairs, missing files
  std::vector<std::string> facts;     ///< what was generated, and figures worth knowing
};

/// The files that the labs read: pictures, models, shaders. A bundled one is named without folder and ending
/// ("brick"); a name with a '/' or a '.' is the path of any other file.
class Assets {
 public:
  /// `root` holds assets/ and shaders/. Empty: TEXEL_ROOT, else beside the program, else the source tree.
  /// Throws Error (exit 3) when there is none.
  explicit Assets(const std::filesystem::path& root = {});

  [[nodiscard]] std::filesystem::path shader_root() const { return root_ / "shaders"; }

  /// A colour picture, bottom row first, with the channels it has. Errors as image::load8.
  [[nodiscard]] image::Image8 texture(const std::string& name) const;
  /// A normal map (+Y up, n = 2c - 1) as RGB.
  [[nodiscard]] image::Image8 normal_map(const std::string& name) const;
  /// Six faces +X -X +Y -Y +Z -Z; row 0 of each is the picture's top row, as OpenGL wants them. A path is
  /// that of a folder with px.png, nx.png, py.png, ny.png, pz.png, nz.png.
  [[nodiscard]] std::array<image::Image8, 6> cube_map(const std::string& name) const;
  /// The path of an OBJ file.
  [[nodiscard]] std::filesystem::path model(const std::string& name) const;
  /// The path of the mesh (PLY) that a bundled OBJ file was read to; of the OBJ file where there is none.
  [[nodiscard]] std::filesystem::path mesh(const std::string& name) const;

  /// Every file that was read so far, for hot reload.
  [[nodiscard]] const std::vector<std::filesystem::path>& files() const { return files_; }

 private:
  std::filesystem::path find(const char* folder, const std::string& name, const char* ending) const;
  [[nodiscard]] image::Image8 load(const std::filesystem::path& path, int channels) const;
  void remember(const std::filesystem::path& path) const;
  std::filesystem::path root_;
  mutable std::vector<std::filesystem::path> files_;
};

}  // namespace texel::app
