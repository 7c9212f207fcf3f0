// SPDX-License-Identifier: MIT
#include "labs.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

#include "core/files.hpp"
#include "image/load.hpp"

namespace texel::test {

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

void draw(const std::string& lab, const std::vector<Shot>& shots, const TemporaryFolder& folder) {
  Json list = Json::array();
  for (const Shot& shot : shots) {
    Json values = Json::object();
    for (const auto& [name, value] : shot.values) values[name] = value;
    list.push_back({{"name", shot.name}, {"view", shot.view}, {"size", shot.size}, {"set", values}});
  }
  const std::string file = (folder / "batch.json").string();
  write_file(file, to_text(list));
  const Result result =
      run_lab(lab, fmt::format("--batch {} --out {}", shell_word(file), shell_word((folder / "").string())));
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

bool has_parameter(const std::string& lab, const std::string& name) {
  const Json parameters = parse_json(run_lab(lab, "--list-parameters --json").output);
  return std::any_of(parameters.begin(), parameters.end(),
                     [&](const Json& parameter) { return parameter.at("name") == name; });
}

Json stats_of(const std::string& lab, const std::string& arguments) {
  const Result result = run_lab(lab, "--stats - --size 128x128 " + arguments);
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_EQ(result.errors, "");
  return parse_json(result.output);
}

Settings operator+(Settings first, const Settings& then) {
  first.insert(first.end(), then.begin(), then.end());
  return first;
}

}  // namespace texel::test
