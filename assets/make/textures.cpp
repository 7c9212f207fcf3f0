// SPDX-License-Identifier: MIT
#include "textures.hpp"

#include <string>

#include "gif.hpp"
#include "image/save.hpp"
#include "procedural/height_fields.hpp"
#include "procedural/textures.hpp"
#include "render.hpp"
#include "save.hpp"

namespace texel::assets {

namespace {

using procedural::HeightField;
using procedural::Texture;

/// One file of a texture function.
struct Picture {
  const char* file;
  Texture texture;
  int width, height, channels;
  int samples;  ///< a side of the grid of samples in each pixel
};

constexpr Picture pictures[] = {
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

/// A ramp that 8 bits cannot hold: 16-bit grey, s along x plus 255 finer steps along y.
image::Image16 ramp_16_bit() {
  image::Image16 ramp(67, 13, 1);
  for (int y = 0; y < ramp.height; ++y) {
    for (int x = 0; x < ramp.width; ++x) {
      ramp.at(x, y) =
          static_cast<std::uint16_t>((65535 - 255) * x / (ramp.width - 1) + 255 * y / (ramp.height - 1));
    }
  }
  return ramp;
}

struct NormalMap {
  const char* file;
  HeightField field;
};

constexpr NormalMap normal_maps[] = {{"brick", HeightField::brick},
                                     {"wood", HeightField::wood},
                                     {"scales", HeightField::scales},
                                     {"bump", HeightField::bump}};

std::uint8_t encode_component(double n) {
  return static_cast<std::uint8_t>(255 * (n + 1) / 2 + 0.5);
}

image::Image8 bake(HeightField field, int size) {
  image::Image8 map(size, size, 3);
  for_each_row(size, [&](int y) {
    for (int x = 0; x < size; ++x) {
      const glm::dvec3 n = procedural::normal(field, (x + 0.5) / size, (y + 0.5) / size);
      for (int c = 0; c < 3; ++c) map.at(x, y, c) = encode_component(n[c]);
    }
  });
  return map;
}

}  // namespace

void make_textures(const std::filesystem::path& folder, const Progress& progress) {
  std::filesystem::create_directories(folder / "textures");
  for (const Picture& picture : pictures) {
    const auto file = std::filesystem::path("textures") / (std::string(picture.file) + ".png");
    progress(file);
    const auto colour = [&](double u, double v) { return procedural::colour(picture.texture, u, v); };
    image::save_png(folder / file,
                    render(picture.width, picture.height, picture.channels, picture.samples, colour), {},
                    best_compression);
  }
  progress("textures/brick.gif");
  const auto brick = [](double u, double v) { return procedural::colour(Texture::brick, u, v); };
  save_gif(folder / "textures/brick.gif", render(256, 256, 3, 8, brick));
  progress("textures/hard_grey16_67x13.png");
  save_png16(folder / "textures/hard_grey16_67x13.png", ramp_16_bit());
}

void make_normal_maps(const std::filesystem::path& folder, const Progress& progress) {
  std::filesystem::create_directories(folder / "normal_maps");
  for (const NormalMap& map : normal_maps) {
    const auto file = std::filesystem::path("normal_maps") / (std::string(map.file) + ".png");
    progress(file);
    image::save_png(folder / file, bake(map.field, 512), {}, best_compression);
  }
  progress("normal_maps/flat.png");
  image::Image8 flat(4, 4, 3);
  for (std::size_t i = 0; i < flat.samples.size(); ++i)
    flat.samples[i] = encode_component(i % 3 == 2 ? 1 : 0);
  image::save_png(folder / "normal_maps/flat.png", flat, {}, best_compression);
}

}  // namespace texel::assets
