// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "../support/flip_pictures.hpp"
#include "../support/picture_files.hpp"
#include "../support/said.hpp"
#include "core/error.hpp"
#include "core/files.hpp"
#include "image/color.hpp"
#include "image/compared.hpp"
#include "image/difference.hpp"
#include "image/load.hpp"
#include "image/mipmaps.hpp"
#include "image/save.hpp"

namespace texel::image {
namespace {

using test::bytes;
using test::error_of;
using test::has;
using test::TemporaryFolder;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

using Bytes = std::vector<std::uint8_t>;

template <class Sample>
Image<Sample> picture(int width, int height, int channels, std::vector<Sample> samples) {
  Image<Sample> image(width, height, channels);
  EXPECT_EQ(image.samples.size(), samples.size());
  image.samples = std::move(samples);
  return image;
}

Image8 grey(int width, int height, Bytes samples) {
  return picture(width, height, 1, std::move(samples));
}

ImageF floats(int width, int channels, std::vector<float> samples) {
  return picture(width, 1, channels, std::move(samples));
}

/// Bottom row red and green, top row blue and white.
Image8 four_colors() {
  return picture<std::uint8_t>(2, 2, 3, {255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255});
}

/// Each sample another value.
Image8 counted(int width, int height, int channels) {
  Image8 image(width, height, channels);
  for (std::size_t i = 0; i < image.samples.size(); ++i)
    image.samples[i] = static_cast<std::uint8_t>(i * 37 + 11);
  return image;
}

/// One file, written and read.
class ImageFile : public testing::Test {
 protected:
  /// What loading these bytes says, or "".
  std::string load_error(const std::string& content) {
    write_file(path_, content);
    return error_of([&] { load8(path_); });
  }
  Image8 loaded(const std::string& content, int channels = 0) {
    write_file(path_, content);
    return load8(path_, channels);
  }
  std::string pfm_error(const std::string& content) {
    write_file(path_, content);
    return error_of([&] { load_pfm(path_); });
  }

