// SPDX-License-Identifier: MIT
#include "image/mipmaps.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "core/stages.hpp"
#include "image/colour.hpp"

namespace texel::image {
namespace {

/// What one texel of the next level covers on this one, along one axis.
struct Footprint {
  int first = 0;
  int count = 0;
  float weights[3] = {0, 0, 0};  ///< of first, first + 1, ...; their sum is 1
};

/// The footprints of a side of `size` halved. An even side gives pairs; an odd one of 2m + 1 gives m texels
/// of 2 + 1/m each, so that the weights of three neighbours shift from texel to texel.
std::vector<Footprint> footprints(int size) {
  const int next = std::max(1, size / 2);
  std::vector<Footprint> result;
  for (int i = 0; i < next; ++i) {
    if (size == 1)
      result.push_back({0, 1, {1, 0, 0}});
    else if (size % 2 == 0)
      result.push_back({2 * i, 2, {0.5F, 0.5F, 0}});
    else {
      const auto whole = static_cast<float>(size);
      result.push_back({2 * i,
                        3,
                        {static_cast<float>(next - i) / whole, static_cast<float>(next) / whole,
                         static_cast<float>(i + 1) / whole}});
    }
  }
  return result;
}

/// One axis at a time: the box is the product of its sides.
ImageF halve_width(const ImageF& image) {
  const std::vector<Footprint> columns = footprints(image.width);
  ImageF half(static_cast<int>(columns.size()), image.height, image.channels);
  const int channels = image.channels;
  float* out = half.samples.data();
  for (int y = 0; y < image.height; ++y)
    for (const Footprint& column : columns) {
      const float* in = &image.at(column.first, y);
      for (int c = 0; c < channels; ++c, ++in) {
        float sum = column.weights[0] * in[0];
        if (column.count > 1) sum += column.weights[1] * in[channels];
        if (column.count > 2) sum += column.weights[2] * in[2 * channels];
        *out++ = sum;
      }
    }
  return half;
}

ImageF halve_height(const ImageF& image) {
  const std::vector<Footprint> rows = footprints(image.height);
  ImageF half(image.width, static_cast<int>(rows.size()), image.channels);
  const std::size_t length = image.index(0, 1);
  for (std::size_t y = 0; y < rows.size(); ++y)
    for (int k = 0; k < rows[y].count; ++k) {
      const float* in = &image.at(0, rows[y].first + k);
      float* out = half.samples.data() + y * length;
      for (std::size_t i = 0; i < length; ++i) out[i] += rows[y].weights[k] * in[i];
    }
  return half;
}

}  // namespace

std::vector<Image8> mip_chain(const Image8& image, Encoding encoding) {
  const Stage stage("mipmaps");
  // Each channel's own encoding and, so that a million samples are quick, its values as a table.
  std::array<Encoding, 4> encodings{};
  std::array<std::array<float, 256>, 4> values{};
  const auto channels = static_cast<std::size_t>(image.channels);
  for (std::size_t c = 0; c < channels; ++c) {
    const bool alpha = channels % 2 == 0 && c == channels - 1;
    encodings[c] = alpha ? Encoding::linear : encoding;
    for (std::size_t i = 0; i < 256; ++i)
      values[c][i] = from_encoding8(static_cast<std::uint8_t>(i), encodings[c]);
  }

  ImageF level(image.width, image.height, image.channels);
  for (std::size_t i = 0; i < image.samples.size();)
    for (std::size_t c = 0; c < channels; ++c, ++i) level.samples[i] = values[c][image.samples[i]];

  std::vector<Image8> chain = {image};
  while (level.width > 1 || level.height > 1) {
    level = halve_width(halve_height(level));  // the vectorised pass first
    Image8 stored(level.width, level.height, level.channels);
    for (std::size_t i = 0; i < stored.samples.size();)
      for (std::size_t c = 0; c < channels; ++c, ++i)
        stored.samples[i] = to_encoding8(level.samples[i], encodings[c]);
    chain.push_back(std::move(stored));
  }
  return chain;
}

}  // namespace texel::image
