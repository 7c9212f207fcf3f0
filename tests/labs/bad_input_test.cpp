// SPDX-License-Identifier: MIT
// Bad input gives one clear line that says what, where and what to try, the right exit code, and no file.
#include <fmt/format.h>

#include <fstream>

#include "core/files.hpp"
#include "image/save.hpp"
#include "labs.hpp"

namespace texel::test {
namespace {

constexpr int kUsage = 2, kFailed = 3;

/// Every lab is asked by every test of what they have in common.
class BadArguments : public EveryLab {
 protected:
  /// Asks for a snapshot, which must not be there afterwards.
  void expect_no_snapshot(const std::string& arguments, int exit_code,
                          const std::vector<std::string>& parts) {
    SCOPED_TRACE(arguments);
    const std::string file = shell_word((folder_ / "a.png").string());
    expect_error(run_lab(lab(), fmt::format("--snapshot {} {}", file, arguments)), exit_code, lab(), parts);
    EXPECT_TRUE(folder_.empty());
  }
};
INSTANTIATE_TEST_SUITE_P(Labs, BadArguments, each_lab, lab_name);

TEST_P(BadArguments, name_the_nearest_option) {
  expect_no_snapshot("--metod nearest", kUsage, {"--metod", "did you mean '--method'?"});
  expect_no_snapshot("--snapshto b.png", kUsage, {"did you mean '--snapshot'?"});
  expect_no_snapshot("--zzzzzzzz 3", kUsage, {"--zzzzzzzz", "see --help"});
}

TEST_P(BadArguments, name_range_and_unit_of_each_number) {
  for (const Parameter& p : parameters_of(lab())) {
    if (p.type == "number" || p.type == "integer") {
      const std::string range =
          fmt::format("from {} to {}{}{}", p.least, p.most, p.unit.empty() ? "" : " ", p.unit);
      for (const std::string& value :
           {fmt::format("{}", p.most * 2 + 1), std::string("abc"), std::string("nan"), std::string("1e999")})
        expect_no_snapshot(fmt::format("{} {}", p.flag(), value), kUsage,
                           {p.flag(), range, "'" + value + "'"});
    } else if (p.type == "choice") {
      expect_no_snapshot(fmt::format("{} {}x", p.flag(), p.choices[0]), kUsage,
                         {p.flag(), p.choices.back(), "did you mean '" + p.choices[0] + "'?"});
    } else if (p.type == "toggle") {
      expect_no_snapshot(p.flag() + " maybe", kUsage, {p.flag(), "on or off", "'maybe'"});
    }
  }
}

TEST_P(BadArguments, name_what_there_is) {
  expect_no_snapshot("--view colour", kUsage, {"'colour'", "mask", "did you mean 'color'?"});
  expect_no_snapshot("--context vulkan", kUsage, {"--context", "vulkan", "osmesa"});
  expect_no_snapshot("--samples 3", kUsage, {"--samples"});
  expect_no_snapshot("--batch list.json", kUsage, {"--out"});
  for (const char* size : {"0x64", "64", "64x", "64x64x64", "-64x64", "99999x64", "axb"})
    expect_no_snapshot(fmt::format("--size {}", size), kUsage, {"--size", "WIDTHxHEIGHT", "1 to 16384"});
  expect_no_snapshot("--assets /nonexistent", kFailed, {"/nonexistent", "--assets"});
  expect_no_snapshot("one two three", kUsage, {"unexpected argument '"});
}

TEST_P(BadArguments, name_the_file_that_cannot_be_written) {
  const std::string a = (folder_ / "a").string();
  for (const char* file : {"/nonexistent/a.png", "/dev/null/a.png", "/proc/a.png"})
    expect_error(run_lab(lab(), fmt::format("--snapshot {}", file)), kFailed, lab(), {file});
  for (const char* ending : {".jpg", ".jpeg", "", ".PNG.gz"})
    expect_error(run_lab(lab(), fmt::format("--snapshot {}{}", a, ending)), kUsage, lab(),
                 {a + ending, ".png or .pfm"});
  expect_error(run_lab(lab(), fmt::format("--snapshot {}.pfm", a)), kUsage, lab(), {"--view"});
  expect_error(run_lab(lab(), fmt::format("--snapshot {0}.png --stats {0}/none/b.json", a)), kFailed, lab(),
               {"none"});
}

TEST_P(BadArguments, say_that_there_is_no_display) {
  const std::string no_display = "env -u DISPLAY -u WAYLAND_DISPLAY";
  expect_error(run_lab(lab(), "", no_display), kFailed, lab(), {"display"});
  expect_error(run_lab(lab(), "", "DISPLAY=:4711"), kFailed, lab(), {"display"});
  expect_error(run_lab(lab(), "--context window --snapshot " + (folder_ / "a.png").string(), no_display),
               kFailed, lab(), {"display"});
  expect_error(run_lab(lab(), "--context osmesa"), kUsage, lab(), {"--snapshot"});
  EXPECT_TRUE(folder_.empty());
}

/// A file of the user's that is given to a lab.
class BadFile : public testing::Test {
 protected:
  /// Writes `bytes` to a file and gives it to the lab behind `option`. The message names the file and
  /// `parts`, and nothing else is written.
  void expect_refused(const std::string& lab, const std::string& option, const std::string& name,
                      const std::string& bytes, int exit_code, std::vector<std::string> parts) {
    SCOPED_TRACE(name + ": " + bytes.substr(0, 60));
    const std::string file = (folder_ / name).string();
    write_file(file, bytes);
    expect_path_refused(lab, option + " " + shell_word(file), file, exit_code, std::move(parts));
    std::filesystem::remove(file);
    EXPECT_TRUE(folder_.empty());
  }
  void expect_path_refused(const std::string& lab, const std::string& arguments, const std::string& file,
                           int exit_code, std::vector<std::string> parts) {
    parts.push_back(file);
    const std::string picture = (folder_ / "a.png").string();
    expect_error(run_lab(lab, fmt::format("--size 64x64 --snapshot {} {}", shell_word(picture), arguments)),
                 exit_code, lab, parts);
    EXPECT_FALSE(std::filesystem::exists(picture));
  }

