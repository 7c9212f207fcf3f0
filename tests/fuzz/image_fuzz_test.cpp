// SPDX-License-Identifier: MIT
// Thousands of spoilt picture files: whatever the bytes, a picture or one Error comes back. The mutations
// come from a hash of their number, so that a failure repeats.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "../support/picture_files.hpp"
#include "../support/spoilt.hpp"
#include "core/error.hpp"
#include "core/files.hpp"
#include "image/load.hpp"
#include "image/save.hpp"

namespace texel::image {
namespace {

using test::mutated;
using test::Random;

/// The seeds: small sound files of every format.
std::vector<std::string> sound_files(const test::TemporaryFolder& folder) {
  std::vector<std::string> files = {test::bmp_2x2(),
                                    test::tga_2x2(),
                                    test::tga_rle_2x2(),
                                    test::gif_2x2(),
                                    test::jpeg_8x8(),
                                    test::jpeg_16x16(false),
                                    test::jpeg_16x16(true),
                                    test::jpeg_of_camera(6, true),
                                    test::jpeg_of_camera(7, false)};
  // With a palette.
  files.push_back(test::bytes({0, 1, 1, 0, 0, 2, 0, 24, 0, 0, 0, 0, 2, 0, 2, 0, 8, 0x20}) + "abcdef" +
                  test::bytes({0, 1, 0, 1}));
  files.push_back(test::png(2, 2, 16, 0, test::bytes({0, 1, 2, 3, 4, 0, 5, 6, 7, 8})));
  const std::vector<Text> texts = {{"lab", "fuzz"}, {"unicode", "Größe"}};
  for (int channels = 1; channels <= 4; ++channels) {
    Image8 image(9, 7, channels);
    ImageF floats(3, 2, channels < 3 ? 1 : 3);
    for (std::size_t i = 0; i < image.samples.size(); ++i)
      image.samples[i] = static_cast<std::uint8_t>(i * i);
    save_png(folder / "seed.png", image, texts);
    files.push_back(read_file(folder / "seed.png"));
    save_pfm(folder / "seed.pfm", floats);
    files.push_back(read_file(folder / "seed.pfm"));
  }
  return files;
}

struct Outcome {
  int pictures = 0;
  int errors = 0;
};

template <class Load>
void count(Outcome& outcome, Load load) {
  try {
    const auto image = load();
    EXPECT_GE(image.width, 1);
    EXPECT_GE(image.height, 1);
    EXPECT_EQ(image.samples.size(), image.index(0, image.height));
    ++outcome.pictures;
  } catch (const Error& error) {
    EXPECT_EQ(error.exit_code(), Exit::failed);
    EXPECT_NE(std::string(error.what()).find("spoilt"), std::string::npos) << error.what();
    ++outcome.errors;
  }
}

TEST(ImageFuzz, gives_a_picture_or_an_error_when_bytes_are_spoilt) {
  const test::TemporaryFolder folder;
  const std::vector<std::string> seeds = sound_files(folder);
  Outcome strict, eight, floats, texts;
  for (std::uint64_t i = 0; i < 3000; ++i) {
    Random random(i);
    const std::string content = mutated(seeds[i % seeds.size()], random);
    SCOPED_TRACE(i);
    // A new name each time: file systems flush to the disk when a file is replaced.
    const auto path = folder / ("spoilt" + std::to_string(i));
    write_file(path, content);
    count(strict, [&] { return parse_png(content, "spoilt", 9, 7); });
    count(eight, [&] { return load8(path, i % 2 == 0 ? 0 : 3); });
    count(floats, [&] { return load_pfm(path); });
    count(texts, [&] {
      read_png_text(path);
      return Image8(1, 1, 1);
    });
    std::filesystem::remove(path);
  }
  // Neither side may be empty, or the mutations would test nothing.
  for (const Outcome& outcome : {eight, floats, texts}) {
    EXPECT_GT(outcome.pictures, 100);
    EXPECT_GT(outcome.errors, 100);
  }
  // Checksums and one size: of the changed files hardly any is sound.
  EXPECT_GT(strict.pictures, 10);
}

}  // namespace
}  // namespace texel::image
