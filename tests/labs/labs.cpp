// SPDX-License-Identifier: MIT
#include "labs.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "core/files.hpp"
#include "core/json.hpp"
#include "image/load.hpp"

namespace texel::test {
namespace {

std::string as_text(const Json& value) {
  if (value.is_boolean()) return value.get<bool>() ? "on" : "off";
  return value.is_string() ? value.get<std::string>() : to_text(value);
}

std::vector<std::string> names(const Json& list) {
  std::vector<std::string> result;
  for (const Json& item : list) result.push_back(item.at("name").get<std::string>());
  return result;
}

}  // namespace

std::string EveryLab::unique_name() {
  const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
  std::string name = fmt::format("{}_{}_{}", test.test_suite_name(), test.name(), ::getpid());
  std::replace(name.begin(), name.end(), '/', '_');
  return name;
}

Result run_lab(const std::string& lab, const std::string& arguments, const std::string& before) {
  Result result = shell(fmt::format("{} {}/{} {}", before, kBin, lab, arguments));
  // A slow machine shows progress, in one line that is written again and again.
  if (const std::size_t begin = result.errors.find('\r'); begin != std::string::npos)
    result.errors.erase(begin, std::min(result.errors.find('\n', begin), result.errors.size()) + 1 - begin);
  return result;
}

Result run_batch(const std::string& lab, const std::vector<Shot>& shots, const TemporaryFolder& folder,
                 const std::string& arguments, const std::string& before) {
  Json list = Json::array();
  for (const Shot& shot : shots) {
    Json values = Json::object();
    for (const auto& [name, value] : shot.values) values[name] = value;
    list.push_back({{"name", shot.name}, {"view", shot.view}, {"size", shot.size}, {"set", values}});
  }
  const std::string file = (folder / "batch.json").string();
  write_file(file, to_text(list));
  return run_lab(
      lab,
      fmt::format("--batch {} --out {} {}", shell_word(file), shell_word((folder / "").string()), arguments),
      before);
}

void draw(const std::string& lab, const std::vector<Shot>& shots, const TemporaryFolder& folder,
          const std::string& arguments, const std::string& before) {
  const Result result = run_batch(lab, shots, folder, arguments, before);
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_EQ(result.output + result.errors, "");
}

Pictures float_pictures(const std::string& lab, std::vector<Shot> shots) {
  const TemporaryFolder folder(fmt::format("{}_{}", lab, ::getpid()));
  for (Shot& shot : shots) shot.name += ".pfm";
  draw(lab, shots, folder);
  Pictures pictures;
  for (const Shot& shot : shots)
    pictures[shot.name.substr(0, shot.name.size() - 4)] = image::load_pfm(folder / shot.name);
  return pictures;
}

std::string flags(const Settings& settings) {
  std::string result;
  for (auto [name, value] : settings) {
    std::replace(name.begin(), name.end(), '_', '-');
    result += fmt::format(" --{} {}", name, shell_word(value));
  }
  return result;
}

std::string Parameter::flag() const {
  std::string result = "--" + name;
  std::replace(result.begin(), result.end(), '_', '-');
  return result;
}

std::vector<Parameter> parameters_of(const std::string& lab) {
  const Result result = run_lab(lab, "--list-parameters --json");
  std::vector<Parameter> parameters;
  for (const Json& json : parse_json(result.output)) {
    Parameter p;
    p.name = json.at("name");
    p.type = json.at("type");
    p.initial = as_text(json.at("default"));
    p.unit = json.at("unit");
    p.help = json.at("help");
    if (!json.at("min").is_null()) p.least = json.at("min");
    if (!json.at("max").is_null()) p.most = json.at("max");
    p.choices = names(json.at("choices"));
    parameters.push_back(std::move(p));
  }
  return parameters;
}

bool has_parameter(const std::string& lab, const std::string& name) {
  const std::vector<Parameter> parameters = parameters_of(lab);
  return std::any_of(parameters.begin(), parameters.end(),
                     [&](const Parameter& p) { return p.name == name; });
}

Stats stats_of(const std::string& lab, const std::string& arguments) {
  const Result result = run_lab(lab, "--stats - --size 128x128 " + arguments);
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_EQ(result.errors, "");
  const Json json = parse_json(result.output);
  Stats stats;
  stats.lab = json.at("lab");
  stats.renderer = json.at("renderer");
  stats.version = json.at("version");
  stats.vertices = json.at("vertices");
  stats.triangles = json.at("triangles");
  stats.draw_calls = json.at("draw_calls");
  stats.peak_bytes = json.at("peak_bytes");
  stats.attributes = names(json.at("attributes"));
  stats.textures = names(json.at("textures"));
  stats.notes = json.at("notes").get<std::vector<std::string>>();
  stats.warnings = json.at("warnings").get<std::vector<std::string>>();
  for (const auto& [stage, milliseconds] : json.at("milliseconds").items()) {
    EXPECT_GE(milliseconds.get<double>(), 0) << stage;
    stats.stages[stage] = milliseconds.get<double>();
  }
  for (const Json& attribute : json.at("attributes")) EXPECT_GT(attribute.at("bytes"), 0) << attribute;
  for (const Json& texture : json.at("textures")) {
    EXPECT_GT(texture.at("width"), 0) << texture;
    EXPECT_GT(texture.at("height"), 0) << texture;
    EXPECT_GT(texture.at("bytes"), 0) << texture;
    EXPECT_NE(texture.at("format"), "") << texture;
  }
  return stats;
}

Settings operator+(Settings first, const Settings& then) {
  first.insert(first.end(), then.begin(), then.end());
  return first;
}

}  // namespace texel::test