  TemporaryFolder folder_{"bad_file_" + std::to_string(::getpid())};
};

TEST_F(BadFile, a_full_device_is_named_and_stays) {
  // By a link, so that a program that puts a file in the device's place only loses the link.
  const char* lab = "lab01_texture_quad";
  const std::filesystem::path full = folder_ / "full";
  std::filesystem::create_symlink("/dev/full", full);
  for (const char* option : {"--stats", "--save-config"}) {
    expect_error(run_lab(lab, fmt::format("{} {}", option, full.string())), kFailed, lab,
                 {"full", "No space"});
    EXPECT_TRUE(std::filesystem::is_character_file(full)) << option;
  }
}

TEST_F(BadFile, config) {
  const char* lab = "lab05_normal_map";
  const auto expect = [&](const std::string& text, int exit_code, const std::vector<std::string>& parts) {
    expect_refused(lab, "--config", "look.toml", text, exit_code, parts);
  };
  expect("turn = 3\nbump_strength = = 2\n", kFailed, {"look.toml:2:17: "});
  expect("method = \"raw\nturn = 3\n", kFailed, {"look.toml:1:"});
  expect("turns = 3\n", kUsage, {"'turns'", "did you mean 'turn'?"});
  expect("turn = 400\n", kUsage, {"from -360 to 360 degrees"});
  expect("turn = \"a\"\n", kUsage, {"from -360 to 360 degrees"});
  expect("turn = [1, 2]\n", kUsage, {"--turn"});
  expect("method = \"rawx\"\n", kUsage, {"did you mean 'raw'?"});
  expect("lab = \"06_cube_map\"\nturn = 3\n", kUsage, {"06_cube_map"});
  expect(std::string("\xff\xfe\0\1", 4), kFailed, {"look.toml:1:"});
  expect_path_refused(lab, "--config /nonexistent.toml", "/nonexistent.toml", kFailed, {});
  expect_path_refused(lab, "--config /tmp", "/tmp", kFailed, {"folder"});
}

TEST_F(BadFile, batch) {
  const char* lab = "lab01_texture_quad";
  const std::string out = "--out " + shell_word((folder_ / "out").string());
  const auto expect = [&](const std::string& text, const std::vector<std::string>& parts) {
    SCOPED_TRACE(text);
    expect_refused(lab, out + " --batch", "list.json", text, kUsage, parts);
  };
  expect("[{\"name\": \"a\"", {"line 1"});
  expect("{\"name\": \"a\"}", {"list of entries"});
  expect("[3]", {"entry 1"});
  expect("[{\"name\": \"a\"}, {\"name\": \"b\", \"veiw\": \"mask\"}]", {"entry 2", "'veiw'"});
  expect("[{\"name\": \"../a\"}]", {"entry 1", "'../a'"});
  expect("[{\"name\": \"b/a\"}]", {"entry 1", "'b/a'"});
  expect("[{\"name\": \"\"}]", {"entry 1"});
  expect("[{}]", {"entry 1"});
  expect("[{\"name\": 5}]", {"list.json"});
  expect("[{\"name\": \"a\"}, {\"name\": \"a.png\"}]", {"entry 2", "'a.png'"});
  expect("[{\"name\": \"a\", \"view\": \"normals\"}]", {"entry 1", "'normals'"});
  expect("[{\"name\": \"a\", \"size\": \"0x0\"}]", {"entry 1", "'0x0'"});
  expect("[{\"name\": \"a.pfm\"}]", {"entry 1", "--view"});
  expect("[{\"name\": \"a\"}, {\"name\": \"b\", \"set\": {\"tilt\": 90}}]",
         {"entry 2", "from -89 to 89 degrees"});
  expect("[{\"name\": \"a\", \"set\": {\"tlt\": 3}}]", {"entry 1", "did you mean 'tilt'?"});
  expect("[{\"name\": \"a\", \"set\": {\"tilt\": null}}]", {"entry 1", "null"});
  expect("[{\"name\": \"a\", \"set\": 3}]", {"list.json"});
  expect("", {"list.json"});
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out"));
  const std::string list = (folder_ / "list.json").string();
  write_file(list, "[{\"name\": \"a\"}]");
  expect_path_refused(lab, "--out /dev/null/out --batch " + shell_word(list), "/dev/null/out", kFailed, {});
}

TEST_F(BadFile, obj) {
  const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  const auto expect = [&](const std::string& text, const std::vector<std::string>& parts) {
    for (const char* lab : {"lab03_obj_texcoords", "lab04_cube_wrap", "lab05_normal_map"})
      expect_refused(lab, "", "bad.obj", text, kFailed, parts);
  };
  expect("", {"empty"});
  expect(std::string(4096, '\0') + "\x7f" + "ELF", {"bad.obj"});
  expect(corners + "f 1 2 0\n", {"bad.obj:4", "0"});
  expect(corners + "f 1 2 4\n", {"bad.obj:4", "4"});
  expect(corners + "f 1 2 -4\n", {"bad.obj:4", "-4"});
  expect(corners + "f 1/1 2/1 3/1\n", {"bad.obj:4"});
  expect(corners + "f 1 2 99999999999999999999\n", {"bad.obj:4"});
  expect("v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", {"bad.obj:1"});
  expect("v 0 0 1e308\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", {"bad.obj:1"});
  expect(corners, {"no face with three corners"});
  expect(corners + "f 1 2 x\n", {"bad.obj:4"});
  expect("v 0 0\n", {"bad.obj:1"});
  // A face of one or two corners is left out.
  expect(corners + "f 1\n", {"no face with three corners"});
  expect(corners + "f 1 2\n", {"no face with three corners"});
  expect_path_refused("lab05_normal_map", "/nonexistent/none.obj", "/nonexistent/none.obj", kFailed, {});
  expect_path_refused("lab05_normal_map", "/tmp", "/tmp", kFailed, {"folder"});
}

TEST_F(BadFile, texture) {
  image::Image8 picture(64, 64, 3);
  for (std::size_t i = 0; i < picture.samples.size(); ++i)
    picture.samples[i] = static_cast<std::uint8_t>(i * i);
  const std::string good = (folder_ / "good.png").string();
  image::save_png(good, picture);
  const std::string bytes = read_file(good);
  std::filesystem::remove(good);
  const auto expect = [&](const std::string& name, const std::string& text,
                          const std::vector<std::string>& parts) {
    for (const char* lab : {"lab01_texture_quad", "lab05_normal_map"})
      expect_refused(lab, "--texture", name, text, kFailed, parts);
  };
  expect("empty.png", "", {});
  expect("cut.png", bytes.substr(0, bytes.size() / 2), {});
  expect("header.png", bytes.substr(0, 20), {});
  expect("text.png", "this is no picture", {});
  // 30 GB of pixels that the file does not hold.
  expect("huge.png", png(100000, 100000, 8, 2, ""), {"100000x100000", "16384"});
  expect("zero.png", png(0, 4, 8, 2, ""), {});
  expect_path_refused("lab01_texture_quad", "--texture none.png", "none.png", kFailed, {});
  expect_path_refused("lab01_texture_quad", "--texture /tmp", "/tmp", kFailed, {"folder"});
  expect_path_refused("lab01_texture_quad", "--texture brik", "brik", kFailed, {"did you mean 'brick'?"});
}

TEST_F(BadFile, cube_map) {
  const char* faces[] = {"px", "nx", "py", "ny", "pz", "nz"};
  const std::string map = (folder_ / "map").string();
  std::filesystem::create_directory(map);
  const auto face = [&](int i) { return fmt::format("{}/{}.png", map, faces[i]); };
  const auto expect = [&](const std::string& file, const std::vector<std::string>& parts) {
    for (const char* lab : {"lab06_cube_map", "lab07_environment", "lab08_reflection", "lab09_bump"})
      expect_path_refused(lab, "--cube-map " + shell_word(map), file, kFailed, parts);
  };
  expect(face(0), {});
  for (int i = 0; i < 5; ++i) image::save_png(face(i), image::Image8(8, 8, 3));
  expect(face(5), {});
  image::save_png(face(5), image::Image8(16, 16, 3));
  expect(map, {"-Z", "16x16", "8x8"});
  image::save_png(face(5), image::Image8(8, 4, 3));
  expect(map, {"-Z", "8x4"});
  for (int i = 0; i < 6; ++i) image::save_png(face(i), image::Image8(8, 4, 3));
  expect(map, {"8x4", "square"});
}

TEST_F(BadFile, mesh_of_a_lab_that_has_none) {
  for (const char* lab : {"lab01_texture_quad", "lab06_cube_map"})
    expect_error(run_lab(lab, "--mesh " + (folder_ / "a.ply").string()), kUsage, lab, {"mesh", "3, 4 and 5"});
  EXPECT_TRUE(folder_.empty());
  expect_error(run_lab("lab05_normal_map", "--mesh /nonexistent/a.ply"), kFailed, "lab05_normal_map",
               {"/nonexistent/a.ply"});
}

}  // namespace
}  // namespace texel::test
