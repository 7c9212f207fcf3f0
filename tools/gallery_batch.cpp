// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "gallery.hpp"

namespace texel::tools {

std::string batch_list(const course::Lab& lab) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const course::Look& look : lab.looks) {
    nlohmann::ordered_json set = nlohmann::ordered_json::object();
    for (const course::Setting& setting : look.settings) set[setting.parameter] = setting.value;
    list.push_back({{"name", look.name}, {"view", look.view}, {"size", look.size}, {"set", set}});
  }
  return list.dump(2) + "\n";
}

}  // namespace texel::tools
