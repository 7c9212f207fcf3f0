// SPDX-License-Identifier: MIT
#include "cube_maps.hpp"

#include <string>

#include "image/save.hpp"
#include "procedural/cube.hpp"
#include "render.hpp"
#include "save.hpp"
#include "scene.hpp"

namespace texel::assets {

namespace {

struct CubeMap {
  const char* name;
  int size;
  int samples;  ///< a side of the grid of samples in each pixel
  glm::dvec3 (*colour)(glm::dvec3 direction);
};

constexpr CubeMap cube_maps[] = {{"labelled", 256, 6, procedural::labelled_colour},
                                 {"smooth", 128, 4, procedural::smooth_colour},
                                 {"scene", 512, 3, scene_colour}};

}  // namespace

void make_cube_maps(const std::filesystem::path& folder, const Progress& progress) {
  for (const CubeMap& map : cube_maps) {
    const auto place = std::filesystem::path("cube_maps") / map.name;
    std::filesystem::create_directories(folder / place);
    for (const procedural::Face face : procedural::faces) {
      const auto file = place / (std::string(procedural::file_name(face)) + ".png");
      progress(file);
      // A picture's v runs up, a face's t runs down.
      const auto colour = [&](double u, double v) {
        return glm::dvec4(map.colour(procedural::direction(face, u, 1 - v)), 1);
      };
      image::save_png(folder / file, render(map.size, map.size, 3, map.samples, colour), {},
                      best_compression);
    }
  }
}

}  // namespace texel::assets
