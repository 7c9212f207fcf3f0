// SPDX-License-Identifier: MIT
// The program `texel`, run as a user runs it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <regex>

#include "../labs/labs.hpp"
#include "../support/picture_files.hpp"
#include "../support/process.hpp"
#include "../support/said.hpp"
#include "core/files.hpp"
#include "core/json.hpp"
#include "course/lab_file.hpp"
#include "gallery.hpp"
#include "image/difference.hpp"
#include "image/flip.hpp"
#include "image/load.hpp"
#include "image/save.hpp"
#include "image/ssim.hpp"

namespace texel {
namespace {

using image::Image8;
using image::ImageF;
using test::has;
using test::Result;
using test::shell;

Result texel(const std::string& arguments) {
  return shell(fmt::format("{}/texel {} 2>&1", test::kBin, arguments));
}

/// Pictures of 10x10 that are compared: `b` differs from `a` by 60 steps of red in one pixel, and is 15 steps
/// of green off in another.
class Compare : public testing::Test {
 protected:
  Compare() : folder_("tool") {
    Image8 a(10, 10, 3);
    std::fill(a.samples.begin(), a.samples.end(), std::uint8_t{100});
    image::save_png(file("a.png"), a);
    Image8 b = a;
    b.at(3, 4, 0) = 160;
    b.at(5, 5, 1) = 85;
    image::save_png(file("b.png"), b);
    Image8 mask(10, 10, 1);
    mask.at(5, 5) = 255;
    mask.at(0, 0) = 255;
    image::save_png(file("mask.png"), mask);
  }

  [[nodiscard]] std::string file(const std::string& name) const { return (folder_ / name).string(); }
  [[nodiscard]] Result compare(const std::string& a, const std::string& b,
                               const std::string& rest = {}) const {
    return texel(fmt::format("compare '{}' '{}' {}", file(a), file(b), rest));
  }

  /// A picture of one vector everywhere.
  void save_vector(const std::string& name, float x, float y, float z) const {
    ImageF picture(4, 4, 3);
    for (std::size_t i = 0; i < picture.samples.size(); i += 3) {
      picture.samples[i] = x;
      picture.samples[i + 1] = y;
      picture.samples[i + 2] = z;
    }
    image::save_pfm(file(name), picture);
  }

