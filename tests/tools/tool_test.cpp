// SPDX-License-Identifier: MIT
// The program `texel`, run as a user runs it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <regex>

#include "../labs/labs.hpp"
#include "../support/picture_files.hpp"
#include "../support/process.hpp"
#include "../support/said.hpp"
#include "core/files.hpp"
#include "core/json.hpp"
#include "course/lab_file.hpp"
#include "course/markers.hpp"
#include "gallery.hpp"
#include "image/difference.hpp"
#include "image/flip.hpp"
#include "image/load.hpp"
#include "image/save.hpp"
#include "image/ssim.hpp"
#include "student/report.hpp"

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

  /// What it says in JSON of the two pictures.
  [[nodiscard]] Json json_of(const std::string& rest) const {
    return parse_json(compare("a.png", "b.png", "--json " + rest).output);
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

/// What is compared, the exit code, and words of the answer.
struct Row {
  std::string a, b, rest;
  int exit_code;
  std::string says = {};
};

TEST_F(Compare, says_how_far_pictures_are_apart_and_whether_that_is_within_the_limits) {
  save_vector("x.pfm", 1, 0, 0);
  save_vector("y.pfm", 0, 1, 0);
  save_vector("long.pfm", 3, 0, 0);
  save_vector("nan.pfm", 1, std::numeric_limits<float>::quiet_NaN(), 0);
  image::save_png(file("small.png"), Image8(5, 10, 3));
  write_file(file("cut.png"), read_file(file("a.png")).substr(0, 40));
  write_file(file("empty.png"), "");
  const std::string mask = fmt::format("--mask '{}'", file("mask.png"));
  std::vector<Row> rows = {
      {"a.png", "a.png", "--json", 0,
       "{\"width\": 10, \"height\": 10, \"max\": 0, \"mean\": 0, \"p99\": 0, \"flip_mean\": 0, \"flip_p99\": "
       "0, "
       "\"ssim\": 1, \"non_finite\": 0, \"forgiven\": 0, \"unit\": \"8-bit steps\"}\n"},
      // (60 + 15) steps over 300 samples; the pixel of rank 99 of 100 is the one of 15 steps.
      {"a.png", "b.png", "--json", 1, "\"max\": 60, \"mean\": 0.25, \"p99\": 15,"},
      {"a.png", "b.png", "--max 60 --mean 0.25 --p99 15", 0},
      {"a.png", "b.png", "--mean 0.25", 0},
      {"a.png", "b.png", "--max 59", 1, "max is 60, over the limit 59"},
      {"a.png", "b.png", "--mean 0.24", 1},
      {"a.png", "b.png", "--p99 14", 1},
      {"a.png", "b.png", "--max 60 --p99 14", 1},
      {"a.png", "b.png", "--flip 1", 0},
      {"a.png", "b.png", "--flip 1 --max 59", 1},
      {"a.png", "b.png", "--flip 0.001", 1, "texel: flip is "},
      {"a.png", "b.png", "--flip 0.001", 1, ", over the limit 0.001"},
      {"a.png", "b.png", "--json " + mask, 1, "\"max\": 15,"},
      {"x.pfm", "y.pfm", "--json", 1, "\"max\": 90, \"mean\": 90, \"p99\": 90, "},
      {"long.pfm", "y.pfm", "--json", 1, "\"max\": 3, "},
      // Whatever the limit.
      {"x.pfm", "nan.pfm", "--json --max 180", 1, "\"non_finite\": 16"},
      {"x.pfm", "x.pfm", "--json", 0, "\"flip_mean\": null, \"flip_p99\": null, \"ssim\": null,"},
      {"a.png", "a.png", fmt::format("--mask '{}'", file("small.png")), 3},
      {"a.png", "b.png", fmt::format("--heatmap '{}'", file("none/heat.png")), 3}};
  for (const char* other : {"small.png", "cut.png", "empty.png", "none.png", "x.pfm", ""})
    rows.push_back({"a.png", other, "", 3, "texel: "});
  for (const char* usage : {"--max", "--max red", "--maximum 3", "--heatmap a.jpg", "--flip", "third"})
    rows.push_back({"a.png", "a.png", usage, 2});
  rows.push_back({"x.pfm", "x.pfm", "--flip 1", 2});
  for (const auto& [a, b, rest, exit_code, says] : rows) {
    const Result result = compare(a, b, rest);
    EXPECT_EQ(result.exit_code, exit_code) << a << " " << b << " " << rest << ": " << result.output;
    EXPECT_TRUE(has(result.output, says)) << result.output;
    if (exit_code == 3) {
      EXPECT_EQ(std::count(result.output.begin(), result.output.end(), '\n'), 1) << result.output;
    }
  }
  EXPECT_FALSE(has(compare("x.pfm", "x.pfm").output, "FLIP"));
  EXPECT_EQ(texel("compare").exit_code, 2);
}

TEST_F(Compare, prints_and_draws_flip_and_ssim) {
  const Result text = compare("a.png", "b.png");
  for (const char* name : {"FLIP mean", "FLIP p99", "SSIM"})
    EXPECT_TRUE(has(text.output, name)) << text.output;
  const Image8 a = image::load8(file("a.png")), b = image::load8(file("b.png"));
  const image::ImageF errors = image::flip_errors(a, b);
  const Json json = json_of("");
  EXPECT_EQ(json["flip_mean"], image::flip_figures(errors).mean);
  EXPECT_EQ(json["flip_p99"], image::flip_figures(errors).p99);
  EXPECT_EQ(json["ssim"], image::ssim(a, b));
  // Within a mask of one pixel, 6 from the nearest difference: the filters still reach it.
  Image8 corner(10, 10, 1);
  corner.at(0, 9) = 255;
  image::save_png(file("corner.png"), corner);
  const Json masked = json_of(fmt::format("--mask '{}'", file("corner.png")));
  EXPECT_GT(masked["flip_mean"], 0);
  EXPECT_LT(masked["flip_mean"], json["flip_mean"]);
  EXPECT_EQ(masked["flip_mean"], masked["flip_p99"]);
  EXPECT_GT(masked["ssim"], json["ssim"]);

  static_cast<void>(compare("a.png", "b.png", fmt::format("--heatmap '{}'", file("heat.png"))));
  const Image8 heat = image::load8(file("heat.png"));
  EXPECT_EQ(heat.width, 10);
  EXPECT_NE(heat.at(3, 4), heat.at(0, 0));
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

TEST(Texel, says_what_is_wrong_with_a_command) {
  EXPECT_EQ(texel("galery").output, "texel: there is no command 'galery'; did you mean 'gallery'?\n");
  for (const auto& [line, exit_code] : {std::pair("galery", 2),
                                        {"", 2},
                                        {"--help", 0},
                                        {"gallery --lab 1 --out /dev/null/page", 3},
                                        {"gallery --lab 12", 2},
                                        {"gallery --lab one", 2}})
    EXPECT_EQ(texel(line).exit_code, exit_code) << line;
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
    EXPECT_TRUE(has(page, fmt::format("\"file\":\"{}\"", look.file)));
    EXPECT_GT(image::load8(folder / ("page/01_texture_quad/" + look.name + ".png")).width, 0);
  }
  EXPECT_FALSE(has(page, "http")) << "the page asks nobody";
  EXPECT_TRUE(has(texel(command).output, "unchanged"));
  std::filesystem::remove(folder / ("page/01_texture_quad/" + lab.looks.front().name + ".png"));
  EXPECT_TRUE(has(texel(command).output, "pictures drawn"));
}

TEST(Report, says_once_why_several_steps_wait) {
  judge::LabResult lab;
  for (const char* id : {"7.1", "7.2", "7.3", "7.4"}) {
    judge::StepResult step;
    step.id = step.title = id;
    step.cases.emplace_back();
    if (!lab.steps.empty()) step.status = judge::Status::skipped, step.message = "because";
    lab.steps.push_back(step);
  }
  lab.steps.back().message = "for another reason";
  const std::string text = tools::report(lab, false);
  EXPECT_TRUE(has(text, "7.2: because")) << text;
  EXPECT_EQ(text.find("because"), text.rfind("because")) << text;
  EXPECT_TRUE(has(text, "7.4: for another reason")) << text;
}

/// An editor that saves with other line ends or tabs, and comments alone, begin no step, in any file of the
/// course.
TEST(Steps, are_not_begun_by_line_ends_tabs_blank_lines_and_comments) {
  for (const std::string& file : course::step_files(".")) {
    const std::string first = course::with_steps(read_file(file), file, [](const auto&) { return false; });
    for (const std::string& text :
         {std::regex_replace(first, std::regex("\n"), "\r\n"),
          std::regex_replace(first, std::regex("\n +"), "\n\t"),
          std::regex_replace(first, std::regex("\n( *//@end)"), "\n\n  // it's my plan\n$1")}) {
      ASSERT_NE(text, first);
      EXPECT_EQ(course::untouched_steps(text, first).size(), course::step_texts(first).size()) << file;
    }
  }
}

}  // namespace
}  // namespace texel
