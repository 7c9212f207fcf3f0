// SPDX-License-Identifier: MIT
// Draws the textures, normal maps and cube maps in assets/ that teach/procedural has as functions: what
// truths compare with is then what is drawn. SOURCES.md says where the other files come from.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <string>

#include "core/error.hpp"
#include "core/parallel.hpp"
#include "core/terminal.hpp"
#include "image/color.hpp"
#include "image/save.hpp"
#include "procedural/cube_maps.hpp"
#include "procedural/height_fields.hpp"
#include "procedural/textures.hpp"

namespace texel::assets {
namespace {

namespace fs = std::filesystem;
using procedural::HeightField;
using procedural::Texture;

std::uint8_t encode_color(double linear) {
  return static_cast<std::uint8_t>(255 * image::srgb_from_linear(std::clamp(linear, 0.0, 1.0)) + 0.5);
}

std::uint8_t encode_component(double n) {
  return static_cast<std::uint8_t>(255 * (n + 1) / 2 + 0.5);
}

/// Linear-light color and straight alpha at (u, v); u runs right and v up, 0 to 1 over the picture.
using Color = std::function<glm::dvec4(double u, double v)>;

/// A picture of a function: each pixel is the mean over samples x samples points of its area, in linear light
/// (color weighted by alpha, so that what is transparent tints no edge), then sRGB-encoded. `channels`: 1
/// grey, the mean of R, G and B; 2 grey and alpha; 3 RGB; 4 RGBA.
image::Image8 render(int width, int height, int channels, int samples, const Color& color) {
  image::Image8 picture(width, height, channels);
  in_parallel(processors(), static_cast<std::size_t>(height), [&](std::size_t row) {
    const int y = static_cast<int>(row);
    for (int x = 0; x < width; ++x) {
      glm::dvec4 sum(0);  // color times alpha, and alpha
      for (int j = 0; j < samples; ++j)
        for (int i = 0; i < samples; ++i) {
          const glm::dvec4 c = color((x + (i + 0.5) / samples) / width, (y + (j + 0.5) / samples) / height);
          sum += glm::dvec4(c.r * c.a, c.g * c.a, c.b * c.a, c.a);
        }
      const glm::dvec3 mean = sum.a > 0 ? glm::dvec3(sum) / sum.a : glm::dvec3(0);
      if (channels <= 2) picture.at(x, y) = encode_color((mean.r + mean.g + mean.b) / 3);
      for (int c = 0; c < 3 && channels > 2; ++c) picture.at(x, y, c) = encode_color(mean[c]);
      if (channels % 2 == 0)
        picture.at(x, y, channels - 1) = static_cast<std::uint8_t>(255 * sum.a / (samples * samples) + 0.5);
    }
  });
  return picture;
}

/// The exact normals of a height field at the middle of each texel: 8 bits, +y up, linear, n = 2c - 1.
image::Image8 bake(HeightField field, int size) {
  image::Image8 map(size, size, 3);
  in_parallel(processors(), static_cast<std::size_t>(size), [&](std::size_t row) {
    const int y = static_cast<int>(row);
    for (int x = 0; x < size; ++x) {
      const glm::dvec3 n = procedural::normal(field, (x + 0.5) / size, (y + 0.5) / size);
      for (int c = 0; c < 3; ++c) map.at(x, y, c) = encode_component(n[c]);
    }
  });
  return map;
}

/// `samples`: a side of the grid of samples in each pixel.
constexpr struct {
  const char* file;
  Texture texture;
  int width, height, channels, samples;
} kTextures[] = {
    {"brick", Texture::brick, 512, 512, 3, 4},
    {"brick_128", Texture::brick, 128, 128, 3, 16},
    {"brick_32", Texture::brick, 32, 32, 3, 32},
    {"wood", Texture::wood, 512, 512, 3, 4},
    {"scales", Texture::scales, 512, 512, 3, 4},
    {"smile", Texture::smile, 512, 512, 3, 8},
    {"label_grid", Texture::label_grid, 512, 512, 3, 8},
    {"label_npot", Texture::label_grid, 100, 75, 3, 16},
    {"checker", Texture::checker, 512, 512, 3, 1},
    {"sine_sweep", Texture::sine_sweep, 512, 512, 3, 8},
    {"stripes", Texture::stripes, 64, 64, 3, 8},
    {"noise", Texture::noise, 512, 512, 3, 2},
    {"decal", Texture::decal, 512, 512, 4, 8},
    {"light_map", Texture::light_map, 512, 512, 3, 2},
    {"hard_1x1", Texture::brick, 1, 1, 3, 512},
    {"hard_grey_33x17", Texture::label_grid, 33, 17, 1, 32},
    {"hard_grey_alpha_31x19", Texture::decal, 31, 19, 2, 32},
    {"hard_rgb_35x21", Texture::label_grid, 35, 21, 3, 32},
    {"hard_rgba_37x23", Texture::decal, 37, 23, 4, 32},
};

constexpr struct {
  const char* name;
  int size, samples;
  glm::dvec3 (*color)(glm::dvec3 direction);
} kCubeMaps[] = {{"labelled", 256, 6, procedural::labelled_color},
                 {"smooth", 128, 4, procedural::smooth_color},
                 {"smooth_5", 5, 64, procedural::smooth_color}};

void make_all(const fs::path& folder) {
  const auto save = [&](const fs::path& file, const image::Image8& picture) {
    fmt::print("made {}\n", file.string());
    flush_output();
    fs::create_directories((folder / file).parent_path());
    constexpr int best_compression = 9;  // of zlib: these files are written once and cloned often
    image::save_png(folder / file, picture, {}, best_compression);
  };
  image::Image8 flat(4, 4, 3);
  for (std::size_t i = 0; i < flat.samples.size(); ++i)
    flat.samples[i] = encode_component(i % 3 == 2 ? 1 : 0);
  save("normal_maps/flat.png", flat);
  for (const auto& made : kTextures)
    save(fs::path("textures") / (std::string(made.file) + ".png"),
         render(made.width, made.height, made.channels, made.samples,
                [&](double u, double v) { return procedural::color(made.texture, u, v); }));
  for (const auto& [file, field] : procedural::height_fields)
    save(fs::path("normal_maps") / (std::string(file) + ".png"), bake(field, 512));
  for (const auto& made : kCubeMaps)
    for (const image::Face face : procedural::faces) {
      constexpr const char* files[] = {"px.png", "nx.png", "py.png", "ny.png", "pz.png", "nz.png"};
      // The first (top) row of a face is its t = 0, as OpenGL lays faces out; a picture's v runs up, a face's
      // t down.
      save(fs::path("cube_maps") / made.name / files[static_cast<int>(face)],
           render(made.size, made.size, 3, made.samples, [&](double u, double v) {
             return glm::dvec4(made.color(procedural::direction(face, u, 1 - v)), 1);
           }));
    }
}

}  // namespace
}  // namespace texel::assets

int main(int argc, char** argv) {
  return texel::run_main("make_assets", [&] {
    if (argc != 2 || argv[1][0] == '-')
      throw texel::Error::usage("no folder is named", "name the one to write, as in make_assets assets");
    texel::assets::make_all(argv[1]);
    return texel::Exit::holds;
  });
}
