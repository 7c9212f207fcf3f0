// SPDX-License-Identifier: MIT
#include "labs.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "../support/places.hpp"
#include "core/files.hpp"
#include "core/json.hpp"
#include "core/process.hpp"
#include "image/load.hpp"

namespace texel::test {

void draw(const std::string& lab, const std::vector<Shot>& shots, const TemporaryFolder& folder) {
  Json list = Json::array();
  for (const Shot& shot : shots) {
    Json values = Json::object();
    for (const auto& [name, value] : shot.values) values[name] = value;
    list.push_back({{"name", shot.name}, {"view", shot.view}, {"size", shot.size}, {"set", values}});
  }
  const std::string file = (folder / "batch.json").string();
  write_file(file, to_text(list));
  auto [exit_code, said] =
      run_program({fmt::format("{}/{}", kBin, lab), "--batch", file, "--out", folder.path().string()}, true);
  // A slow machine shows progress, in one line that is written again and again.
  if (const std::size_t begin = said.find('\r'); begin != std::string::npos)
    said.erase(begin, std::min(said.find('\n', begin), said.size()) + 1 - begin);
  ASSERT_EQ(exit_code, 0) << said;
  EXPECT_EQ(said, "");
}

Pictures float_pictures(const std::string& lab, std::vector<Shot> shots) {
  const TemporaryFolder folder;
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
    result += fmt::format(" --{} '{}'", name, value);
  }
  return result;
}

Settings operator+(Settings first, const Settings& then) {
  first.insert(first.end(), then.begin(), then.end());
  return first;
}

}  // namespace texel::test
