// SPDX-License-Identifier: MIT
#include "course/batch.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <set>

#include "core/error.hpp"
#include "core/json.hpp"

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

std::vector<Setting> read_settings(const Json& json) {
  std::vector<Setting> settings;
  if (!json.contains("set")) return settings;
  if (!json.at("set").is_object()) throw Error::usage("'set' must be an object {parameter: value}");
  for (const auto& [parameter, value] : json.at("set").items())
    settings.push_back({parameter, as_text(value)});
  return settings;
}

Json to_json(const std::vector<Setting>& settings) {
  Json set = Json::object();
  for (const Setting& setting : settings) set[setting.parameter] = setting.value;
  return set;
}

Size read_size(const Json& json, Size otherwise) {
  const std::string text = json.value("size", course::as_text(otherwise));
  const std::optional<Size> size = find_size(text);
  if (!size)
    throw Error::usage(fmt::format("'{}' is not a size", text),
                       fmt::format("write WIDTHxHEIGHT in pixels, each from 1 to {}", Size::kMostPixels));
  return *size;
}

void reject_other_keys(const Json& json, const std::vector<std::string>& keys) {
  if (!json.is_object())
    throw Error::usage(fmt::format("it must be an object {{{}}}", fmt::join(keys, ", ")));
  for (const auto& [key, value] : json.items())
    if (std::find(keys.begin(), keys.end(), key) == keys.end())
      throw Error::usage(fmt::format("there is no key '{}'", key),
                         fmt::format("the keys are {}", fmt::join(keys, ", ")));
}

/// Reads each entry; an error counts to it.
template <class Entry, class Read>
std::vector<Entry> read_each(const Json& list, const char* what, const char* several, Read read) {
  std::vector<Entry> entries;
  if (!list.is_array()) throw Error::usage(fmt::format("it must be a list of {}", several));
  for (const Json& entry : list) try {
      entries.push_back(read(entry));
    } catch (const Json::exception& error) {
      throw Error::usage(fmt::format("{} {}: {}", what, entries.size() + 1, error.what()));
    } catch (const Error& error) {
      throw Error::usage(fmt::format("{} {}: {}", what, entries.size() + 1, error.what()));
    }
  return entries;
}

Json parse(const std::string& text) {
  try {
    return parse_json(text);
  } catch (const Json::exception& error) {
    throw Error::usage(error.what());
  }
}

BenchCase parse_bench_case(const Json& json) {
  reject_other_keys(json, {"case", "size", "set", "vary"});
  BenchCase one;
  one.name = json.at("case").get<std::string>();
  one.size = read_size(json, {256, 256});
  one.settings = read_settings(json);
  const Json& vary = json.at("vary");
  if (!vary.is_object() || vary.empty()) throw Error::usage("'vary' must be an object {parameter: [values]}");
  for (const auto& [parameter, values] : vary.items()) {
    if (!values.is_array()) throw Error::usage(fmt::format("the values of '{}' must be a list", parameter));
    Variation variation{parameter, {}};
    for (const Json& value : values) variation.values.push_back(as_text(value));
    one.variations.push_back(std::move(variation));
  }
  return one;
}

Case parse_entry(const Json& json) {
  reject_other_keys(json, {"name", "view", "size", "set"});
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
  one.size = read_size(json, one.size);
  one.settings = read_settings(json);
  return one;
}

}  // namespace

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
  std::set<std::string> files;
  return read_each<Case>(parse(list), "entry", "entries", [&](const Json& json) {
    Case one = parse_entry(json);
    if (!files.insert(one.file).second)
      throw Error::usage(fmt::format("two entries are called '{}'", one.file));
    return one;
  });
}

BenchList parse_bench(const std::string& list) {
  const Json json = parse(list);
  if (!json.is_object() || !json.contains("cases"))
    throw Error::usage("it must be an object {seconds, cases}");
  return {json.value("seconds", 2.0), read_each<BenchCase>(json["cases"], "case", "cases", parse_bench_case)};
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
