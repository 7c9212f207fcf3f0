// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "../support/picture_files.hpp"
#include "../support/said.hpp"
#include "core/error.hpp"
#include "core/files.hpp"
#include "image/color.hpp"
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

/// Bottom row red and green, top row blue and white.
Image8 four_colors() {
  Image8 image(2, 2, 3);
  image.samples = {255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255};
  return image;
}

/// Each sample another value.
Image8 counted(int width, int height, int channels) {
  Image8 image(width, height, channels);
  for (std::size_t i = 0; i < image.samples.size(); ++i)
    image.samples[i] = static_cast<std::uint8_t>(i * 37 + 11);
  return image;
}

template <class Sample>
Image<Sample> grey(int width, int height, std::vector<Sample> samples) {
  Image<Sample> image(width, height, 1);
  EXPECT_EQ(image.samples.size(), samples.size());
  image.samples = std::move(samples);
  return image;
}

/// Writes the bytes and tries to load them.
std::string load_error(const TemporaryFolder& folder, const std::string& file, const std::string& content) {
  write_file(folder / file, content);
  return error_of([&] { load8(folder / file); });
}

TEST(Png, keeps_every_sample_when_saved_and_loaded) {
  const TemporaryFolder folder("png_round_trip");
  for (int channels = 1; channels <= 4; ++channels)
    for (const int compression : {1, 9}) {
      const Image8 image = counted(5, 3, channels);
      save_png(folder / "a.png", image, {}, compression);
      EXPECT_EQ(load8(folder / "a.png"), image) << channels << " channels, compression " << compression;
      const Info header = info(folder / "a.png");
      EXPECT_EQ(header.width, 5);
      EXPECT_EQ(header.height, 3);
      EXPECT_EQ(header.channels, channels);
      EXPECT_FALSE(header.is_16_bit);
    }
}

TEST(Png, is_the_same_bytes_when_saved_twice) {
  const TemporaryFolder folder("png_same");
  save_png(folder / "a.png", counted(7, 5, 4));
  save_png(folder / "b.png", counted(7, 5, 4));
  EXPECT_EQ(read_file(folder / "a.png"), read_file(folder / "b.png"));
}

TEST(Png, has_its_top_row_first_in_the_file) {
  const TemporaryFolder folder("png_top");
  // Rows of the file, each after its filter byte 0: top 10 20, bottom 30 40.
  write_file(folder / "a.png", test::png(2, 2, 8, 0, bytes({0, 10, 20, 0, 30, 40})));
  EXPECT_EQ(load8(folder / "a.png"), grey<std::uint8_t>(2, 2, {30, 40, 10, 20}));
}

TEST(Png, keeps_16_bits_when_loaded_as_16) {
  const TemporaryFolder folder("png_16");
  write_file(folder / "a.png",
             test::png(4, 1, 16, 0, bytes({0, 0x12, 0x34, 0xff, 0xfe, 0x00, 0x80, 0x00, 0x81})));
  EXPECT_TRUE(info(folder / "a.png").is_16_bit);
  EXPECT_EQ(load16(folder / "a.png"), grey<std::uint16_t>(4, 1, {0x1234, 0xfffe, 0x80, 0x81}));
  // A step of 8 bits is 257 of 16: 128 is just below its middle.
  EXPECT_EQ(load8(folder / "a.png"), grey<std::uint8_t>(4, 1, {0x12, 0xff, 0, 1}));
}

TEST(Png, spreads_8_bits_over_16) {
  const TemporaryFolder folder("png_8_as_16");
  save_png(folder / "a.png", grey<std::uint8_t>(3, 1, {0, 1, 255}));
  EXPECT_EQ(load16(folder / "a.png"), grey<std::uint16_t>(3, 1, {0, 257, 65535}));
}

TEST(Png, converts_channels_when_asked) {
  const TemporaryFolder folder("png_channels");
  save_png(folder / "grey.png", grey<std::uint8_t>(1, 1, {77}));
  EXPECT_EQ(load8(folder / "grey.png", 4).samples, (std::vector<std::uint8_t>{77, 77, 77, 255}));
  save_png(folder / "rgb.png", four_colors());
  EXPECT_EQ(load8(folder / "rgb.png", 4).channels, 4);
  EXPECT_EQ(load8(folder / "rgb.png", 4).at(1, 0, 3), 255);
  EXPECT_EQ(load8(folder / "rgb.png", 1).at(1, 1), 255);
  EXPECT_THROW(load8(folder / "rgb.png", 5), Error);
  EXPECT_THROW(load8(folder / "rgb.png", -1), Error);
}

TEST(PngText, comes_back_in_order) {
  const TemporaryFolder folder("png_text");
  const std::vector<Text> texts = {{"lab", "lab05_normal_map"},
                                   {"parameters", "--method gram_schmidt\n--light-angle 30"},
                                   {"renderer", "Größe 3 µm, 法線"},
                                   {"lab", "a key may come twice"}};
  save_png(folder / "a.png", four_colors(), texts);
  EXPECT_EQ(read_png_text(folder / "a.png"), texts);
  EXPECT_EQ(load8(folder / "a.png"), four_colors());
}

TEST(PngText, is_left_out_when_its_value_is_empty) {
  const TemporaryFolder folder("png_empty_text");
  const std::vector<Text> texts = {{"first", "1"}, {"parameters", ""}, {"last", "2"}};
  save_png(folder / "a.png", four_colors(), texts);
  EXPECT_EQ(read_png_text(folder / "a.png"), (std::vector<Text>{texts[0], texts[2]}));
}

TEST(PngText, is_empty_when_there_is_none) {
  const TemporaryFolder folder("png_no_text");
  save_png(folder / "a.png", four_colors());
  EXPECT_TRUE(read_png_text(folder / "a.png").empty());
}

