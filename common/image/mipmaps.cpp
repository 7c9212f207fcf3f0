// SPDX-License-Identifier: MIT
#include "image/mipmaps.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "core/parallel.hpp"
#include "core/stages.hpp"
#include "image/color.hpp"

namespace texel::image {
namespace {

/// What one texel of the next level covers on this one, along one axis.
struct Footprint {
  int first = 0;
  int count = 0;
  float weights[3] = {0, 0, 0};  ///< of first, first + 1, ...; their sum is 1
};

/// The footprints of a side of `size` halved. An even side gives pairs; an odd one of 2m + 1 gives m texels
/// of 2 + 1/m each: the weights of three neighbours shift from texel to texel.
std::vector<Footprint> footprints(int size) {
  const int next = std::max(1, size / 2);
  const auto part = [&](int texels) { return static_cast<float>(texels) / static_cast<float>(size); };
  std::vector<Footprint> result;
  for (int i = 0; i < next; ++i) {
    if (size == 1)
      result.push_back({0, 1, {1, 0, 0}});
    else if (size % 2 == 0)
      result.push_back({2 * i, 2, {0.5F, 0.5F, 0}});
    else
      result.push_back({2 * i, 3, {part(next - i), part(next), part(i + 1)}});
  }
  return result;
}

/// A row of `channels` samples a texel, halved in width.
void halve_width(const std::vector<float>& row, const std::vector<Footprint>& columns, int channels,
                 float* out) {
  for (const Footprint& column : columns) {
    const float* in = row.data() + column.first * channels;
    for (int c = 0; c < channels; ++c, ++in) {
      float sum = column.weights[0] * in[0];
      if (column.count > 1) sum += column.weights[1] * in[channels];
      if (column.count > 2) sum += column.weights[2] * in[2 * channels];
      *out++ = sum;
    }
  }
}

/// Samples of a level from which on more threads make it sooner. Measured: so many take 0.2 ms by one thread,
/// and to start another takes 0.07.
constexpr std::size_t kWorthThreads = 1U << 14U;

}  // namespace

std::vector<Image8> mip_chain(const Image8& image, Encoding encoding) {
  const Stage stage("mipmaps");
  // Each channel's encoding, and its values as a table: a million samples are then fast.
  std::array<Encoding, 4> encodings{};
  std::array<std::array<float, 256>, 4> values{};
  const auto channels = static_cast<std::size_t>(image.channels);
  for (std::size_t c = 0; c < channels; ++c) {
    const bool alpha = channels % 2 == 0 && c == channels - 1;
    encodings[c] = alpha ? Encoding::linear : encoding;
    for (std::size_t i = 0; i < 256; ++i)
      values[c][i] = from_encoding8(static_cast<std::uint8_t>(i), encodings[c]);
  }

  std::vector<Image8> chain = {image};
  ImageF level;  // the last of the chain before it was rounded; the picture itself is read from its bytes
  while (chain.back().width > 1 || chain.back().height > 1) {
    const Image8& above = chain.back();
    const std::size_t length = above.index(0, 1);
    const std::vector<Footprint> rows = footprints(above.height), columns = footprints(above.width);
    ImageF next(static_cast<int>(columns.size()), static_cast<int>(rows.size()), image.channels);
    Image8 stored(next.width, next.height, next.channels);
    // One axis at a time: the box is the product of its sides.
    const auto make_row = [&](std::size_t y) {
      std::vector<float> sum(length);
      for (int k = 0; k < rows[y].count; ++k) {
        const std::size_t in = above.index(0, rows[y].first + k);
        const float weight = rows[y].weights[k];
        if (chain.size() == 1)
          for (std::size_t i = 0; i < length;)
            for (std::size_t c = 0; c < channels; ++c, ++i)
              sum[i] += weight * values[c][above.samples[in + i]];
        else
          for (std::size_t i = 0; i < length; ++i) sum[i] += weight * level.samples[in + i];
      }
      const std::size_t begin = next.index(0, static_cast<int>(y));
      halve_width(sum, columns, image.channels, &next.samples[begin]);
      for (std::size_t i = 0; i < next.index(0, 1);)
        for (std::size_t c = 0; c < channels; ++c, ++i)
          stored.samples[begin + i] = to_encoding8(next.samples[begin + i], encodings[c]);
    };
    in_parallel(stored.samples.size() < kWorthThreads ? 1 : processors(), rows.size(), make_row);
    chain.push_back(std::move(stored));
    level = std::move(next);
  }
  return chain;
}

}  // namespace texel::image