 private:
  test::TemporaryFolder folder_;
};

TEST_F(Compare, holds_when_the_pictures_are_the_same) {
  const Result result = compare("a.png", "a.png", "--json");
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.output,
            "{\"width\": 10, \"height\": 10, \"max\": 0, \"mean\": 0, \"p99\": 0, \"flip_mean\": 0, "
            "\"flip_p99\": 0, "
            "\"ssim\": 1, \"non_finite\": 0, \"flip_weighted_quartiles\": [0, 0, 0], \"forgiven\": 0, "
            "\"unit\": \"8-bit steps\"}\n");
}

TEST_F(Compare, differs_when_no_limit_is_given) {
  const Result result = compare("a.png", "b.png", "--json");
  EXPECT_EQ(result.exit_code, 1);
  // (60 + 15) steps over 300 samples; the pixel of rank 99 of 100 is the one of 15 steps.
  EXPECT_TRUE(has(result.output, "\"max\": 60, \"mean\": 0.25, \"p99\": 15,")) << result.output;
}

TEST_F(Compare, holds_up_to_its_limits) {
  EXPECT_EQ(compare("a.png", "b.png", "--max 60 --mean 0.25 --p99 15").exit_code, 0);
  EXPECT_EQ(compare("a.png", "b.png", "--mean 0.25").exit_code, 0);
  for (const char* limit : {"--max 59", "--mean 0.24", "--p99 14", "--max 60 --p99 14"})
    EXPECT_EQ(compare("a.png", "b.png", limit).exit_code, 1) << limit;
  EXPECT_TRUE(has(compare("a.png", "b.png", "--max 59").output, "max is 60, over the limit 59"));
}

TEST_F(Compare, looks_only_where_the_mask_is_light) {
  const Result result = compare("a.png", "b.png", fmt::format("--json --mask '{}'", file("mask.png")));
  EXPECT_TRUE(has(result.output, "\"max\": 15,")) << result.output;
}

TEST_F(Compare, writes_a_heat_map) {
  static_cast<void>(compare("a.png", "b.png", fmt::format("--heatmap '{}'", file("heat.png"))));
  const Image8 heat = image::load8(file("heat.png"));
  EXPECT_EQ(heat.width, 10);
  EXPECT_NE(heat.at(3, 4), heat.at(0, 0));
}

TEST_F(Compare, measures_directions_in_degrees) {
  save_vector("x.pfm", 1, 0, 0);
  save_vector("y.pfm", 0, 1, 0);
  EXPECT_TRUE(has(compare("x.pfm", "y.pfm", "--json").output, "\"max\": 90, \"mean\": 90, \"p99\": 90, "));
  EXPECT_TRUE(has(compare("x.pfm", "y.pfm", "--json --unit own").output, "\"max\": 1, "));
  save_vector("long.pfm", 3, 0, 0);
  EXPECT_TRUE(has(compare("long.pfm", "y.pfm", "--json").output, "\"max\": 3, "));
  EXPECT_TRUE(has(compare("long.pfm", "y.pfm", "--json --unit degrees").output, "\"max\": 90, "));
}

TEST_F(Compare, measures_texture_coordinates_in_texels) {
  save_vector("here.pfm", 0.25F, 0.5F, 0);
  save_vector("there.pfm", 0.25F + 3.0F / 512, 0.5F + 4.0F / 512, 0);
  const Result square = compare("here.pfm", "there.pfm", "--json --unit texels --texels 512");
  EXPECT_TRUE(has(square.output, "\"max\": 5, ")) << square.output;
  EXPECT_TRUE(has(square.output, "\"unit\": \"texels\"")) << square.output;
  // 3 texels of 512 and 4 / 512 of 1024
  EXPECT_TRUE(has(compare("here.pfm", "there.pfm", "--json --unit texels --texels 512x1024").output,
                  fmt::format("\"max\": {}, ", std::hypot(3.0, 8.0))));
}

TEST_F(Compare, prints_flip_and_ssim) {
  const Result text = compare("a.png", "b.png");
  for (const char* name : {"FLIP mean", "FLIP p99", "SSIM"})
    EXPECT_TRUE(has(text.output, name)) << text.output;
  const auto json = parse_json(compare("a.png", "b.png", "--json").output);
  const image::ImageF errors = image::flip_errors(image::load8(file("a.png")), image::load8(file("b.png")));
  EXPECT_EQ(json["flip_mean"], image::flip_figures(errors).mean);
  EXPECT_EQ(json["flip_p99"], image::flip_figures(errors).p99);
  EXPECT_EQ(json["flip_weighted_quartiles"][1], image::flip_figures(errors).median);
  EXPECT_EQ(json["ssim"], image::ssim(image::load8(file("a.png")), image::load8(file("b.png"))));
  // From farther away less is seen of two pixels.
  const auto far = parse_json(compare("a.png", "b.png", "--json --ppd 300").output);
  EXPECT_LT(far["flip_p99"], json["flip_p99"]);
}

TEST_F(Compare, has_no_flip_of_float_pictures) {
  save_vector("x.pfm", 1, 0, 0);
  const auto json = parse_json(compare("x.pfm", "x.pfm", "--json").output);
  for (const char* key : {"flip_mean", "flip_p99", "flip_weighted_quartiles", "ssim"})
    EXPECT_TRUE(json.at(key).is_null()) << key;
  EXPECT_FALSE(has(compare("x.pfm", "x.pfm").output, "FLIP"));
  for (const std::string rest : {"--flip 1", "--ppd 60", "--flip-heatmap f.png"})
    EXPECT_EQ(compare("x.pfm", "x.pfm", rest).exit_code, 2) << rest;
}

TEST_F(Compare, holds_up_to_the_limit_of_flip) {
  EXPECT_EQ(compare("a.png", "b.png", "--flip 1").exit_code, 0);
  const Result over = compare("a.png", "b.png", "--flip 0.001");
  EXPECT_EQ(over.exit_code, 1);
  EXPECT_TRUE(has(over.output, "texel: flip is ")) << over.output;
  EXPECT_TRUE(has(over.output, ", over the limit 0.001")) << over.output;
  EXPECT_EQ(compare("a.png", "b.png", "--flip 1 --max 59").exit_code, 1);
}

TEST_F(Compare, pools_flip_and_ssim_within_the_mask) {
  Image8 corner(10, 10, 1);
  corner.at(0, 9) = 255;
  image::save_png(file("corner.png"), corner);
  const auto whole = parse_json(compare("a.png", "b.png", "--json").output);
  const auto masked =
      parse_json(compare("a.png", "b.png", fmt::format("--json --mask '{}'", file("corner.png"))).output);
  // One pixel, 6 from the nearest difference: the filters still reach it.
  EXPECT_GT(masked["flip_mean"], 0);
  EXPECT_LT(masked["flip_mean"], whole["flip_mean"]);
  EXPECT_EQ(masked["flip_mean"], masked["flip_p99"]);
  EXPECT_GT(masked["ssim"], whole["ssim"]);
}

TEST_F(Compare, writes_the_heat_map_of_flip) {
  static_cast<void>(compare("a.png", "b.png", fmt::format("--flip-heatmap '{}'", file("flip.png"))));
  const image::ImageF errors = image::flip_errors(image::load8(file("a.png")), image::load8(file("b.png")));
  EXPECT_EQ(image::load8(file("flip.png")), image::flip_heatmap(errors));
}

TEST_F(Compare, forgives_edges_when_asked) {
  Image8 square(60, 60, 1);
  for (int y = 10; y < 50; ++y)
    for (int x = 10; x < 50; ++x) square.at(x, y) = 200;
  image::save_png(file("square.png"), square);
  square.at(49, 20) = 0;
  image::save_png(file("dent.png"), square);
  EXPECT_EQ(compare("square.png", "dent.png").exit_code, 1);
  const Result tolerant = compare("square.png", "dent.png", "--edge-tolerance");
  EXPECT_EQ(tolerant.exit_code, 0) << tolerant.output;
  EXPECT_TRUE(has(tolerant.output, "forgiven    1 pixels at edges")) << tolerant.output;
}

TEST_F(Compare, never_holds_when_a_pixel_is_not_finite) {
  save_vector("x.pfm", 1, 0, 0);
  save_vector("nan.pfm", 1, std::numeric_limits<float>::quiet_NaN(), 0);
  const Result result = compare("x.pfm", "nan.pfm", "--json --max 180");
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_TRUE(has(result.output, "\"non_finite\": 16")) << result.output;
}

TEST_F(Compare, fails_when_the_pictures_cannot_be_compared) {
  image::save_png(file("small.png"), Image8(5, 10, 3));
  write_file(file("cut.png"), read_file(file("a.png")).substr(0, 40));
  write_file(file("empty.png"), "");
  save_vector("x.pfm", 1, 0, 0);
  for (const char* other : {"small.png", "cut.png", "empty.png", "none.png", "x.pfm", ""}) {
    const Result result = compare("a.png", other);
    EXPECT_EQ(result.exit_code, 3) << other;
    EXPECT_TRUE(has(result.output, "texel: ")) << result.output;
    EXPECT_EQ(std::count(result.output.begin(), result.output.end(), '\n'), 1) << result.output;
  }
  EXPECT_EQ(compare("a.png", "a.png", fmt::format("--mask '{}'", file("small.png"))).exit_code, 3);
  EXPECT_EQ(compare("a.png", "b.png", fmt::format("--heatmap '{}'", file("none/heat.png"))).exit_code, 3);
}

TEST_F(Compare, refuses_wrong_usage) {
  for (const char* rest :
       {"--max", "--max red", "--unit radians", "--unit degrees", "--unit texels", "--texels 512",
        "--maximum 3", "--heatmap a.jpg", "--flip-heatmap a.jpg", "--flip", "--ppd 0", "--ppd nan", "third"})
    EXPECT_EQ(compare("a.png", "a.png", rest).exit_code, 2) << rest;
  EXPECT_EQ(texel("compare").exit_code, 2);
}

TEST(Texel, suggests_the_nearest_command) {
  const Result result = texel("galery");
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.output, "texel: there is no command 'galery'; did you mean 'gallery'?\n");
  EXPECT_EQ(texel("").exit_code, 2);
  EXPECT_EQ(texel("--help").exit_code, 0);
}