TEST(PngText, is_refused_and_no_file_left_when_it_cannot_be_held) {
  const TemporaryFolder folder("png_bad_text");
  const std::vector<Text> bad = {{"", "value"},          {std::string(80, 'k'), "value"},
                                 {" space", "value"},    {"two  spaces", "value"},
                                 {"schlüssel", "value"}, {"key", std::string("a\0b", 3)}};
  for (const Text& text : bad) {
    const std::string message =
        error_of([&] { save_png(folder / "a.png", four_colors(), std::span(&text, 1)); });
    EXPECT_TRUE(has(message, "a.png")) << text.key;
    EXPECT_TRUE(has(message, "79 printable")) << message;
  }
  EXPECT_TRUE(folder.empty());
}

TEST(PngText, is_an_error_when_the_file_is_no_png) {
  const TemporaryFolder folder("png_text_rubbish");
  write_file(folder / "a.png", "rubbish");
  EXPECT_TRUE(has(error_of([&] { read_png_text(folder / "a.png"); }), "a.png"));
  write_file(folder / "empty.png", "");
  EXPECT_TRUE(has(error_of([&] { read_png_text(folder / "empty.png"); }), "empty.png"));
  EXPECT_TRUE(has(error_of([&] { read_png_text(folder / "none.png"); }), "none.png"));
}

TEST(Save, leaves_no_file_when_it_fails) {
  const TemporaryFolder folder("save_fails");
  EXPECT_TRUE(has(error_of([&] { save_png(folder / "a.png", Image8{}); }), "a.png"));
  EXPECT_TRUE(has(error_of([&] { save_pfm(folder / "a.pfm", ImageF{}); }), "a.pfm"));
  EXPECT_TRUE(has(error_of([&] { save_png(folder / "no/folder.png", four_colors()); }), "folder.png"));
  EXPECT_TRUE(has(error_of([&] { save_png(folder / "a.png", four_colors(), {}, 99); }), "a.png"));
  EXPECT_TRUE(folder.empty());
}

TEST(Save, keeps_the_old_file_when_it_fails) {
  const TemporaryFolder folder("save_keeps");
  save_png(folder / "a.png", four_colors());
  EXPECT_NE(error_of([&] { save_png(folder / "a.png", Image8{}); }), "");
  EXPECT_EQ(load8(folder / "a.png"), four_colors());
}

TEST(Load, reads_the_same_picture_from_every_format) {
  const TemporaryFolder folder("formats");
  const std::vector<std::pair<std::string, std::string>> files = {{"a.bmp", test::bmp_2x2()},
                                                                  {"a.tga", test::tga_2x2()},
                                                                  {"rle.tga", test::tga_rle_2x2()},
                                                                  {"a.gif", test::gif_2x2()}};
  for (const auto& [name, content] : files) {
    write_file(folder / name, content);
    EXPECT_EQ(load8(folder / name, 3), four_colors()) << name;
    const Info header = info(folder / name);
    EXPECT_EQ(header.width, 2) << name;
    EXPECT_EQ(header.height, 2) << name;
  }
}

TEST(Load, reads_jpeg) {
  const TemporaryFolder folder("jpeg");
  write_file(folder / "a.jpg", test::jpeg_8x8());
  EXPECT_EQ(load8(folder / "a.jpg"), grey<std::uint8_t>(8, 8, std::vector<std::uint8_t>(64, 100)));
  Image8 color(16, 16, 3);
  color.samples.assign(color.samples.size(), 128);
  for (const bool progressive : {false, true}) {
    write_file(folder / "a.jpg", test::jpeg_16x16(progressive));
    EXPECT_EQ(load8(folder / "a.jpg"), color) << "progressive: " << progressive;
  }
}

TEST(Load, reads_what_stands_before_the_end_of_a_file) {
  const TemporaryFolder folder("trailing");
  // Much of it looks like tables: a phone's film, a second picture, a stamp.
  const std::string film = bytes({0, 0xff, 0xc4, 0xff, 0xff, 0xff, 0xc0}) + std::string(500, '\xff');
  for (const std::string& content :
       {test::jpeg_8x8(), test::jpeg_16x16(true), test::png(1, 1, 8, 0, bytes({0, 7})) + "IDAT",
        test::bmp_2x2(), test::tga_2x2(), test::gif_2x2()}) {
    write_file(folder / "plain", content);
    EXPECT_EQ(load_error(folder, "a", content + film), "");
    EXPECT_EQ(load8(folder / "a"), load8(folder / "plain"));
  }
}

TEST(Load, turns_a_photo_as_the_camera_was_held) {
  const TemporaryFolder folder("orientation");
  // The blocks' greys, top row first (CIPA DC-008, 4.6.4).
  const std::vector<std::vector<std::uint8_t>> shown = {
      {144, 169, 138, 158, 176, 159}, {138, 169, 144, 159, 176, 158}, {159, 176, 158, 138, 169, 144},
      {158, 176, 159, 144, 169, 138}, {144, 158, 169, 176, 138, 159}, {158, 144, 176, 169, 159, 138},
      {159, 138, 176, 169, 158, 144}, {138, 159, 169, 176, 144, 158}};
  for (int orientation = 0; orientation <= 9; ++orientation)
    for (const bool little_endian : {false, true}) {
      write_file(folder / "a.jpg", test::jpeg_of_camera(orientation, little_endian));
      const Image8 photo = load8(folder / "a.jpg");
      const Info header = info(folder / "a.jpg");
      const bool upright = orientation >= 5 && orientation <= 8;
      EXPECT_EQ(std::pair(photo.width, photo.height), upright ? std::pair(16, 24) : std::pair(24, 16));
      EXPECT_EQ(std::pair(header.width, header.height), std::pair(photo.width, photo.height));
      std::vector<std::uint8_t> blocks;
      for (int y = photo.height - 4; y > 0; y -= 8)
        for (int x = 4; x < photo.width; x += 8) blocks.push_back(photo.at(x, y));
      const bool is_known = orientation >= 1 && orientation <= 8;
      EXPECT_EQ(blocks, shown[is_known ? static_cast<std::size_t>(orientation) - 1 : 0]) << orientation;
    }
}

