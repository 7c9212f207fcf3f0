// SPDX-License-Identifier: MIT
// What every lab says of itself: the contract with people, scripts and the grader.
#include <algorithm>
#include <set>
#include <sstream>

#include "image/load.hpp"
#include "image/save.hpp"
#include "labs.hpp"

namespace texel::test {
namespace {

class Interface : public EveryLab {};
INSTANTIATE_TEST_SUITE_P(Labs, Interface, each_lab, lab_name);

TEST_P(Interface, lists_parameters_by_the_contract) {
  const std::vector<Parameter> parameters = parameters_of(lab());
  ASSERT_FALSE(parameters.empty());
  std::set<std::string> names;
  for (const Parameter& p : parameters) {
    SCOPED_TRACE(p.name);
    EXPECT_TRUE(names.insert(p.name).second) << "named twice";
    EXPECT_FALSE(p.help.empty());
    EXPECT_FALSE(p.initial.empty());
    const bool has_range = p.type == "number" || p.type == "integer";
    const bool has_choices = p.type == "choice" || p.type == "file";
    EXPECT_TRUE(has_range || has_choices || p.type == "toggle") << p.type;
    EXPECT_EQ(has_range, p.least < p.most);
    EXPECT_EQ(has_choices, !p.choices.empty());
    const std::vector<std::string> values =
        p.type == "toggle" ? std::vector<std::string>{"on", "off"} : p.choices;
    EXPECT_EQ(std::count(values.begin(), values.end(), p.initial), has_range ? 0 : 1) << p.initial;
  }
  EXPECT_TRUE(names.contains("method")) << "every technique has several ways";
}

TEST_P(Interface, lists_views_with_color_first) {
  const std::vector<std::string> views = views_of(lab());
  ASSERT_GE(views.size(), 2U);
  EXPECT_EQ(views.front(), "color");
  const std::set<std::string> known = {"color", "normal", "tangent", "texcoord", "direction",
                                       "lod",   "depth",  "mask",    "error"};
  for (const std::string& view : views) EXPECT_TRUE(known.contains(view)) << view;
  EXPECT_EQ(std::set<std::string>(views.begin(), views.end()).size(), views.size());
}

TEST_P(Interface, explains_every_option_in_its_help) {
  const Result help = run_lab(lab(), "--help");
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_EQ(help.errors, "");
  for (const Parameter& p : parameters_of(lab())) {
    EXPECT_TRUE(has(help.output, p.flag() + " ")) << p.flag();
    for (const std::string& choice : p.choices) EXPECT_TRUE(has(help.output, choice + ": ")) << choice;
  }
  for (const char* option :
       {"--snapshot", "--view", "--batch", "--out", "--stats", "--mesh", "--frames", "--config",
        "--save-config", "--context", "--assets", "--size", "--list-parameters", "--list-views"})
    EXPECT_TRUE(has(help.output, option)) << option;
  const std::string text = run_lab(lab(), "--list-parameters").output;
  for (const Parameter& p : parameters_of(lab()))
    EXPECT_TRUE(has(text, p.flag() + " (" + p.type)) << p.flag();
}

/// What the default look shows: the eight materials of lab 3's ship, lab 7's five spheres and what surrounds
/// them, the ball of labs 8 and 9 and what it mirrors; else one object.
int objects_of(const std::string& lab) {
  if (lab.starts_with("lab03")) return 8;
  if (lab.starts_with("lab07")) return 6;
  return lab.starts_with("lab08") || lab.starts_with("lab09") ? 2 : 1;
}

TEST_P(Interface, holds_only_what_the_scene_needs) {
  Stats stats = stats_of(lab());
  EXPECT_EQ("lab" + stats.lab, lab());
  // A warning names what is uploaded, bound or declared and not read, and what is read and not there.
  EXPECT_TRUE(stats.warnings.empty()) << stats.warnings.front();
  EXPECT_GE(stats.vertices, 3);
  EXPECT_GE(stats.triangles, 1);
  EXPECT_GE(stats.draw_calls, 1);
  EXPECT_LE(stats.draw_calls, objects_of(lab()));
  const auto positions = std::count(stats.attributes.begin(), stats.attributes.end(), "position");
  EXPECT_GE(positions, 1);
  EXPECT_LE(positions, stats.draw_calls);
  EXPECT_GE(stats.textures.size(), 1U);
  EXPECT_GT(stats.peak_bytes, 1e6);
  for (const char* stage : {"start", "loader", "context", "decode", "compile", "first_draw", "total", "draw"})
    EXPECT_GT(stats.stages[stage], 0) << stage;
  double sum = 0;  // all time is somebody's
  for (const auto& [stage, milliseconds] : stats.stages)
    if (stage != "total" && stage != "draw") sum += milliseconds;
  EXPECT_NEAR(sum, stats.stages["total"], 1e-6);
  EXPECT_NE(stats.renderer, "");
  EXPECT_NE(stats.version, "");
}

TEST_P(Interface, prints_its_shaders_with_where_each_constant_and_uniform_comes_from) {
  const Result result = run_lab(lab(), "--print-shader --size 64x64");
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_EQ(result.errors, "");
  EXPECT_TRUE(has(result.output, "// ---- shaders/" + lab().substr(3) + "/")) << result.output;
  EXPECT_FALSE(has(result.output, "#line "));
  std::set<std::string> flags;
  for (const Parameter& p : parameters_of(lab())) flags.insert(p.flag());
  std::istringstream lines(result.output);
  int constants = 0, uniforms = 0, of_the_lab = 0;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t comment = line.rfind("  // ");
    const std::string origin = comment == line.npos ? "" : line.substr(comment + 5);
    const std::string flag = origin.substr(0, origin.find_first_of(" :"));
    if (line.starts_with("#define ") && flag.starts_with("--")) {
      EXPECT_TRUE(flag == "--view" || flags.contains(flag)) << line;
      ++constants;
    }
    if (!line.starts_with("uniform ")) continue;
    ++uniforms;
    if (origin == "set in the lab's draw()")
      ++of_the_lab;
    else
      EXPECT_TRUE(flags.contains(flag)) << line;
  }
  EXPECT_GT(constants, 1);
  EXPECT_GT(uniforms, of_the_lab);
}

TEST_P(Interface, writes_into_a_snapshot_how_it_was_made) {
  // A number that is not the default, in the parameters' own words.
  const std::vector<Parameter> parameters = parameters_of(lab());
  const auto number = std::find_if(parameters.begin(), parameters.end(),
                                   [](const Parameter& p) { return p.name == "field_of_view"; });
  const Settings settings = number == parameters.end() ? Settings{} : Settings{{"field_of_view", "50"}};
  const std::string file = (folder_ / "a.png").string();
  const Result result = run_lab(lab(), "--size 96x64 --snapshot " + shell_word(file) + flags(settings));
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_EQ(result.output + result.errors, "");
  const image::Info info = image::info(file);
  EXPECT_EQ(info.width, 96);
  EXPECT_EQ(info.height, 64);
  EXPECT_EQ(info.channels, 3);
  std::vector<image::Text> texts = image::read_png_text(file);
  ASSERT_FALSE(texts.empty());
  EXPECT_EQ(texts.back().key, "Renderer");
  EXPECT_NE(texts.back().value, "");
  texts.pop_back();
  std::vector<image::Text> expected = {{"Lab", lab().substr(3)}, {"View", "color"}, {"Size", "96x64"}};
  if (!settings.empty()) expected.insert(expected.begin() + 1, image::Text{"Parameters", "field_of_view=50"});
  EXPECT_EQ(texts, expected);
}

}  // namespace
}  // namespace texel::test
