// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "image/image.hpp"

namespace texel::image {

/// A PNG text chunk: the key has 1 to 79 bytes of printable ASCII without spaces at its ends or two together,
/// the value is UTF-8. A text with an empty value is not written.
struct Text {
  std::string key, value;

  bool operator==(const Text&) const = default;
};

/// Writes an 8-bit PNG of 1 to 4 channels with its texts. The values are written as they are. `compression`
/// is zlib's 0 to 9: 1 is fast, for snapshots; 9 is small, for assets. The same input gives the same bytes.
/// Throws Error (exit 3), and leaves no new file, when a text is not as above or the file cannot be
/// written.
void save_png(const std::filesystem::path& path, const Image8& image, std::span<const Text> texts = {},
              int compression = 1);

/// The bytes of such a file. `name` stands in errors, which are the same.
std::string encode_png(const Image8& image, const std::string& name, std::span<const Text> texts = {},
                       int compression = 1);

/// The text chunks that stand before the pixels of a PNG (where `save_png` writes them), in their order.
/// Throws Error (exit 3) when the file is missing, not a PNG or broken.
std::vector<Text> read_png_text(const std::filesystem::path& path);

/// Writes a little-endian portable float map: 1 channel as `Pf`, 3 as `PF`. NaN and infinity are kept. Throws
/// Error (exit 3) as `save_png` does.
void save_pfm(const std::filesystem::path& path, const ImageF& image);

}  // namespace texel::image