TEST(Load, reads_every_order_of_rows_columns_and_palettes) {
  const TemporaryFolder folder("orders");
  const std::string rows = test::tga_2x2().substr(18);
  const auto tga = [&](int palette, int kind, int first, int entries, int index_bits, int order) {
    return bytes({2, palette, kind, first, 0, entries, 0, palette * 24, 0, 0, 0, 0, 2, 0, 2, 0, index_bits,
                  order}) +
           "ID";
  };
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
      bmp,
      tga(0, 2, 0, 0, 24, 0) + pixels({0, 1, 2, 3}) + footer,
      tga(0, 2, 0, 0, 24, 0x10) + pixels({1, 0, 3, 2}),
      tga(0, 2, 0, 0, 24, 0x20) + pixels({2, 3, 0, 1}),
      tga(0, 2, 0, 0, 24, 0x30) + pixels({3, 2, 1, 0}),
      tga(0, 10, 0, 0, 24, 0x30) + bytes({3}) + pixels({3, 2, 1, 0}) + footer,
      tga(1, 1, 0, 4, 8, 0x30) + rows + bytes({3, 2, 1, 0}),
      tga(1, 1, 7, 4, 8, 0) + rows + bytes({7, 8, 9, 10}),
      tga(1, 9, 200, 4, 8, 0) + rows + bytes({3, 200, 201, 202, 203}) + footer,
      tga(1, 2, 0, 4, 24, 0) + std::string(12, 'p') + pixels({0, 1, 2, 3})};  // a palette that is not used
  for (std::size_t i = 0; i < files.size(); ++i) {
    EXPECT_EQ(load_error(folder, "a", files[i]), "") << i;
    EXPECT_EQ(load8(folder / "a"), four_colors()) << i;
  }
}

TEST(Load, names_a_variant_that_is_not_read) {
  const TemporaryFolder folder("variants");
  const auto jpeg = [](int frame, int bits) {
    std::string file = test::jpeg_16x16(false);
    const std::size_t at = file.find("\xff\xc0");
    file[at + 1] = static_cast<char>(frame), file[at + 4] = static_cast<char>(bits);
    return file;
  };
  std::string inks = jpeg(0xc0, 8);
  inks[inks.find("\xff\xc0") + 9] = 4;
  std::string packed_bmp = test::bmp_2x2(), interleaved = test::tga_2x2();
  packed_bmp[30] = 1;
  interleaved[17] = '\x40';
  const std::vector<std::pair<std::string, std::string>> files = {
      {jpeg(0xc0, 12), "JPEG of 12 bits a sample"},
      {jpeg(0xc9, 8), "JPEG with arithmetic coding"},
      {jpeg(0xc3, 8), "lossless JPEG"},
      {jpeg(0xc5, 8), "hierarchical JPEG"},
      {inks, "JPEG of four channels"},
      {packed_bmp, "run-length-encoded BMP"},
      {interleaved, "TGA file with interleaved rows"},
      {std::string(30, 'x') + "TRUEVISION-XFILE." + '\0', "TGA file of an unusual kind"},
      {"RIFF1234WEBPVP8 ", "is a WebP file"},
      {bytes({0, 0, 0, 28}) + "ftypavif", "is an AVIF file"},
      {bytes({0, 0, 0, 28}) + "ftypheic", "is a HEIC file"},
      {"\xabKTX 20\xbb", "is a KTX file"},
      {"DDS |", "is a DDS file"},
      {"#?RADIANCE\n", "is a Radiance HDR file"},
      {bytes({'I', 'I', 42, 0}), "is a TIFF file"},
      {"P6\n1 1\n65535\n123456", "is a PPM file"},
      {"<!DOCTYPE html>", "is a file of text"}};
  for (const auto& [content, variant] : files) {
    const std::string message = load_error(folder, "a.png", content);
    EXPECT_TRUE(has(message, variant) && has(message, "a.png: ") && has(message, "PNG, JPEG")) << message;
  }
}

TEST(Load, refuses_a_jpeg_whose_tables_do_not_fit) {
  const TemporaryFolder folder("jpeg_tables");
  std::string huffman = test::jpeg_16x16(false);
  huffman[huffman.find("\xff\xc4") + 5 + 12] = '\xff';  // 256 codes with the one that there is
  EXPECT_FALSE(has(load_error(folder, "a.jpg", huffman), "impossible"));
  huffman[huffman.find("\xff\xc4") + 5 + 13] = '\x01';
  EXPECT_TRUE(has(load_error(folder, "a.jpg", huffman), "invalid JPEG tables"));
  EXPECT_TRUE(has(load_error(folder, "a.jpg", "\xff" + huffman), "invalid JPEG tables"));
  std::string sampling = test::jpeg_16x16(false);
  sampling[sampling.find("\x01\x22") + 1] = '\x32';  // three across, of which two are no whole part
  sampling[sampling.find("\x02\x11") + 1] = '\x21';
  EXPECT_TRUE(has(load_error(folder, "a.jpg", sampling), "invalid JPEG tables"));
}

TEST(Load, names_the_file_and_the_remedy_when_it_is_no_picture) {
  const TemporaryFolder folder("no_picture");
  for (const std::string& content : {std::string(), std::string("rubbish"), std::string(1000, '\0'),
                                     std::string(1000, '\xff'), std::string("v 1 2 3\nf 1 2 3\n")}) {
    const std::string message = load_error(folder, "a.png", content);
    EXPECT_TRUE(has(message, "a.png")) << message;
    EXPECT_TRUE(has(message, "PNG, JPEG, GIF, BMP or TGA")) << message;
    EXPECT_NE(error_of([&] { info(folder / "a.png"); }), "");
    EXPECT_NE(error_of([&] { load16(folder / "a.png"); }), "");
  }
  EXPECT_TRUE(has(error_of([&] { load8(folder / "none.png"); }), "none.png"));
  EXPECT_NE(error_of([&] { load8(folder / "."); }), "");
}