  TemporaryFolder folder_;
  std::filesystem::path path_ = folder_ / "a.png";
};
using Png = ImageFile;
using PngText = ImageFile;
using Load = ImageFile;
using Pfm = ImageFile;

TEST_F(Png, keeps_every_sample_when_saved_and_loaded) {
  for (int channels = 1; channels <= 4; ++channels)
    for (const int compression : {1, 9}) {
      const Image8 image = counted(5, 3, channels);
      save_png(path_, image, {}, compression);
      EXPECT_EQ(load8(path_), image) << channels << " channels, compression " << compression;
      EXPECT_EQ(encode_png(image, "b.png", {}, compression), read_file(path_)) << "the same bytes each time";
    }
}

TEST_F(Png, has_its_top_row_first_in_the_file) {
  // Rows of the file, each after its filter byte 0: top 10 20, bottom 30 40.
  EXPECT_EQ(loaded(test::png(2, 2, 8, 0, bytes({0, 10, 20, 0, 30, 40}))), grey(2, 2, {30, 40, 10, 20}));
}

TEST_F(Png, has_the_channels_of_the_file_or_three_when_asked) {
  // A palette of two colours, of which the second is clear; then grey of 1 bit, and of 16 with alpha.
  const std::string palette = test::png(2, 1, 8, 3, bytes({0, 0, 1}));
  const std::size_t data = palette.find("IDAT") - 4;
  const std::string colors =
      test::png_chunk("PLTE", bytes({1, 2, 3, 4, 5, 6})) + test::png_chunk("tRNS", bytes({255, 0}));
  for (const auto& [file, channels, samples, rgb] : std::vector<std::tuple<std::string, int, Bytes, Bytes>>{
           {std::string(palette).insert(data, colors), 4, {1, 2, 3, 255, 4, 5, 6, 0}, {1, 2, 3, 4, 5, 6}},
           {test::png(2, 1, 1, 0, bytes({0, 0x40})), 1, {0, 255}, {0, 0, 0, 255, 255, 255}},
           {test::png(1, 1, 16, 4, bytes({0, 9, 200, 8, 0})), 2, {10, 8}, {10, 10, 10}},
           // 16 bits are rounded. A step of 8 bits is 257 of 16: 128 is just below its middle.
           {test::png(2, 1, 16, 0, bytes({0, 0x00, 0x80, 0x00, 0x81})), 1, {0, 1}, {0, 0, 0, 1, 1, 1}}}) {
    const Image8 own = loaded(file);
    EXPECT_EQ(own.channels, channels);
    EXPECT_EQ(own.samples, samples);
    EXPECT_EQ(load8(path_, 3).samples, rgb);
  }
}

TEST_F(Png, of_a_stranger_has_the_size_that_is_asked_for) {
  const std::string png = encode_png(four_colors(), "a.png");
  EXPECT_EQ(parse_png(png, "a.png", 2, 2), four_colors());
  for (const auto& size : {std::pair{3, 2}, {2, 3}, {1, 2}, {2, 1}})
    EXPECT_EQ(error_of([&] { parse_png(png, "a.png", size.first, size.second); }),
              fmt::format("a.png: is 2x2 pixels, not {}x{}", size.first, size.second));
}

TEST_F(PngText, comes_back_in_order_without_those_that_are_empty) {
  const std::vector<Text> texts = {{"lab", "lab05_normal_map"},
                                   {"parameters", "--method gram_schmidt\n--light-angle 30"},
                                   {"renderer", "Größe 3 µm, 法線"},
                                   {"lab", "a key may come twice"}};
  std::vector<Text> saved = texts;
  saved.insert(saved.begin() + 1, {"look", ""});
  save_png(path_, four_colors(), saved);
  EXPECT_EQ(read_png_text(path_), texts);
  EXPECT_TRUE(has(read_file(path_), "iTXtrenderer")) << "what is not Latin is marked as UTF-8";
  EXPECT_EQ(load8(path_), four_colors());
  save_png(path_, four_colors());
  EXPECT_TRUE(read_png_text(path_).empty());
}

TEST_F(PngText, is_refused_and_no_file_left_when_it_cannot_be_held) {
  for (const char* key : {"", " space", "two  spaces"}) {
    const Text text = {key, "value"};
    EXPECT_TRUE(has(error_of([&] { save_png(path_, four_colors(), std::span(&text, 1)); }), "a.png")) << key;
  }
  EXPECT_TRUE(folder_.empty());
}

TEST_F(PngText, is_an_error_when_the_file_is_no_png) {
  for (const char* content : {"rubbish", ""}) {
    write_file(path_, content);
    EXPECT_TRUE(has(error_of([&] { read_png_text(path_); }), "a.png"));
  }
  EXPECT_TRUE(has(error_of([&] { read_png_text(folder_ / "none.png"); }), "none.png"));
}

TEST_F(ImageFile, is_left_as_it_was_when_saving_fails) {
  const auto fail = [&] {
    EXPECT_TRUE(has(error_of([&] { save_png(path_, four_colors(), {}, 99); }), "a.png"));
    EXPECT_TRUE(has(error_of([&] { save_pfm(folder_ / "no/a.pfm", ImageF(1, 1, 1)); }), "a.pfm"));
    EXPECT_TRUE(has(error_of([&] { save_png(folder_ / "no/folder.png", four_colors()); }), "folder.png"));
  };
  fail();
  EXPECT_TRUE(folder_.empty());
  save_png(path_, four_colors());
  fail();
  EXPECT_EQ(load8(path_), four_colors());
}

/// A TGA of the four colours with a name of two bytes: kind, first entry and size of its palette, and the
/// order of rows and columns.
std::string tga(int palette, int kind, int first, int entries, int index_bits, int order) {
  return bytes({2, palette, kind, first, 0, entries, 0, palette * 24, 0, 0, 0, 0, 2, 0, 2, 0, index_bits,
                order}) +
         "ID";
}

TEST_F(Load, reads_the_same_picture_from_every_format_and_order_of_rows) {
  const std::string rows = test::tga_2x2().substr(18);
  const auto pixels = [&](std::initializer_list<std::size_t> order) {
    std::string result;
    for (const std::size_t i : order) result += rows.substr(3 * i, 3);
    return result;
  };
  std::string bmp = test::bmp_2x2();
  bmp.replace(22, 4, bytes({0xfe, 0xff, 0xff, 0xff}));  // -2 rows: the top one first
  bmp = bmp.substr(0, 54) + bmp.substr(62, 8) + bmp.substr(54, 8);
  const std::string footer = std::string(8, '\0') + "TRUEVISION-XFILE." + '\0';
  const std::vector<std::string> files = {
      test::bmp_2x2(),
      test::tga_2x2(),
      test::tga_rle_2x2(),
      test::gif_2x2(),
      bmp,
      tga(0, 2, 0, 0, 24, 0) + pixels({0, 1, 2, 3}) + footer,
      tga(0, 2, 0, 0, 24, 0x20) + pixels({2, 3, 0, 1}),
      tga(0, 10, 0, 0, 24, 0x20) + bytes({3}) + pixels({2, 3, 0, 1}) + footer,
      tga(1, 1, 0, 4, 8, 0x20) + rows + bytes({2, 3, 0, 1}),
      tga(1, 9, 0, 4, 8, 0) + rows + bytes({3, 0, 1, 2, 3}) + footer};
  for (std::size_t i = 0; i < files.size(); ++i) {
    EXPECT_EQ(load_error(files[i]), "") << i;
    const bool is_gif = files[i].starts_with("GIF");  // which has alpha
    EXPECT_EQ(load8(path_, is_gif ? 3 : 0), four_colors()) << i;
  }
}

TEST_F(Load, reads_jpeg) {
  EXPECT_EQ(loaded(test::jpeg_8x8()), grey(8, 8, Bytes(64, 100)));
  for (const bool progressive : {false, true})
    EXPECT_EQ(loaded(test::jpeg_16x16(progressive)), constant(16, 16, {128, 128, 128})) << progressive;
}

TEST_F(Load, reads_what_stands_before_the_end_of_a_file) {
  // Much of it looks like tables: a phone's film, a second picture, a stamp.
  const std::string film = bytes({0, 2, 0xff, 0xc4, 0xff, 0xff, 0xff, 0xc0}) + std::string(500, '\xff');
  for (const std::string& content :
       {test::jpeg_8x8(), test::jpeg_16x16(true), test::png(1, 1, 8, 0, bytes({0, 7})) + "IDAT",
        test::bmp_2x2(), test::tga_2x2(), test::gif_2x2()}) {
    EXPECT_EQ(load_error(content + film), "");
    EXPECT_EQ(load8(path_), loaded(content));
  }
}

TEST_F(Load, turns_a_photo_as_the_camera_was_held) {
  // The blocks' greys, top row first (CIPA DC-008, 4.6.4).
  const std::vector<Bytes> shown = {{144, 169, 138, 158, 176, 159}, {138, 169, 144, 159, 176, 158},
                                    {159, 176, 158, 138, 169, 144}, {158, 176, 159, 144, 169, 138},
                                    {144, 158, 169, 176, 138, 159}, {158, 144, 176, 169, 159, 138},
                                    {159, 138, 176, 169, 158, 144}, {138, 159, 169, 176, 144, 158}};
  for (int orientation = 0; orientation <= 9; ++orientation)
    for (const bool little_endian : {false, true}) {
      const Image8 photo = loaded(test::jpeg_of_camera(orientation, little_endian));
      const bool upright = orientation >= 5 && orientation <= 8;
      EXPECT_EQ(std::pair(photo.width, photo.height), upright ? std::pair(16, 24) : std::pair(24, 16));
      Bytes blocks;
      for (int y = photo.height - 4; y > 0; y -= 8)
        for (int x = 4; x < photo.width; x += 8) blocks.push_back(photo.at(x, y));
      const bool is_known = orientation >= 1 && orientation <= 8;
      EXPECT_EQ(blocks, shown[is_known ? static_cast<std::size_t>(orientation) - 1 : 0]) << orientation;
    }
}

TEST_F(Load, names_file_fault_and_remedy) {
  const auto jpeg = [](int frame, int bits) {
    std::string file = test::jpeg_16x16(false);
    const std::size_t at = file.find("\xff\xc0");
    file[at + 1] = static_cast<char>(frame), file[at + 4] = static_cast<char>(bits);
    return file;
  };
  std::string inks = jpeg(0xc0, 8), huffman = jpeg(0xc0, 8), sampling = jpeg(0xc0, 8);
  inks[inks.find("\xff\xc0") + 9] = 4;
  huffman[huffman.find("\xff\xc4") + 5 + 12] = '\xff';  // 256 codes with the one that there is
  EXPECT_FALSE(has(load_error(huffman), "invalid JPEG tables"));
  huffman[huffman.find("\xff\xc4") + 5 + 13] = '\x01';
  sampling[sampling.find("\x01\x22") + 1] = '\x32';  // three across, of which two are no whole part
  sampling[sampling.find("\x02\x11") + 1] = '\x21';
  std::string packed_bmp = test::bmp_2x2();
  packed_bmp[30] = 1;
  const std::string rows = test::tga_2x2().substr(18);
  const std::string text_png = encode_png(Image8(9, 7, 3), "", std::vector<Text>{{"lab", "a text"}});
  std::string header = text_png, samples = text_png, text = text_png;
  header[text_png.find("IHDR") + 17] ^= 1;  // in the checksum
  samples[text_png.find("IDAT") + 6] ^= 1;  // in the data
  text[text_png.find("a text")] = 'b';
  const std::pair<const char*, std::vector<std::string>> faults[] = {
      {"is empty", {""}},
      {"cannot be read as a picture", {"rubbish"}},
      {"", {std::string(1000, '\0'), std::string(1000, '\xff'), "v 1 2 3\nf 1 2 3\n"}},
      {"JPEG of 12 bits a sample", {jpeg(0xc0, 12)}},
      {"lossless or hierarchical JPEG or one with arithmetic coding",
       {jpeg(0xc9, 8), jpeg(0xc3, 8), jpeg(0xc5, 8)}},
      {"JPEG of four channels", {inks}},
      {"invalid JPEG tables", {huffman, "\xff" + huffman, sampling}},
      {"run-length-encoded BMP", {packed_bmp}},
      {"TGA file with interleaved rows or mirrored",
       {tga(0, 2, 0, 0, 24, 0x40) + rows, tga(0, 2, 0, 0, 24, 0x10) + rows}},
      {"TGA file whose palette does not begin at 0", {tga(1, 1, 7, 4, 8, 0) + rows + bytes({7, 8, 9, 10})}},
      {"TGA file of an unusual kind", {std::string(30, 'x') + "TRUEVISION-XFILE." + '\0'}},
      {"is a WebP file", {"RIFF1234WEBPVP8 "}},
      {"is a HEIC, AVIF or MP4 file", {bytes({0, 0, 0, 28}) + "ftypavif"}},
      {"is a HEIC, AVIF or MP4 file", {bytes({0, 0, 0, 28}) + "ftypheic"}},
      {"is a KTX file", {"\xabKTX 20\xbb"}},
      {"is a DDS file", {"DDS |"}},
      {"is a Radiance HDR file", {"#?RADIANCE\n"}},
      {"is a TIFF file", {bytes({'I', 'I', 42, 0})}},
      {"is a PBM, PGM, PPM, PAM or PFM file", {"P6\n1 1\n65535\n123456"}},
      {"is a file of text", {"<!DOCTYPE html>"}},
      {"is a damaged PNG (invalid chunk checksum)", {header, samples, text}},
      {"is a damaged PNG (arithmetic overflow)", {test::png(0x7fffffff, 0x7fffffff, 8, 2, "rows")}},
      // A tiny file with a huge header, within the limits.
      {"cut short", {test::png(16384, 16384, 8, 0, bytes({0, 1, 2, 3}))}}};
  for (const auto& [fault, files] : faults)
    for (const std::string& content : files) {
      const std::string message = load_error(content);
      EXPECT_TRUE(has(message, fault) && has(message, "a.png: ")) << fault << " | " << message;
      EXPECT_TRUE(has(message, "PNG, JPEG, GIF, BMP or TGA")) << message;
    }
  EXPECT_TRUE(has(error_of([&] { load8(folder_ / "none.png"); }), "none.png"));
  EXPECT_NE(error_of([&] { load8(folder_ / "."); }), "");
}

TEST_F(Load, is_an_error_wherever_the_file_is_cut) {
  const std::string picture_file = encode_png(counted(9, 9, 3), "a.png");
  for (const std::string& content :
       {// The end's checksum is not missed.
        picture_file.substr(0, picture_file.size() - 4), test::jpeg_8x8(), test::jpeg_16x16(false),
        test::jpeg_16x16(true), test::bmp_2x2().substr(0, 68),  // the last row's filling is not missed
        test::tga_2x2(), test::tga_rle_2x2(),
        test::gif_2x2().substr(0, 25 + test::gif_frame({}).size())}) {  // the first frame
    EXPECT_EQ(load_error(content), "");
    for (std::size_t size = 0; size < content.size(); ++size)
      EXPECT_TRUE(has(load_error(content.substr(0, size)), "a.png")) << content.substr(0, 4) << " " << size;
  }
}

TEST_F(Load, refuses_a_picture_that_is_too_large_by_its_header) {
  for (const auto& [width, height] : {std::pair<std::uint32_t, std::uint32_t>{100000, 100000},
                                      {16385, 1},
                                      {1, 16385},
                                      {16384, 16384}}) {  // three channels are beyond 2^28 samples
    const std::string message = load_error(test::png(width, height, 8, 2, bytes({0, 1, 2, 3})));
    EXPECT_TRUE(has(message, "a.png")) << message;
    EXPECT_TRUE(has(message, "of 3 channels are too large")) << message;
    EXPECT_TRUE(has(message, "16384")) << message;
  }
}

TEST_F(Pfm, keeps_every_value_little_endian_and_bottom_row_first) {
  const ImageF image =
      picture<float>(2, 2, 3, {0, -0.0F, 1, 1e-40F, 1e38F, -3.5F, infinity, -infinity, 0.1F, 7, 8, 9});
  save_pfm(path_, image);
  EXPECT_EQ(load_pfm(path_), image);
  save_pfm(path_, floats(3, 1, {1, nan, 2}));
  const ImageF back = load_pfm(path_);
  EXPECT_EQ(back.channels, 1);
  EXPECT_TRUE(std::isnan(back.at(1, 0)));
  EXPECT_EQ(back.at(2, 0), 2);
  save_pfm(path_, picture<float>(1, 2, 1, {1, -2}));  // 1 is 3f800000, -2 is c0000000
  EXPECT_EQ(read_file(path_), "Pf\n1 2\n-1.0\n" + bytes({0, 0, 0x80, 0x3f, 0, 0, 0, 0xc0}));
  write_file(path_, "PF 1 1 1.0\n" + bytes({0x3f, 0x80, 0, 0, 0xc0, 0, 0, 0, 0x40, 0, 0, 0}));
  EXPECT_EQ(load_pfm(path_).samples, (std::vector<float>{1, -2, 2})) << "big-endian";
}

TEST_F(Pfm, is_an_error_when_header_or_size_are_wrong) {
  const std::string four_bytes(4, '\0');
  EXPECT_EQ(pfm_error("Pf\n1 1\n-1.0\n" + four_bytes), "");
  const std::pair<const char*, std::vector<std::string>> faults[] = {
      {"is not a PFM file", {"", "P", "PF", std::string(1000, 'P'), "P6\n1 1\n-1.0\n" + four_bytes}},
      {"has a size of 0x1", {"Pf\n0 1\n-1.0\n" + four_bytes}},
      {"has a size of -1x-1", {"Pf\n-1 -1\n-1.0\n" + four_bytes}},
      {"has no valid width", {"Pf\n99999999999999999999 1\n-1.0\n" + four_bytes}},
      {"has no valid height", {"Pf\n1 x\n-1.0\n" + four_bytes}},
      {"has no valid scale", {"Pf\n1 1\n-1.0x\n" + four_bytes}},
      {"has a scale that is zero", {"Pf\n1 1\n0\n" + four_bytes}},
      {"has a scale that is zero or not finite",
       {"Pf\n1 1\nnan\n" + four_bytes, "Pf\n1 1\ninf\n" + four_bytes}},
      {"has 0 bytes of samples, but its header says 4", {"Pf\n1 1\n-1.0\n"}},
      {"has 5 bytes of samples", {"Pf\n1 1\n-1.0\nx" + four_bytes}},
      {"its header says 12", {"PF\n1 1\n-1.0\n" + four_bytes}},
      {"its header says 1073741824", {"Pf\n16384 16384\n-1.0\n" + four_bytes}},
      {"are too large", {"Pf\n100000 100000\n-1.0\n" + four_bytes}}};
  for (const auto& [fault, files] : faults)
    for (const std::string& content : files) {
      const std::string message = pfm_error(content);
      EXPECT_TRUE(has(message, fault) && has(message, "a.png: ")) << fault << " | " << message;
    }
}

TEST(Srgb, follows_the_standard_curve) {
  // IEC 61966-2-1: 0.04045 ends the straight part; 0.5 encodes to 0.7353569831 and 0.5 decodes to
  // 0.2140411405. The double differs from these ten digits by at most their rounding.
  EXPECT_NEAR(linear_from_srgb(0.04045), 0.04045 / 12.92, 1e-15);
  EXPECT_NEAR(srgb_from_linear(0.5), 0.7353569831, 5e-11);
  EXPECT_NEAR(linear_from_srgb(0.5), 0.2140411405, 5e-11);
  for (const float end : {0.0F, 1.0F}) {
    EXPECT_EQ(linear_from_srgb(end), end);
    EXPECT_EQ(srgb_from_linear(end), end);
  }
  // The two are inverse: a few roundings of a double near 1 (measured: 4e-16).
  for (int i = 0; i <= 1000; ++i)
    EXPECT_NEAR(srgb_from_linear(linear_from_srgb(i / 1000.0)), i / 1000.0, 2e-15);
}

TEST(Encoding8, gives_every_sample_back_and_rounds_and_clamps_as_the_curve_says_everywhere) {
  for (int i = 0; i < 256; ++i)
    for (const Encoding encoding : {Encoding::srgb, Encoding::linear})
      EXPECT_EQ(to_encoding8(from_encoding8(static_cast<std::uint8_t>(i), encoding), encoding), i);
  int differing = 0;
  for (int i = 0; i <= 100000; ++i) {
    const float linear = static_cast<float>(i) / 100000.0F;
    const double exact = srgb_from_linear(static_cast<double>(linear)) * 255;
    if (to_encoding8(linear) != static_cast<int>(std::floor(exact + 0.5))) ++differing;
  }
  EXPECT_EQ(differing, 0);
  // It rounds half up, and clamps.
  EXPECT_EQ(to_encoding8(0.5F, Encoding::linear), 128);  // 127.5
  EXPECT_EQ(to_encoding8(0.5F, Encoding::srgb), 188);    // 187.516
  for (const Encoding encoding : {Encoding::srgb, Encoding::linear}) {
    for (const float dark : {-1.0F, -infinity, nan}) EXPECT_EQ(to_encoding8(dark, encoding), 0) << dark;
    for (const float light : {2.0F, infinity, std::nextafter(1.0F, 0.0F)})
      EXPECT_EQ(to_encoding8(light, encoding), 255) << light;
  }
}

/// OKLab of an sRGB colour (B. Ottosson, 2020): the direction that the heat map does not use itself.
std::array<double, 3> oklab(const std::array<float, 3>& color) {
  std::array<double, 3> rgb{};
  for (std::size_t c = 0; c < 3; ++c) rgb[c] = linear_from_srgb(static_cast<double>(color[c]));
  const double l = std::cbrt(0.4122214708 * rgb[0] + 0.5363325363 * rgb[1] + 0.0514459929 * rgb[2]);
  const double m = std::cbrt(0.2119034982 * rgb[0] + 0.6806995451 * rgb[1] + 0.1073969566 * rgb[2]);
  const double s = std::cbrt(0.0883024619 * rgb[0] + 0.2817188376 * rgb[1] + 0.6299787005 * rgb[2]);
  return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
          1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
          0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

TEST(Heat, takes_even_steps_that_grow_lighter) {
  double least = infinity;
  double most = 0;
  for (int i = 0; i < 64; ++i) {
    const auto a = oklab(heat(static_cast<float>(i) / 64));
    const auto b = oklab(heat(static_cast<float>(i + 1) / 64));
    EXPECT_GT(b[0], a[0]) << i;
    const double step = std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
    least = std::min(least, step);
    most = std::max(most, step);
  }
  // Measured 1.00002 (floats); a colour outside what sRGB shows and cut off there would be far more.
  EXPECT_LT(most / least, 1.001);
  EXPECT_EQ(heat(-1), heat(0));
  EXPECT_EQ(heat(infinity), heat(1));
}

TEST(MipChain, has_every_level_down_to_one_texel) {
  const std::vector<Image8> chain = mip_chain(counted(20, 5, 3), Encoding::srgb);
  const std::vector<std::pair<int, int>> sizes = {{20, 5}, {10, 2}, {5, 1}, {2, 1}, {1, 1}};
  ASSERT_EQ(chain.size(), sizes.size());
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    EXPECT_EQ(std::pair(chain[i].width, chain[i].height), sizes[i]);
    EXPECT_EQ(chain[i].channels, 3);
  }
  EXPECT_EQ(chain[0], counted(20, 5, 3));
  EXPECT_EQ(mip_chain(counted(1, 1, 4), Encoding::srgb), std::vector<Image8>{counted(1, 1, 4)});
}

TEST(MipChain, averages_by_the_covered_area_and_color_in_linear_light) {
  const Image8 checker = made(4, 4, [](int x, int y) { return (x + y) % 2 * 255; });
  // A picture, and the level below it.
  const std::tuple<Image8, Encoding, Bytes> rows[] = {
      {checker, Encoding::srgb, {188, 188, 188, 188}},    // linear 0.5 is 187.516
      {checker, Encoding::linear, {128, 128, 128, 128}},  // 127.5, half up
      // Alpha is averaged as it is, and apart from the colour.
      {picture<std::uint8_t>(2, 1, 4, {255, 0, 100, 0, 0, 0, 100, 255}), Encoding::srgb, {188, 0, 100, 128}},
      {picture<std::uint8_t>(2, 1, 2, {255, 255, 0, 0}), Encoding::srgb, {188, 128}},
      // 5 texels become 2 of 2.5 each: weights 2 2 1 0 0 and 0 0 1 2 2, over 5.
      {grey(5, 1, {10, 20, 30, 40, 50}), Encoding::linear, {18, 42}},
      // 7 become 3 of 7/3: 3 3 1 0 0 0 0, 0 0 2 3 2 0 0 and 0 0 0 0 1 3 3, over 7; upright here.
      // (21 + 42 + 70) / 7, (140 + 0 + 280) / 7, (140 + 210 + 21) / 7
      {grey(1, 7, {7, 14, 70, 0, 140, 70, 7}), Encoding::linear, {19, 60, 53}},
      // 3x3 become the plain mean of all nine.
      {grey(3, 3, {0, 10, 20, 30, 40, 50, 60, 70, 80}), Encoding::linear, {40}}};
  for (const auto& [image, encoding, next] : rows)
    EXPECT_EQ(mip_chain(image, encoding)[1].samples, next) << image.width;
}

TEST(MipChain, rounds_no_level_on_the_way) {
  // A quarter of the texels is 1: that is 0. On the level between, two texels of a half would become 1.
  const Image8 quarter = made(4, 4, [](int x, int y) { return x % 2 == 0 && y < 2; });
  EXPECT_EQ(mip_chain(quarter, Encoding::linear).back().at(0, 0), 0);
  const Image8 image = counted(37, 23, 1);
  double sum = 0;
  for (const std::uint8_t sample : image.samples) sum += sample;
  const double mean = sum / static_cast<double>(image.samples.size());
  EXPECT_EQ(mip_chain(image, Encoding::linear).back().at(0, 0), std::floor(mean + 0.5));
}

TEST(Difference, counts_red_green_and_blue) {
  struct Row {
    const char* what;
    Image8 a, b;
    double max, mean, p99;
  };
  const Row rows[] = {
      {"the same", four_colors(), four_colors(), 0, 0, 0},
      {"alpha counts for nothing", picture<std::uint8_t>(2, 1, 4, {10, 20, 30, 0, 1, 2, 3, 0}),
       picture<std::uint8_t>(2, 1, 4, {12, 17, 30, 255, 1, 2, 3, 9}), 3, 5.0 / 6, 3},
      {"grey is as much of each", picture<std::uint8_t>(1, 1, 3, {10, 20, 30}), grey(1, 1, {20}), 10,
       20.0 / 3, 10}};
  for (const Row& row : rows) {
    SCOPED_TRACE(row.what);
    const Difference difference = compare(row.a, row.b);
    EXPECT_EQ(std::pair(difference.width, difference.height), std::pair(row.a.width, row.a.height));
    EXPECT_EQ(difference.max, row.max);
    EXPECT_DOUBLE_EQ(difference.mean, row.mean);
    EXPECT_EQ(difference.p99, row.p99);
    EXPECT_EQ(difference.non_finite, 0);
    EXPECT_EQ(compare(row.a, row.b, {.in_degrees = true}).max, row.max) << "bytes have a unit of their own";
  }
}

TEST(Difference, takes_the_nearest_rank_for_percentiles) {
  // Pixel i differs by i. Of 100 the 99th in order counts, of 101 the 100th (ceil(99.99)), of 1 the first;
  // and of 2000 the 1998th for the 99.9th percentile.
  for (const auto& [pixels, p99, p999] :
       {std::tuple{100, 98, 99}, {101, 99, 100}, {200, 197, 199}, {1, 0, 0}, {2, 1, 1}, {2000, 1979, 1997}}) {
    ImageF ramp(pixels, 1, 1);
    for (int x = 0; x < pixels; ++x) ramp.at(x, 0) = static_cast<float>(x);
    const Difference difference = compare(ImageF(pixels, 1, 1), ramp);
    EXPECT_EQ(difference.p99, p99) << pixels;
    EXPECT_EQ(difference.p999, p999) << pixels;
    EXPECT_EQ(difference.max, pixels - 1) << pixels;
  }
}

TEST(Difference, tells_a_pixel_whose_difference_is_closest_to_the_one_that_is_told) {
  const ImageF a(4, 2, 1), b = picture<float>(4, 2, 1, {0, 1, 2, 3, 4, 5, 6, 7});
  for (const auto& [told, x, y] : {std::tuple{2.2, 2, 0}, {5.9, 2, 1}, {100.0, 3, 1}, {std::nan(""), 3, 1}}) {
    const Difference difference = compare(a, b, {.told = told});
    EXPECT_EQ(std::pair(difference.telling_x, difference.telling_y), std::pair(x, y)) << told;
  }
}

TEST(Difference, looks_only_where_the_mask_is_light) {
  const Image8 a = grey(3, 1, {0, 0, 0}), b = grey(3, 1, {9, 2, 4}), mask = grey(3, 1, {0, 255, 1});
  EXPECT_EQ(compare(a, b, {.mask = &mask}).max, 4);
  EXPECT_EQ(compare(a, b, {.mask = &mask}).mean, 3);
  const Image8 dark(3, 1, 1), small(2, 1, 1);
  EXPECT_NE(error_of([&] { compare(a, b, {.mask = &dark}); }), "");
  EXPECT_NE(error_of([&] { compare(a, b, {.mask = &small}); }), "");
}

TEST(Difference, is_an_error_when_sizes_or_channels_differ) {
  EXPECT_TRUE(has(error_of([] { compare(Image8(2, 3, 1), Image8(3, 2, 1)); }), "2x3 and 3x2"));
  EXPECT_NE(error_of([] { compare(Image8(), Image8()); }), "");
  EXPECT_NE(error_of([] { compare(ImageF(1, 1, 1), ImageF(1, 1, 3)); }), "");
  EXPECT_NE(error_of([] { compare(ImageF(1, 1, 2), ImageF(1, 1, 2), {.in_degrees = true}); }), "");
}

TEST(FloatDifference, counts_and_leaves_out_what_is_not_finite) {
  const Difference difference =
      compare(floats(5, 1, {1, nan, 3, 4, nan}), floats(5, 1, {1.5F, 2, infinity, 5, nan}));
  EXPECT_EQ(difference.non_finite, 3);
  EXPECT_EQ(difference.max, 1);
  EXPECT_EQ(difference.mean, 0.75);
  EXPECT_EQ(difference.p99, 1);
  const ImageF none = floats(2, 1, {nan, nan});
  EXPECT_EQ(compare(none, none).non_finite, 2);
  EXPECT_EQ(compare(none, none).max, 0);
  EXPECT_EQ(compare(none, none).mean, 0);
}

TEST(FloatDifference, gives_directions_in_degrees_and_tells_a_missing_one_from_background) {
  constexpr double roundings = 1e-13;  // a few of a double
  const std::tuple<std::vector<float>, std::vector<float>, double, double> rows[] = {
      {{1, 0, 0}, {0, 2, 0}, 90, roundings},
      {{1, 1, 0}, {5, 0, 0}, 45, roundings},
      {{0, 0, 1}, {0, 0, -3}, 180, roundings},
      {{1, 2, 3}, {1, 2, 3}, 0, 0},
      {{0, 0, 0}, {0, 0, 1}, 180, 0},
      {{0, 0, 1}, {0, 0, 0}, 180, 0},
      // acos of the dot product would give 0 here: 1e-6 radians, whose cosine rounds to 1 in floats.
      {{1, 0, 0}, {1, 1e-6F, 0}, 1e-6 * 180 / 3.14159265358979, 1e-11}};
  const Comparing in_degrees = {.in_degrees = true};
  for (const auto& [a, b, degrees, within] : rows)
    EXPECT_NEAR(compare(floats(1, 3, a), floats(1, 3, b), in_degrees).max, degrees, within);
  // The mean is that of the one pixel that has a direction.
  EXPECT_NEAR(compare(floats(2, 3, {0, 0, 0, 1, 0, 0}), floats(2, 3, {0, 0, 0, 0, 1, 0}), in_degrees).mean,
              90, roundings);
  EXPECT_EQ(compare(floats(1, 3, {nan, 0, 0}), floats(1, 3, {1, 0, 0}), in_degrees).non_finite, 1);
}

/// A disc with hard edges on a background that grows lighter by 2 steps a pixel; what lies inside is rows of
/// a soft wave.
Image8 disc(double center_x, double radius) {
  return made(100, 100, [=](int x, int y) {
    const double inside = 200 + 20 * std::sin(0.5 * (x - center_x)), outside = 20 + x;
    return std::hypot(x - center_x, y - 50) < radius ? inside : outside;
  });
}

/// Some pixels of the disc's edge the other way, as another rasteriser may have it: `count` of those that
/// have the disc on the left and the background on the right.
Image8 rasterised_otherwise(const Image8& picture, int count) {
  Image8 result = picture;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 60; x + 1 < picture.width && count > 0; ++x)
      if (picture.at(x, y) > 170 && picture.at(x + 1, y) < 150) {
        result.at(x, y) = picture.at(x + 1, y);
        --count;
        break;
      }
  return result;
}

/// A white square of 40x40, of whose rightmost column `missing` pixels are black.
Image8 square(int missing) {
  return made(60, 60, [=](int x, int y) {
    return x >= 10 && x < 50 && y >= 10 && y < 50 && (x < 49 || y >= 10 + missing) ? 255 : 0;
  });
}

TEST(EdgeTolerance, forgives_a_pixel_of_an_edge_and_nothing_else) {
  const Image8 a = disc(50, 30);
  Image8 interior = a, line = a, spot = square(0), shaded = square(0);
  spot.at(5, 5) = 255;
  for (int y = 10; y < 50; ++y) shaded.at(49, y) = 240;
  Image8 little = shaded;
  little.at(49, 30) = 255;  // as the pixel beside it
  // With the wave's slope of 10 a pixel still below an edge's contrast.
  for (int x = 40; x < 60; ++x) interior.at(x, 50) = static_cast<std::uint8_t>(interior.at(x, 50) + 15);
  for (int y = 48; y < 52; ++y) line.at(10, y) = 255;
  struct Row {
    const char* what;
    Image8 a, b;
    int forgiven;
    double max;
  };
  const Row rows[] = {
      // Each new value stands beside it in a, and each old one in b.
      {"some pixels of an edge", a, rasterised_otherwise(a, 5), 5, 0},
      {"more of them", a, rasterised_otherwise(a, 9), 9, 0},
      {"the interior", a, interior, 0, 15},
      // In a's place each pixel has a value near by, in b's the line has none.
      {"a line that only one has", a, line, 4, 255 - 20 - 10 - 1},
      {"a spot that only one has", square(0), spot, 0, 255},
      {"a little at an edge", shaded, little, 0, 15},
      // The square's edge has 4 * 39 pixels within and 4 * 41 without; where the column is black, the one
      // before it is edge too: 320 + missing. A tenth of them is forgiven at most.
      {"a tenth of the edge", square(0), square(34), 34, 0},
      {"more than a tenth", square(0), square(38), 0, 255},
      {"a move by a pixel", a, disc(51, 30), 0, compare(a, disc(51, 30)).max},
      {"another size", a, disc(52, 29), 0, compare(a, disc(52, 29)).max}};
  for (const Row& row : rows) {
    SCOPED_TRACE(row.what);
    const Difference strict = compare(row.a, row.b);
    EXPECT_GE(strict.max, std::max(row.max, 15.0));
    EXPECT_EQ(strict.forgiven, 0);
    for (const Difference& tolerant :
         {compare(row.a, row.b, {.edge_tolerance = true}), compare(row.b, row.a, {.edge_tolerance = true})}) {
      EXPECT_EQ(tolerant.forgiven, row.forgiven);
      EXPECT_EQ(tolerant.max, row.max);
      if (row.forgiven == 0) {
        EXPECT_EQ(tolerant.mean, strict.mean);
      } else {
        EXPECT_EQ(tolerant.mean > 0, row.max > 0);
      }
    }
  }
  // It looks beyond the mask but counts within: the three are forgiven by the background.
  const Image8 mask = changed(a, [](int v, std::size_t) { return v > 170 ? 255 : 0; });
  const Difference masked = compare(a, rasterised_otherwise(a, 3), {.mask = &mask, .edge_tolerance = true});
  EXPECT_EQ(masked.forgiven, 3);
  EXPECT_EQ(masked.max, 0);
}

TEST(EdgeTolerance, holds_for_directions_and_what_is_not_finite) {
  // Directions that turn slowly inside a square, and none beside it.
  ImageF a(60, 60, 3);
  for (int y = 10; y < 50; ++y)
    for (int x = 10; x < 50; ++x) {
      a.at(x, y, 0) = std::sin(0.01F * static_cast<float>(x));
      a.at(x, y, 2) = std::cos(0.01F * static_cast<float>(x));
    }
  ImageF b = a;
  for (const int y : {20, 30, 40})
    for (int c = 0; c < 3; ++c) b.at(49, y, c) = 0;  // background instead
  const Comparing tolerant = {.edge_tolerance = true, .in_degrees = true};
  EXPECT_EQ(compare(a, b, {.in_degrees = true}).max, 180);
  EXPECT_EQ(compare(a, b, tolerant).max, 0);  // to the neighbours above and beside
  EXPECT_EQ(compare(a, b, tolerant).forgiven, 3);
  b.at(49, 20, 0) = nan;
  EXPECT_EQ(compare(a, b, tolerant).non_finite, 1);
  EXPECT_EQ(compare(a, b, tolerant).forgiven, 2);
  // The sides' own unit: an eighth of the spread of 0 to 1 and 0 to 0.48.
  EXPECT_EQ(compare(a, b, {.edge_tolerance = true}).forgiven, 2);
}

TEST(MovedPixels, take_away_what_the_part_of_a_slope_explains) {
  const Image8 a = made(20, 20, [](int x, int) { return 100 + 8 * std::max(0, x - 10); });
  Image8 b = a;
  b.at(15, 5) = static_cast<std::uint8_t>(b.at(15, 5) + 2);  // a quarter of the slope of 8 a pixel
  b.at(15, 9) = static_cast<std::uint8_t>(b.at(15, 9) + 3);
  b.at(5, 5) = 102;  // where the picture is flat
  for (const auto& [moved_pixels, forgiven, max] : {std::tuple{0.0, 0, 3}, {0.25, 1, 3}, {0.4, 2, 2}}) {
    const Difference difference = compare(a, b, {.moved_pixels = moved_pixels});
    EXPECT_EQ(difference.forgiven, forgiven) << moved_pixels;
    EXPECT_EQ(difference.max, max) << moved_pixels;
  }
}

TEST(Heatmap, colors_each_pixel_by_its_largest_difference) {
  const auto heat_samples = [](std::initializer_list<float> ts) {
    Bytes samples;
    for (const float t : ts)
      for (const float value : heat(t)) samples.push_back(to_encoding8(value, Encoding::linear));
    return samples;
  };
  const Image8 a = grey(3, 1, {0, 0, 0}), b = grey(3, 1, {0, 10, 20}), mask = grey(3, 1, {255, 255, 0});
  EXPECT_EQ(heatmap(compare(a, b)).samples, heat_samples({0, 0.5F, 1}));
  EXPECT_EQ(heatmap(compare(a, b), 40).samples, heat_samples({0, 0.25F, 0.5F}));
  EXPECT_EQ(heatmap(compare(a, b), 5).samples, heat_samples({0, 1, 1}));
  EXPECT_EQ(heatmap(compare(a, a)).samples, heat_samples({0, 0, 0}));
  EXPECT_EQ(heatmap(compare(a, b, {.mask = &mask}), 20).samples, heat_samples({0, 0.5F, 0}));
  // What is not finite is green.
  const Bytes green = heatmap(compare(floats(3, 1, {0, nan, 1}), floats(3, 1, {0, 0, 3})), 2).samples;
  EXPECT_EQ(green, heat_samples({0, nan, 1}));
  EXPECT_EQ((Bytes(green.begin() + 3, green.begin() + 6)), (Bytes{0, 255, 0}));
}

TEST(DataViews, are_shown_in_the_labs_colors) {
  const std::tuple<const char*, std::vector<float>, Bytes> rows[] = {
      {"normal", {0, 0, 1}, {128, 128, 255}},        {"direction", {-1, 1, 0}, {0, 255, 128}},
      {"texcoord", {1.25F, -0.75F, 0}, {64, 64, 0}}, {"depth", {4, 4, 4}, {128, 128, 128}},
      {"mask", {1, 1, 1}, {255, 255, 255}},          {"lod", {9, 0, 0}, {250, 230, 28}},
      {"normal", {0, 0, 0}, {51, 56, 64}},           {"lod", {nan, 0, 0}, {255, 0, 255}},
      {"depth", {-infinity, 0, 0}, {255, 0, 255}}};
  for (const auto& [view, value, color] : rows)
    EXPECT_EQ(shown(floats(1, 3, value), view).samples, color) << view;
}

}  // namespace
}  // namespace texel::image
