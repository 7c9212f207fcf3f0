// SPDX-License-Identifier: MIT
#include "course/batch.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <optional>
#include <set>

#include "core/error.hpp"

namespace texel::course {
namespace {

/// A string, number or boolean as the command line takes it.
std::string as_text(const Json& value) {
  if (value.is_boolean()) return value.get<bool>() ? "on" : "off";
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number_integer()) return fmt::format("{}", value.get<long long>());
  if (value.is_number()) return fmt::format("{}", static_cast<float>(value.get<double>()));
  throw Error::usage(
      fmt::format("a parameter's value must be a string, number or boolean, not {}", to_text(value)));
}

Case parse_entry(const Json& json) {
  constexpr std::array<std::string_view, 4> keys = {"name", "view", "size", "set"};
  if (!json.is_object())
    throw Error::usage(fmt::format("it must be an object {{{}}}", fmt::join(keys, ", ")));
  for (const auto& [key, value] : json.items())
    if (std::find(keys.begin(), keys.end(), key) == keys.end())
      throw Error::usage(fmt::format("there is no key '{}'", key),
                         fmt::format("the keys are {}", fmt::join(keys, ", ")));
  Case one;
  one.file = json.value("name", std::string());
  // The name is a file in the folder and nowhere else.
  if (one.file.empty() || one.file.find('/') != std::string::npos || one.file.starts_with('.'))
    throw Error::usage(fmt::format("'{}' is not a file name", one.file),
                       "give each entry a name without folders");
  const bool is_mesh = one.file.ends_with(".ply");
  if (!is_mesh && !one.file.ends_with(".png") && !one.file.ends_with(".pfm")) one.file += ".png";
  one.name = one.file.substr(0, one.file.size() - 4);

  const std::string view = is_mesh ? "mesh" : json.value("view", std::string(name_of(View::color)));
  const std::optional<View> found = find_view(view);
  if (!found || (*found == View::mesh) != is_mesh)
    throw Error::usage(fmt::format("there is no view '{}'", view));
  one.view = *found;
  one.size = parse_size(json.value("size", course::as_text(one.size)));
  one.settings = settings_from(json.value("set", Json::object()));
  return one;
}

}  // namespace

Json to_json(const std::vector<Setting>& settings) {
  Json set = Json::object();
  for (const auto& [parameter, value] : settings) set[parameter] = value;
  return set;
}

std::vector<Setting> settings_from(const Json& set) {
  if (!set.is_object()) throw Error::usage("'set' must be an object {parameter: value}");
  std::vector<Setting> settings;
  for (const auto& [parameter, value] : set.items()) settings.push_back({parameter, as_text(value)});
  return settings;
}

std::string to_batch(const std::vector<Case>& cases) {
  Json list = Json::array();
  for (const Case& one : cases) {
    Json entry{{"name", one.file}};
    if (!one.is_mesh()) entry["view"] = name_of(one.view), entry["size"] = course::as_text(one.size);
    entry["set"] = to_json(one.settings);
    list.push_back(std::move(entry));
  }
  return to_text(list, 1) + "\n";
}

std::vector<Case> parse_batch(const std::string& list) {
  std::vector<Case> cases;
  std::set<std::string> files;
  std::size_t number = 0;  // of the entry that is read; 0 for the list
  try {
    const Json entries = parse_json(list);
    if (!entries.is_array()) throw Error::usage("it must be a list of entries");
    for (const Json& entry : entries) {
      ++number;
      cases.push_back(parse_entry(entry));
      if (!files.insert(cases.back().file).second)
        throw Error::usage(fmt::format("two entries are called '{}'", cases.back().file));
    }
  } catch (const std::exception& error) {
    throw Error::usage(number == 0 ? error.what() : fmt::format("entry {}: {}", number, error.what()));
  }
  return cases;
}

std::string to_json(const std::vector<Drawing>& drawings) {
  Json list = Json::array();
  for (const Drawing& one : drawings)
    list.push_back({{"name", one.file},
                    {"status", one.is_drawn ? "drawn" : "failed"},
                    {"message", one.message},
                    {"place", one.place},
                    {"drawn_by", one.drawn_by},
                    {"milliseconds", one.milliseconds}});
  return to_text(list, 1) + "\n";
}

std::vector<Drawing> parse_drawings(const std::string& text) {
  constexpr std::size_t kMostBytes = 2000;
  std::vector<Drawing> drawings;
  const Json json = json_or_null(text);
  if (!json.is_array()) return drawings;
  for (const Json& entry : json) try {
      const auto text_at = [&](const char* key) {
        return entry.value(key, std::string()).substr(0, kMostBytes);
      };
      Drawing one{text_at("name"),  text_at("status") == "drawn", text_at("message"),
                  text_at("place"), text_at("drawn_by"),          entry.value("milliseconds", 0.0)};
      if (!one.file.empty()) drawings.push_back(std::move(one));
    } catch (const Json::exception&) {  // no entry
    }
  return drawings;
}

}  // namespace texel::course