TEST(Load, is_an_error_wherever_the_file_is_cut) {
  const TemporaryFolder folder("cut");
  save_png(folder / "whole.png", counted(9, 9, 3));
  const std::string first_frame = test::gif_2x2().substr(0, 25 + test::gif_frame({}).size());
  const std::vector<std::pair<std::string, std::string>> files = {
      {"a.png", read_file(folder / "whole.png")},
      {"a.jpg", test::jpeg_8x8()},
      {"b.jpg", test::jpeg_16x16(false)},
      {"c.jpg", test::jpeg_16x16(true)},
      {"a.bmp", test::bmp_2x2().substr(0, 68)},  // the last row's filling is not missed
      {"a.tga", test::tga_2x2()},
      {"rle.tga", test::tga_rle_2x2()},
      {"a.gif", first_frame}};
  for (const auto& [name, content] : files) {
    EXPECT_EQ(load_error(folder, name, content), "") << name;
    for (std::size_t size = 0; size < content.size(); ++size)
      EXPECT_TRUE(has(load_error(folder, name, content.substr(0, size)), name)) << name << " " << size;
  }
}

TEST(Load, refuses_a_picture_that_is_too_large_by_its_header) {
  const TemporaryFolder folder("too_large");
  for (const auto& [width, height] : {std::pair<std::uint32_t, std::uint32_t>{100000, 100000},
                                      {16385, 1},
                                      {1, 16385},
                                      {16384, 16384},  // three channels are beyond 2^28 samples
                                      {0xffffffff, 0xffffffff}}) {
    const std::string message =
        load_error(folder, "large.png", test::png(width, height, 8, 2, bytes({0, 1, 2, 3})));
    EXPECT_TRUE(has(message, "large.png")) << message;
    EXPECT_TRUE(has(message, "of 3 channels are too large")) << message;
    EXPECT_TRUE(has(message, "16384")) << message;
  }
}

TEST(Load, refuses_a_png_with_a_wrong_checksum_and_names_the_chunk) {
  const TemporaryFolder folder("checksum");
  const std::vector<Text> texts = {{"lab", "a text"}};
  save_png(folder / "a.png", Image8(9, 7, 3), texts);
  const std::string sound = read_file(folder / "a.png");
  for (const auto& [chunk, place] : {std::pair{"IHDR", 17U}, {"IDAT", 6U}}) {  // in the checksum, in the data
    std::string spoilt = sound;
    spoilt[sound.find(chunk) + place] ^= 1;
    const std::string message = load_error(folder, "a.png", spoilt);
    EXPECT_TRUE(has(message, std::string("checksum of its chunk ") + chunk + " is wrong")) << message;
  }
  std::string text = sound;
  text[sound.find("a text")] = 'b';
  EXPECT_EQ(load_error(folder, "a.png", text), "") << "no part of the picture";
}

TEST(Load, refuses_a_tiny_file_with_a_huge_header) {
  const TemporaryFolder folder("huge_header");
  const std::string message =
      load_error(folder, "huge.png", test::png(16384, 16384, 8, 0, bytes({0, 1, 2, 3})));
  EXPECT_TRUE(has(message, "cut short")) << message;
}

TEST(Pfm, keeps_every_value_when_saved_and_loaded) {
  const TemporaryFolder folder("pfm_round_trip");
  ImageF image(2, 2, 3);
  image.samples = {0, -0.0F, 1, 1e-40F, 1e38F, -3.5F, infinity, -infinity, 0.1F, 7, 8, 9};
  save_pfm(folder / "a.pfm", image);
  EXPECT_EQ(load_pfm(folder / "a.pfm"), image);

  const ImageF with_nan = grey<float>(3, 1, {1, nan, 2});
  save_pfm(folder / "b.pfm", with_nan);
  const ImageF back = load_pfm(folder / "b.pfm");
  EXPECT_EQ(back.channels, 1);
  EXPECT_TRUE(std::isnan(back.at(1, 0)));
  EXPECT_EQ(back.at(2, 0), 2);
}

TEST(Pfm, is_little_endian_and_bottom_row_first) {
  const TemporaryFolder folder("pfm_bytes");
  save_pfm(folder / "a.pfm", grey<float>(1, 2, {1, -2}));  // 1 is 3f800000, -2 is c0000000
  EXPECT_EQ(read_file(folder / "a.pfm"), "Pf\n1 2\n-1.0\n" + bytes({0, 0, 0x80, 0x3f, 0, 0, 0, 0xc0}));
}

TEST(Pfm, reads_big_endian) {
  const TemporaryFolder folder("pfm_big");
  write_file(folder / "a.pfm", "PF 1 1 1.0\n" + bytes({0x3f, 0x80, 0, 0, 0xc0, 0, 0, 0, 0x40, 0, 0, 0}));
  EXPECT_EQ(load_pfm(folder / "a.pfm").samples, (std::vector<float>{1, -2, 2}));
}

TEST(Pfm, has_three_channels_when_the_picture_has_two_or_four) {
  const TemporaryFolder folder("pfm_channels");
  ImageF two(1, 1, 2);
  two.samples = {1, 2};
  save_pfm(folder / "two.pfm", two);
  EXPECT_EQ(load_pfm(folder / "two.pfm").samples, (std::vector<float>{1, 2, 0}));
  ImageF four(2, 1, 4);
  four.samples = {1, 2, 3, 4, 5, 6, 7, 8};
  save_pfm(folder / "four.pfm", four);
  EXPECT_EQ(load_pfm(folder / "four.pfm").samples, (std::vector<float>{1, 2, 3, 5, 6, 7}));
}

TEST(Pfm, is_an_error_when_header_or_size_are_wrong) {
  const TemporaryFolder folder("pfm_bad");
  const std::string four_bytes(4, '\0');
  for (const std::string& content :
       {std::string(), std::string("P"), std::string("PF"), std::string("Pf\n1 1\n-1.0\n"),
        "P6\n1 1\n-1.0\n" + four_bytes, "Pf\n0 1\n-1.0\n" + four_bytes, "Pf\n-1 -1\n-1.0\n" + four_bytes,
        "Pf\n1 x\n-1.0\n" + four_bytes, "Pf\n1 1\n0\n" + four_bytes, "Pf\n1 1\nnan\n" + four_bytes,
        "Pf\n1 1\ninf\n" + four_bytes, "Pf\n1 1\n-1.0\n" + four_bytes + "x", "PF\n1 1\n-1.0\n" + four_bytes,
        "Pf\n100000 100000\n-1.0\n" + four_bytes, "Pf\n16384 16384\n-1.0\n" + four_bytes,
        "Pf\n99999999999999999999 1\n-1.0\n" + four_bytes, std::string(1000, 'P'),
        "Pf\n1 1\n-1.0x\n" + four_bytes}) {
    write_file(folder / "a.pfm", content);
    EXPECT_TRUE(has(error_of([&] { load_pfm(folder / "a.pfm"); }), "a.pfm")) << content;
  }
}

