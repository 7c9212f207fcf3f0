// SPDX-License-Identifier: MIT
// A picture depends on its parameters alone: not on the run, the working directory, the number of threads or
// how it was asked for.
#include <fmt/format.h>

#include <cmath>

#include "../support/osmesa.hpp"
#include "core/files.hpp"
#include "image/difference.hpp"
#include "image/load.hpp"
#include "image/save.hpp"
#include "labs.hpp"

namespace texel::test {
namespace {

class SamePicture : public EveryLab {
 protected:
  /// One snapshot by a process of its own.
  [[nodiscard]] std::string snapshot(const std::string& name, const std::string& arguments = {},
                                     const std::string& before = {}) const {
    const std::filesystem::path file = folder_ / name;
    const Result result = run_lab(
        lab(), fmt::format("--size 160x120 --snapshot {} {}", shell_word(file.string()), arguments), before);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    return read_file(file);
  }

  /// Expects that a snapshot has the same bytes as `expected`.
  void expect_same(const std::string& expected, const std::string& arguments,
                   const std::string& before = {}) const {
    EXPECT_TRUE(snapshot("other.png", arguments, before) == expected) << before << " " << arguments;
  }

  /// Values that are not the defaults, of each type that the lab has.
  [[nodiscard]] static Settings other_values() {
    Settings settings;
    std::string types;
    for (const Parameter& p : parameters_of(lab())) {
      if (has(types, p.type) || p.name == "model") continue;
      types += p.type + " ";
      if (p.type == "toggle") settings.emplace_back(p.name, p.initial == "on" ? "off" : "on");
      if (p.type == "choice" || p.type == "file")
        settings.emplace_back(p.name, p.choices[p.choices[0] == p.initial ? 1 : 0]);
      // Sixteenths: the same number as text, in TOML and in JSON.
      if (p.type == "number")
        settings.emplace_back(p.name, fmt::format("{}", std::floor(2 * (5 * p.least + 3 * p.most)) / 16));
      if (p.type == "integer") settings.emplace_back(p.name, fmt::format("{}", static_cast<int>(p.most)));
    }
    return settings;
  }

  /// The flags that take `settings` back.
  [[nodiscard]] static std::string default_flags(const Settings& settings) {
    Settings initial;
    for (const Parameter& p : parameters_of(lab()))
      for (const auto& [name, value] : settings)
        if (p.name == name) initial.emplace_back(name, p.initial);
    return flags(initial);
  }
};
INSTANTIATE_TEST_SUITE_P(Labs, SamePicture, each_lab, lab_name);

TEST_P(SamePicture, by_every_run_on_every_renderer) {
  const std::string first = snapshot("first.png");
  expect_same(first, "", "cd / && LP_NUM_THREADS=0");
  // A locale with decimal commas, where the machine has one, and a home that cannot be written.
  expect_same(first, "", "LP_NUM_THREADS=4 TEXEL_THREADS=1 LC_ALL=de_DE.UTF-8 HOME=/dev/null");
  // As on a processor with shorter vectors.
  expect_same(first, "", "LP_NATIVE_VECTOR_WIDTH=128");
  if (has_osmesa()) expect_same(first, "--context osmesa");
  static_cast<void>(snapshot("egl.png", "--context egl"));
  const image::Difference difference =
      image::compare(image::load8(folder_ / "first.png"), image::load8(folder_ / "egl.png"));
  // Both are the same rasteriser; measured 0 in all labs.
  EXPECT_LE(difference.max, 1);
}

TEST_P(SamePicture, by_shaders_that_are_quick_to_compile_or_to_draw) {
  std::vector<Shot> shots;
  for (const Parameter& p : parameters_of(lab()))
    for (const std::string& choice : p.choices)
      if (p.name == "method") shots.push_back({choice, {{p.name, choice}}});
  for (const std::string& view : views_of(lab()))
    if (view != "color" && view != "error") shots.push_back({view + ".pfm", {}, view});
  for (Shot& shot : shots) shot.size = "64x48";
  const TemporaryFolder optimised(lab() + "_optimised");
  draw(lab(), shots, folder_);
  draw(lab(), shots, optimised, {}, "GALLIVM_PERF=no_aos_sampling");
  for (const Shot& shot : shots) {
    const std::string file = shot.name.ends_with(".pfm") ? shot.name : shot.name + ".png";
    EXPECT_TRUE(read_file(folder_ / file) == read_file(optimised / file)) << file;
  }
}

TEST_P(SamePicture, by_flags_config_and_batch) {
  const Settings settings = other_values();
  const std::string by_flags = snapshot("flags.png", flags(settings));
  const std::string by_default = snapshot("default.png");
  EXPECT_NE(by_flags, by_default);
  // The file's text says of "--method nearest --tilt 80": "method=nearest tilt=80".
  std::string key;
  for (const auto& [name, value] : settings) key += (key.empty() ? "" : " ") + name + "=" + value;
  EXPECT_EQ(image::read_png_text(folder_ / "flags.png").at(1), (image::Text{"Parameters", key}));

  const std::string config = shell_word((folder_ / "look.toml").string());
  const std::string again = shell_word((folder_ / "again.toml").string());
  EXPECT_EQ(run_lab(lab(), "--save-config " + config + flags(settings)).exit_code, 0);
  expect_same(by_flags, "--config " + config);
  // A flag goes before the file.
  expect_same(by_default, "--config " + config + default_flags(settings));
  // What was read is written again as it was.
  EXPECT_EQ(run_lab(lab(), "--config " + config + " --save-config " + again).exit_code, 0);
  EXPECT_EQ(read_file(folder_ / "look.toml"), read_file(folder_ / "again.toml"));

  // Each picture of a batch starts from the defaults.
  draw(lab(), {{"b1", settings, "color", "160x120"}, {"b2", {}, "color", "160x120"}}, folder_);
  EXPECT_TRUE(read_file(folder_ / "b1.png") == by_flags);
  EXPECT_TRUE(read_file(folder_ / "b2.png") == by_default);
}

}  // namespace
}  // namespace texel::test