TEST(List, names_each_lab_as_its_program_does) {
  const Result list = texel("list");
  EXPECT_EQ(list.exit_code, 0);
  const std::vector<course::Lab> labs = course::read_labs("labs");
  EXPECT_EQ(labs.size(), std::size(test::kLabs));
  for (const course::Lab& lab : labs) {
    EXPECT_TRUE(has(list.output, lab.title)) << lab.folder;
    const Result help = shell(fmt::format("{}/{} --help", test::kBin, lab.program()));
    const std::string head = fmt::format("Lab {}: {}. {}", lab.number, lab.title, lab.lesson);
    // CLI11 breaks long lines since 2.5.
    const std::string said = std::regex_replace(help.output, std::regex("\\s+"), " ");
    EXPECT_TRUE(said.starts_with(head)) << "lab.toml: " << head << help.output.substr(0, 200);
  }
}

TEST(List, works_from_any_folder) {
  EXPECT_EQ(shell(fmt::format("cd / && {}/texel list", test::kBin)).exit_code, 0);
}

TEST(Gallery, lists_the_sources_pictures_as_the_page_does) {
  EXPECT_EQ(texel("gallery --list").output, read_file("docs/pictures.md")) << "./run docs renews it";
}

TEST(Gallery, draws_a_lab_once_and_again_only_when_it_changed) {
  const test::TemporaryFolder folder("gallery");
  const std::string command = fmt::format("gallery --lab 1 --out '{}'", (folder / "page").string());
  const Result first = texel(command);
  EXPECT_EQ(first.exit_code, 0) << first.output;
  EXPECT_TRUE(has(first.output, "pictures drawn")) << first.output;
  const course::Lab lab = course::read_lab("labs/01_texture_quad/lab.toml");
  const std::string page = read_file(folder / "page/index.html");
  for (const course::Look& look : lab.looks) {
    EXPECT_TRUE(has(page, fmt::format("src=\"01_texture_quad/{}.png\"", look.name)));
    EXPECT_GT(image::info(folder / ("page/01_texture_quad/" + look.name + ".png")).width, 0);
  }
  EXPECT_FALSE(has(page, "http")) << "the page asks nobody";
  EXPECT_TRUE(has(texel(command).output, "unchanged"));
  std::filesystem::remove(folder / ("page/01_texture_quad/" + lab.looks.front().name + ".png"));
  EXPECT_TRUE(has(texel(command).output, "pictures drawn"));
}

TEST(Gallery, fails_when_it_cannot_write) {
  EXPECT_EQ(texel("gallery --lab 1 --out /dev/null/page").exit_code, 3);
  EXPECT_EQ(texel("gallery --lab 12").exit_code, 2);
  EXPECT_EQ(texel("gallery --lab one").exit_code, 2);
}

}  // namespace
}  // namespace texel