TEST(Srgb, follows_the_standard_curve) {
  // IEC 61966-2-1: 0.04045 ends the straight part; 0.5 encodes to 0.7353569831 and 0.5 decodes to
  // 0.2140411405. The double differs from these ten digits by at most their rounding.
  EXPECT_NEAR(linear_from_srgb(0.04045), 0.04045 / 12.92, 1e-15);
  EXPECT_NEAR(srgb_from_linear(0.5), 0.7353569831, 5e-11);
  EXPECT_NEAR(linear_from_srgb(0.5), 0.2140411405, 5e-11);
  EXPECT_EQ(linear_from_srgb(0.0F), 0.0F);
  EXPECT_EQ(linear_from_srgb(1.0F), 1.0F);
  EXPECT_EQ(srgb_from_linear(0.0F), 0.0F);
  EXPECT_EQ(srgb_from_linear(1.0F), 1.0F);
  // The two are inverse: a few roundings of a double near 1 (measured: 4e-16).
  for (int i = 0; i <= 1000; ++i)
    EXPECT_NEAR(srgb_from_linear(linear_from_srgb(i / 1000.0)), i / 1000.0, 2e-15);
}

TEST(Encoding8, gives_every_sample_back) {
  for (int i = 0; i < 256; ++i) {
    const auto sample = static_cast<std::uint8_t>(i);
    EXPECT_EQ(to_encoding8(from_encoding8(sample)), sample);
    EXPECT_EQ(to_encoding8(from_encoding8(sample, Encoding::linear), Encoding::linear), sample);
  }
}

TEST(Encoding8, rounds_as_the_curve_says_everywhere) {
  int differing = 0;
  for (int i = 0; i <= 100000; ++i) {
    const float linear = static_cast<float>(i) / 100000.0F;
    const double exact = srgb_from_linear(static_cast<double>(linear)) * 255;
    if (to_encoding8(linear) != static_cast<int>(std::floor(exact + 0.5))) ++differing;
  }
  EXPECT_EQ(differing, 0);
}

TEST(Encoding8, rounds_half_up_and_clamps) {
  EXPECT_EQ(to_encoding8(0.5F, Encoding::linear), 128);  // 127.5
  EXPECT_EQ(to_encoding8(0.5F, Encoding::srgb), 188);    // 187.516
  for (const Encoding encoding : {Encoding::srgb, Encoding::linear}) {
    EXPECT_EQ(to_encoding8(-1, encoding), 0);
    EXPECT_EQ(to_encoding8(2, encoding), 255);
    EXPECT_EQ(to_encoding8(infinity, encoding), 255);
    EXPECT_EQ(to_encoding8(-infinity, encoding), 0);
    EXPECT_EQ(to_encoding8(nan, encoding), 0);
    EXPECT_EQ(to_encoding8(std::nextafter(1.0F, 0.0F), encoding), 255);
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
}

TEST(Heat, clamps_and_marks_nan) {
  EXPECT_EQ(heat(-1), heat(0));
  EXPECT_EQ(heat(infinity), heat(1));
  EXPECT_EQ(heat(nan), (std::array<float, 3>{0, 1, 0}));
}

TEST(MipChain, has_every_level_down_to_one_texel) {
  const std::vector<Image8> chain = mip_chain(counted(20, 5, 3), Encoding::srgb);
  const std::vector<std::pair<int, int>> sizes = {{20, 5}, {10, 2}, {5, 1}, {2, 1}, {1, 1}};
  ASSERT_EQ(chain.size(), sizes.size());
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    EXPECT_EQ(chain[i].width, sizes[i].first);
    EXPECT_EQ(chain[i].height, sizes[i].second);
    EXPECT_EQ(chain[i].channels, 3);
  }
  EXPECT_EQ(chain[0], counted(20, 5, 3));
}

TEST(MipChain, is_the_picture_alone_when_it_has_one_texel) {
  EXPECT_EQ(mip_chain(counted(1, 1, 4), Encoding::srgb), std::vector<Image8>{counted(1, 1, 4)});
}

TEST(MipChain, averages_color_in_linear_light) {
  Image8 checker(8, 8, 1);
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) checker.at(x, y) = (x + y) % 2 == 0 ? 255 : 0;
  const auto below = [&](Encoding encoding) {
    std::vector<Image8> chain = mip_chain(checker, encoding);
    chain.erase(chain.begin());
    return chain;
  };
  const auto filled = [](std::uint8_t value) {
    std::vector<Image8> chain;
    for (const int size : {4, 2, 1})
      chain.push_back(
          grey(size, size, std::vector<std::uint8_t>(static_cast<std::size_t>(size * size), value)));
    return chain;
  };
  EXPECT_EQ(below(Encoding::srgb), filled(188));    // linear 0.5 is 187.516
  EXPECT_EQ(below(Encoding::linear), filled(128));  // 127.5, half up
}

TEST(MipChain, averages_alpha_as_it_is_and_apart_from_color) {
  Image8 image(2, 1, 4);
  image.samples = {255, 0, 100, 0, 0, 0, 100, 255};
  EXPECT_EQ(mip_chain(image, Encoding::srgb)[1].samples, (std::vector<std::uint8_t>{188, 0, 100, 128}));
  Image8 grey_alpha(2, 1, 2);
  grey_alpha.samples = {255, 255, 0, 0};
  EXPECT_EQ(mip_chain(grey_alpha, Encoding::srgb)[1].samples, (std::vector<std::uint8_t>{188, 128}));
}

