// SPDX-License-Identifier: MIT
#include "pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <system_error>

#include "core/error.hpp"
#include "core/files.hpp"
#include "image/compared.hpp"
#include "image/load.hpp"
#include "image/save.hpp"
#include "mesh/bounds.hpp"
#include "mesh/ply.hpp"
#include "wording.hpp"

namespace texel::reports {
namespace {

namespace fs = std::filesystem;
using image::Image8;
using image::ImageF;

constexpr int kStreamSize = 320;
constexpr std::size_t kMostVertices = 20'000;  // the course's largest stream has 5,000
/// Of a unit vector's parts it is 0.06 degrees: the streams' limit is 0.05, and float32 keeps 1e-7.
constexpr float kLike = 1e-3F;

constexpr int kLargestSide = 1024;
constexpr std::uintmax_t kLargestFile = 16U << 20U;  // 1024x1024 floats of three channels and a header

/// The planes of `Picture::values`. A picture's rows begin at the bottom, a PNG's and the planes' at the top.
Image8 planes(const ImageF& values) {
  Image8 result(values.width, 3 * values.channels * values.height, 1);
  for (int channel = 0; channel < values.channels; ++channel)
    for (int y = 0; y < values.height; ++y)
      for (int x = 0; x < values.width; ++x) {
        const std::uint32_t bits = upper24(values.at(x, values.height - 1 - y, channel));
        for (int part = 0; part < 3; ++part) {
          const int row = (3 * channel + part) * values.height + y;
          result.at(x, result.height - 1 - row) = static_cast<std::uint8_t>(bits >> (16 - 8 * part));
        }
      }
  return result;
}

/// In half the size: means of 2x2 pixels.
Image8 halved(const Image8& picture) {
  Image8 half(picture.width / 2, picture.height / 2, picture.channels);
  for (int y = 0; y < half.height; ++y)
    for (int x = 0; x < half.width; ++x)
      for (int c = 0; c < half.channels; ++c)
        half.at(x, y, c) = static_cast<std::uint8_t>(
            (picture.at(2 * x, 2 * y, c) + picture.at(2 * x + 1, 2 * y, c) + picture.at(2 * x, 2 * y + 1, c) +
             picture.at(2 * x + 1, 2 * y + 1, c) + 2) /
            4);
  return half;
}

std::string data_url(const Image8& picture) {
  // 9 is slower and saves no more than 1 % of these pictures.
  return "data:image/png;base64," + base64(image::encode_png(picture, "a picture of the page", {}, 6));
}

/// Why a file is not even opened, as a sentence, or "".
std::string not_shown(const fs::path& file) {
  std::error_code error;
  if (!fs::is_regular_file(fs::symlink_status(file, error))) return "The picture's file is missing.";
  return fs::file_size(file, error) > kLargestFile ? "The picture's file is too large to show here." : "";
}

using Vertex = std::array<float, 18>;  // all attributes; 0 where the mesh has none

std::vector<Vertex> vertices_of(const mesh::Mesh& mesh) {
  std::vector<Vertex> vertices(mesh.vertex_count(), Vertex{});
  std::size_t at = 0;
  mesh::for_each_attribute(mesh, [&]<class Vector>(const std::vector<Vector>& values) {
    for (std::size_t i = 0; i < values.size(); ++i)
      std::copy_n(&values[i][0], sizeof(Vector) / sizeof(float), &vertices[i][at]);
    at += sizeof(Vector) / sizeof(float);
  });
  return vertices;
}

/// A line between two places in pixels, z towards the viewer: brighter where it is nearer, and before others.
void draw_line(Image8& picture, std::vector<float>& depths, const glm::vec3& from, const glm::vec3& to) {
  const auto steps = static_cast<int>(glm::distance(from, to)) + 1;
  for (int i = 0; i <= steps; ++i) {
    const glm::vec3 at = glm::mix(from, to, static_cast<float>(i) / static_cast<float>(steps));
    const int x = static_cast<int>(at.x), y = static_cast<int>(at.y);
    float& known = depths[static_cast<std::size_t>(y) * kStreamSize + static_cast<std::size_t>(x)];
    if (at.z <= known) continue;
    known = at.z;
    std::fill_n(&picture.at(x, y), 3, static_cast<std::uint8_t>(140 + 200 * at.z / kStreamSize));
  }
}

/// A vertex stream as a picture, seen from in front, a little from the right and above, as large as it fits:
/// the edges of its triangles, and a red dot at each vertex that is unlike all of `other`'s, in its place or
/// in an attribute there. Throws Error where one of the two has too many vertices to compare.
Image8 stream_picture(const mesh::Mesh& mesh, const mesh::Mesh& other) {
  if (std::max({mesh.vertex_count(), mesh.triangle_count() / 2, other.vertex_count()}) > kMostVertices)
    throw Error::failed("has too many vertices to show", {"vertex stream"});
  const mesh::Bounds box = mesh::bounds(mesh);
  const float scale = 0.94F * kStreamSize / std::max(glm::length(box.extent()), 1e-30F);  // all of it fits
  const glm::vec3 toward = glm::normalize(glm::vec3(0.5F, 0.4F, 0.8F));
  const glm::vec3 right = glm::normalize(glm::cross(glm::vec3(0, 1, 0), toward));
  std::vector<glm::vec3> places;
  const glm::mat3 view = glm::transpose(glm::mat3(right, glm::cross(toward, right), toward));
  for (const glm::vec3& position : mesh.positions)
    places.push_back(scale * (view * (position - box.center())) +
                     glm::vec3(glm::vec2(0.5F * kStreamSize), 0));
  Image8 picture(kStreamSize, kStreamSize, 3);
  std::ranges::fill(picture.samples, std::uint8_t{45});
  std::vector<float> depths(picture.samples.size() / 3, -INFINITY);
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      draw_line(picture, depths, places[mesh.indices[3 * t + k]], places[mesh.indices[3 * t + (k + 1) % 3]]);
  const std::vector<Vertex> known = vertices_of(other);
  auto place = places.begin();
  for (const Vertex& vertex : vertices_of(mesh)) {
    const auto is_like = [&](const Vertex& one) {
      return std::ranges::equal(vertex, one, [](float a, float b) { return std::abs(a - b) <= kLike; });
    };
    const glm::ivec2 dot = *place++;
    if (std::ranges::none_of(known, is_like))
      for (int k = 0; k < 25; ++k) {
        std::uint8_t* pixel = &picture.at(dot.x + k % 5 - 2, dot.y + k / 5 - 2);
        pixel[0] = 235, pixel[1] = 40, pixel[2] = 60;
      }
  }
  return picture;
}

}  // namespace

std::uint32_t upper24(float value) {
  const auto bits = std::bit_cast<std::uint32_t>(value);
  if (std::isnan(value)) return 0x7fc000;
  const std::uint32_t odd = bits >> 8U & 1U;
  return (bits + 0x7fU + odd) >> 8U;
}

Picture Pictures::read(const std::string& path, const std::string& view, Shown shown) const {
  Picture picture;
  const fs::path file = folder_ / path;
  if (const std::string why = not_shown(file); !why.empty()) return {why};
  const bool is_data = file.extension() == ".pfm";
  ImageF values;
  Image8 colors;
  try {
    if (is_data) {
      values = image::load_pfm(file);
      picture.width = values.width;
      picture.height = values.height;
      picture.channels = values.channels;
    } else {
      const image::Size size = image::png_size(MappedFile(file).bytes(), file.string());
      picture.width = size.width;
      picture.height = size.height;
      picture.channels = 3;
    }
    if (std::max(picture.width, picture.height) > kLargestSide)
      return {
          fmt::format("The picture has {}x{} pixels, too many to show here.", picture.width, picture.height)};
    // As the judge reads it: a stranger's PNG must not unpack to more than it says.
    colors = is_data
                 ? image::shown(values, view)
                 : image::parse_png(MappedFile(file).bytes(), file.string(), picture.width, picture.height);
  } catch (const Error&) {
    return {"The picture cannot be read."};
  }
  if (shown == Shown::small && std::min(picture.width, picture.height) > 1) colors = halved(colors);
  picture.url = data_url(colors);
  if (is_data && shown == Shown::with_numbers) picture.values = data_url(planes(values));
  return picture;
}

Picture Pictures::stream(const std::string& path, const std::string& other) const {
  const auto read = [&](const std::string& one) {
    if (const std::string why = not_shown(folder_ / one); !why.empty()) throw Error::failed(why);
    return mesh::parse_ply(MappedFile(folder_ / one).bytes(), one);
  };
  try {
    const Image8 colors = stream_picture(read(path), read(other));
    return {{}, colors.width, colors.height, data_url(colors), {}, colors.channels};
  } catch (const Error&) {
    return {"The vertices cannot be shown."};
  }
}

const Picture& Pictures::reference(const std::string& path, const std::string& view, Shown shown) {
  Reference* reference = nullptr;
  {
    const std::scoped_lock lock(mutex_);
    reference = &references_.try_emplace({path, shown}).first->second;
  }
  std::call_once(reference->once, [&] { reference->picture = read(path, view, shown); });
  return reference->picture;
}

}  // namespace texel::reports