TEST(MipChain, weighs_by_the_covered_area_when_a_side_is_odd) {
  // 5 texels become 2 of 2.5 each: weights 2 2 1 0 0 and 0 0 1 2 2, over 5.
  const Image8 row = grey<std::uint8_t>(5, 1, {10, 20, 30, 40, 50});
  EXPECT_EQ(mip_chain(row, Encoding::linear)[1].samples, (std::vector<std::uint8_t>{18, 42}));
  // 7 become 3 of 7/3: 3 3 1 0 0 0 0, 0 0 2 3 2 0 0 and 0 0 0 0 1 3 3, over 7; upright here.
  const Image8 column = grey<std::uint8_t>(1, 7, {7, 14, 70, 0, 140, 70, 7});
  // (21 + 42 + 70) / 7, (140 + 0 + 280) / 7, (140 + 210 + 21) / 7
  EXPECT_EQ(mip_chain(column, Encoding::linear)[1].samples, (std::vector<std::uint8_t>{19, 60, 53}));
  // 3x3 become the plain mean of all nine.
  const Image8 square = grey<std::uint8_t>(3, 3, {0, 10, 20, 30, 40, 50, 60, 70, 80});
  EXPECT_EQ(mip_chain(square, Encoding::linear)[1].samples, (std::vector<std::uint8_t>{40}));
}

TEST(MipChain, keeps_the_mean_over_all_levels) {
  // The last level is the mean of all texels and is rounded once, since no level is rounded on the way.
  const Image8 image = counted(37, 23, 1);
  double sum = 0;
  for (const std::uint8_t sample : image.samples) sum += sample;
  const double mean = sum / static_cast<double>(image.samples.size());
  EXPECT_EQ(mip_chain(image, Encoding::linear).back().at(0, 0), std::floor(mean + 0.5));
}

TEST(Difference, is_zero_when_the_pictures_are_the_same) {
  const Difference difference = compare(four_colors(), four_colors());
  EXPECT_EQ(difference.width, 2);
  EXPECT_EQ(difference.height, 2);
  EXPECT_EQ(difference.max, 0);
  EXPECT_EQ(difference.mean, 0);
  EXPECT_EQ(difference.p99, 0);
  EXPECT_EQ(difference.non_finite, 0);
}

TEST(Difference, counts_red_green_and_blue_but_not_alpha) {
  Image8 a(2, 1, 4);
  Image8 b(2, 1, 4);
  a.samples = {10, 20, 30, 0, 1, 2, 3, 0};
  b.samples = {12, 17, 30, 255, 1, 2, 3, 9};
  const Difference difference = compare(a, b);
  EXPECT_EQ(difference.max, 3);
  EXPECT_DOUBLE_EQ(difference.mean, 5.0 / 6);
  EXPECT_EQ(difference.p99, 3);
}

TEST(Difference, takes_grey_as_rgb) {
  Image8 rgb(1, 1, 3);
  rgb.samples = {10, 20, 30};
  const Difference difference = compare(rgb, grey<std::uint8_t>(1, 1, {20}));
  EXPECT_EQ(difference.max, 10);
  EXPECT_DOUBLE_EQ(difference.mean, 20.0 / 3);
}

TEST(Difference, takes_the_nearest_rank_for_p99) {
  // Pixel i differs by i. Of 100 the 99th in order counts, of 101 the 100th (ceil(99.99)), of 1 the first.
  for (const auto& [pixels, expected] : {std::pair{100, 98}, {101, 99}, {200, 197}, {1, 0}, {2, 1}}) {
    const Image8 black(pixels, 1, 1);
    Image8 ramp(pixels, 1, 1);
    for (int x = 0; x < pixels; ++x) ramp.at(x, 0) = static_cast<std::uint8_t>(x);
    EXPECT_EQ(compare(black, ramp).p99, expected) << pixels;
    EXPECT_EQ(compare(black, ramp).max, pixels - 1) << pixels;
  }
}

TEST(Difference, looks_only_where_the_mask_is_light) {
  const Image8 a = grey<std::uint8_t>(3, 1, {0, 0, 0});
  const Image8 b = grey<std::uint8_t>(3, 1, {9, 2, 4});
  const Image8 mask = grey<std::uint8_t>(3, 1, {0, 255, 1});
  EXPECT_EQ(compare(a, b, {.mask = &mask}).max, 4);
  EXPECT_EQ(compare(a, b, {.mask = &mask}).mean, 3);
  const Image8 dark(3, 1, 1);
  EXPECT_NE(error_of([&] { compare(a, b, {.mask = &dark}); }), "");
  const Image8 small(2, 1, 1);
  EXPECT_NE(error_of([&] { compare(a, b, {.mask = &small}); }), "");
}

TEST(Difference, is_an_error_when_sizes_or_channels_differ) {
  EXPECT_TRUE(has(error_of([] { compare(Image8(2, 3, 1), Image8(3, 2, 1)); }), "2x3 and 3x2"));
  EXPECT_NE(error_of([] { heatmap(Image8(2, 3, 1), Image8(3, 2, 1)); }), "");
  EXPECT_NE(error_of([] { compare(Image8(), Image8()); }), "");
  EXPECT_NE(error_of([] { compare(ImageF(1, 1, 1), ImageF(1, 1, 3)); }), "");
  EXPECT_NE(error_of([] { compare(ImageF(1, 1, 2), ImageF(1, 1, 2), {.unit = Unit::degrees}); }), "");
}

TEST(FloatDifference, counts_and_leaves_out_what_is_not_finite) {
  const ImageF a = grey<float>(5, 1, {1, nan, 3, 4, nan});
  const ImageF b = grey<float>(5, 1, {1.5F, 2, infinity, 5, nan});
  const Difference difference = compare(a, b);
  EXPECT_EQ(difference.non_finite, 3);
  EXPECT_EQ(difference.max, 1);
  EXPECT_EQ(difference.mean, 0.75);
  EXPECT_EQ(difference.p99, 1);
}

TEST(FloatDifference, has_figures_of_zero_when_nothing_is_finite) {
  const ImageF a = grey<float>(2, 1, {nan, nan});
  const Difference difference = compare(a, a);
  EXPECT_EQ(difference.non_finite, 2);
  EXPECT_EQ(difference.max, 0);
  EXPECT_EQ(difference.mean, 0);
}

/// The difference of two directions, one pixel each.
Difference between(std::vector<float> a, std::vector<float> b) {
  ImageF first(1, 1, 3);
  ImageF second(1, 1, 3);
  first.samples = std::move(a);
  second.samples = std::move(b);
  return compare(first, second, {.unit = Unit::degrees});
}

TEST(FloatDifference, gives_directions_in_degrees) {
  // A few roundings of a double.
  EXPECT_NEAR(between({1, 0, 0}, {0, 2, 0}).max, 90, 1e-13);
  EXPECT_NEAR(between({1, 1, 0}, {5, 0, 0}).max, 45, 1e-13);
  EXPECT_NEAR(between({0, 0, 1}, {0, 0, -3}).max, 180, 1e-13);
  EXPECT_EQ(between({1, 2, 3}, {1, 2, 3}).max, 0);
  // acos of the dot product would give 0 here: 1e-6 radians, whose cosine rounds to 1 in floats.
  EXPECT_NEAR(between({1, 0, 0}, {1, 1e-6F, 0}).max, 1e-6 * 180 / 3.14159265358979, 1e-11);
}

TEST(FloatDifference, tells_a_missing_direction_from_background) {
  EXPECT_EQ(between({0, 0, 0}, {0, 0, 1}).max, 180);
  EXPECT_EQ(between({0, 0, 1}, {0, 0, 0}).max, 180);
  ImageF a(2, 1, 3);
  ImageF b(2, 1, 3);
  a.samples = {0, 0, 0, 1, 0, 0};
  b.samples = {0, 0, 0, 0, 1, 0};
  EXPECT_NEAR(compare(a, b, {.unit = Unit::degrees}).mean, 90,
              1e-13);  // of the one pixel that has a direction
  EXPECT_EQ(between({nan, 0, 0}, {1, 0, 0}).non_finite, 1);
}

TEST(FloatDifference, gives_texture_coordinates_in_texels) {
  ImageF a(2, 1, 3);
  ImageF b(2, 1, 3);
  a.samples = {0.5F, 0.25F, 7, 0, 0, 0};
  b.samples = {0.5F + 3.0F / 512, 0.25F + 4.0F / 256, -7, 0, 0, 1};  // the third channel is none of it
  Comparing comparing = {.unit = Unit::texels, .texture_width = 512, .texture_height = 256};
  EXPECT_DOUBLE_EQ(compare(a, b, comparing).max, 5);  // 3 and 4 texels: all numbers are exact in floats
  EXPECT_DOUBLE_EQ(compare(a, b, comparing).mean, 2.5);
  comparing.texture_height = 512;
  EXPECT_DOUBLE_EQ(compare(a, b, comparing).max, std::hypot(3.0, 8.0));
  a.at(1, 0, 1) = nan;
  EXPECT_EQ(compare(a, b, comparing).non_finite, 1);
  EXPECT_NE(error_of([&] { compare(ImageF(2, 1, 1), ImageF(2, 1, 1), comparing); }), "");
}

/// A disc with hard edges on a background that grows lighter by 2 steps a pixel; what lies inside is rows of
/// a soft wave.
Image8 disc(double center_x, double radius) {
  Image8 picture(100, 100, 1);
  for (int y = 0; y < 100; ++y)
    for (int x = 0; x < 100; ++x) {
      const double inside = 200 + 20 * std::sin(0.5 * (x - center_x)), outside = 20 + x;
      picture.at(x, y) =
          static_cast<std::uint8_t>(std::hypot(x - center_x, y - 50) < radius ? inside : outside);
    }
  return picture;
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

TEST(EdgeTolerance, forgives_a_pixel_of_an_edge) {
  const Image8 a = disc(50, 30), b = rasterised_otherwise(a, 5);
  EXPECT_GT(compare(a, b).max, 50);
  EXPECT_EQ(compare(a, b).forgiven, 0);
  const Difference tolerant = compare(a, b, {.edge_tolerance = true});
  EXPECT_EQ(tolerant.max, 0);  // each new value stands beside it in a, and each old one in b
  EXPECT_EQ(tolerant.mean, 0);
  EXPECT_EQ(tolerant.forgiven, 5);
}

TEST(EdgeTolerance, is_the_same_when_the_pictures_change_places) {
  for (const Image8& b : {rasterised_otherwise(disc(50, 30), 9), disc(50.1, 30), disc(52, 29)}) {
    const Difference forth = compare(disc(50, 30), b, {.edge_tolerance = true});
    const Difference back = compare(b, disc(50, 30), {.edge_tolerance = true});
    EXPECT_EQ(forth.mean, back.mean);
    EXPECT_EQ(forth.max, back.max);
    EXPECT_EQ(forth.forgiven, back.forgiven);
  }
}

TEST(EdgeTolerance, keeps_a_difference_in_the_interior) {
  const Image8 a = disc(50, 30);
  Image8 b = a;
  // With the wave's slope of 10 a pixel still below an edge's contrast.
  for (int x = 40; x < 60; ++x) b.at(x, 50) = static_cast<std::uint8_t>(b.at(x, 50) + 15);
  EXPECT_EQ(compare(a, b, {.edge_tolerance = true}).max, 15);
  EXPECT_EQ(compare(a, b, {.edge_tolerance = true}).mean, compare(a, b).mean);
}

TEST(EdgeTolerance, keeps_a_line_that_only_one_picture_has) {
  const Image8 a = disc(50, 30);
  Image8 b = a;
  for (int y = 48; y < 52; ++y) b.at(10, y) = 255;
  // In a's place each has a value near by, in b's the line has none.
  EXPECT_EQ(compare(a, b, {.edge_tolerance = true}).max, 255 - 20 - 10 - 1);
  EXPECT_EQ(compare(b, a, {.edge_tolerance = true}).max, 255 - 20 - 10 - 1);
}

/// A white square of 40x40, of whose rightmost column `missing` pixels are black.
Image8 square(int missing) {
  Image8 picture(60, 60, 1);
  for (int y = 10; y < 50; ++y)
    for (int x = 10; x < 50; ++x) picture.at(x, y) = x == 49 && y < 10 + missing ? 0 : 255;
  return picture;
}

TEST(EdgeTolerance, forgives_a_tenth_of_the_edge_pixels_at_most) {
  // The square's edge has 4 * 39 pixels within and 4 * 41 without; where the column is black, the one before
  // it is edge too: 320 + missing.
  EXPECT_EQ(compare(square(0), square(34), {.edge_tolerance = true}).forgiven, 34);
  EXPECT_EQ(compare(square(0), square(34), {.edge_tolerance = true}).max, 0);
  EXPECT_EQ(compare(square(0), square(38), {.edge_tolerance = true}).forgiven, 0);
  EXPECT_EQ(compare(square(0), square(38), {.edge_tolerance = true}).max, 255);
}

TEST(EdgeTolerance, forgives_nothing_when_the_picture_was_moved) {
  const Image8 a = disc(50, 30), moved = disc(51, 30);
  const Difference tolerant = compare(a, moved, {.edge_tolerance = true});
  EXPECT_EQ(tolerant.forgiven, 0);
  EXPECT_EQ(tolerant.mean, compare(a, moved).mean);
}

TEST(EdgeTolerance, looks_beyond_the_mask_but_counts_within) {
  const Image8 a = disc(50, 30), b = rasterised_otherwise(a, 3);
  Image8 mask(100, 100, 1);
  for (std::size_t i = 0; i < mask.samples.size(); ++i) mask.samples[i] = a.samples[i] > 170 ? 255 : 0;
  const Difference tolerant = compare(a, b, {.mask = &mask, .edge_tolerance = true});
  EXPECT_EQ(tolerant.forgiven, 3);  // by the background, which the mask leaves out
  EXPECT_EQ(tolerant.max, 0);
}

/// Directions that turn slowly inside a square, and none beside it.
ImageF turning_square(int right) {
  ImageF picture(60, 60, 3);
  for (int y = 10; y < 50; ++y)
    for (int x = 10; x < right; ++x) {
      picture.at(x, y, 0) = std::sin(0.01F * static_cast<float>(x));
      picture.at(x, y, 2) = std::cos(0.01F * static_cast<float>(x));
    }
  return picture;
}

TEST(EdgeTolerance, holds_for_directions_and_what_is_not_finite) {
  const ImageF a = turning_square(50);
  ImageF b = a;
  for (const int y : {20, 30, 40})
    for (int c = 0; c < 3; ++c) b.at(49, y, c) = 0;  // background instead
  const Comparing strict = {.unit = Unit::degrees},
                  tolerant = {.edge_tolerance = true, .unit = Unit::degrees};
  EXPECT_EQ(compare(a, b, strict).max, 180);
  EXPECT_EQ(compare(a, b, tolerant).max, 0);  // to the neighbours above and beside
  EXPECT_EQ(compare(a, b, tolerant).forgiven, 3);
  b.at(49, 20, 0) = nan;
  EXPECT_EQ(compare(a, b, tolerant).non_finite, 1);
  EXPECT_EQ(compare(a, b, tolerant).forgiven, 2);
  // The sides' own unit: an eighth of the spread of 0 to 1 and 0 to 0.48.
  EXPECT_EQ(compare(a, b, {.edge_tolerance = true}).forgiven, 2);
}

TEST(MovedPixels, take_away_what_the_part_of_a_slope_explains) {
  Image8 a(20, 20, 1);
  for (int y = 0; y < 20; ++y)
    for (int x = 0; x < 20; ++x) a.at(x, y) = static_cast<std::uint8_t>(x < 10 ? 100 : 100 + 8 * (x - 10));
  Image8 b = a;
  b.at(15, 5) = static_cast<std::uint8_t>(b.at(15, 5) + 2);  // a quarter of the slope of 8 a pixel
  b.at(15, 9) = static_cast<std::uint8_t>(b.at(15, 9) + 3);
  b.at(5, 5) = 102;  // where the picture is flat
  const Difference difference = compare(a, b, {.moved_pixels = 0.25});
  EXPECT_EQ(difference.forgiven, 1);
  EXPECT_EQ(difference.max, 3);
  EXPECT_EQ(compare(a, b, {.moved_pixels = 0.4}).forgiven, 2);
  EXPECT_EQ(compare(a, b, {.moved_pixels = 0.4}).max, 2);
  EXPECT_EQ(compare(a, b).forgiven, 0);
}

std::vector<std::uint8_t> heat_samples(std::initializer_list<float> ts) {
  std::vector<std::uint8_t> samples;
  for (const float t : ts)
    for (const float value : heat(t)) samples.push_back(to_encoding8(value, Encoding::linear));
  return samples;
}

TEST(Heatmap, colors_each_pixel_by_its_largest_difference) {
  const Image8 a = grey<std::uint8_t>(3, 1, {0, 0, 0});
  const Image8 b = grey<std::uint8_t>(3, 1, {0, 10, 20});
  EXPECT_EQ(heatmap(a, b).samples, heat_samples({0, 0.5F, 1}));
  EXPECT_EQ(heatmap(a, b, 40).samples, heat_samples({0, 0.25F, 0.5F}));
  EXPECT_EQ(heatmap(a, b, 5).samples, heat_samples({0, 1, 1}));
  EXPECT_EQ(heatmap(a, a).samples, heat_samples({0, 0, 0}));
  const Image8 mask = grey<std::uint8_t>(3, 1, {255, 255, 0});
  EXPECT_EQ(heatmap(a, b, 20, {.mask = &mask}).samples, heat_samples({0, 0.5F, 0}));
}

TEST(Heatmap, is_green_where_a_value_is_not_finite) {
  const ImageF a = grey<float>(3, 1, {0, nan, 1});
  const ImageF b = grey<float>(3, 1, {0, 0, 3});
  EXPECT_EQ(heatmap(a, b, 2).samples, heat_samples({0, nan, 1}));
}

}  // namespace
}  // namespace texel::image
