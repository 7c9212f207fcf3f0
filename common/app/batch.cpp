// SPDX-License-Identifier: MIT
#include "batch.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <set>

#include "command_line.hpp"
#include "core/error.hpp"
#include "core/files.hpp"
#include "snapshot.hpp"

namespace texel::app {
namespace {

using Json = nlohmann::ordered_json;

struct Entry {
  std::filesystem::path file;
  View view;
  glm::ivec2 size;
  std::vector<std::pair<std::string, std::string>> values;
};

std::string as_text(const Json& value) {
  if (value.is_boolean()) return value.get<bool>() ? "on" : "off";
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number_integer()) return fmt::format("{}", value.get<long long>());
  if (value.is_number()) return fmt::format("{}", static_cast<float>(value.get<double>()));
  throw Error::usage(fmt::format("a parameter's value is a string, number or boolean, not {}", value.dump()));
}

Entry parse_entry(const Json& json, const Info& info) {
  if (!json.is_object()) throw Error::usage("an entry is an object {name, view, size, set}");
  for (const auto& [key, value] : json.items())
    if (key != "name" && key != "view" && key != "size" && key != "set")
      throw Error::usage(fmt::format("there is no key '{}'", key), "the keys are name, view, size and set");
  const std::string name = json.value("name", std::string());
  // The name is a file in the folder and nowhere else.
  if (name.empty() || name.find('/') != std::string::npos || name.starts_with('.'))
    throw Error::usage(fmt::format("'{}' is no file name", name), "give each entry a name without folders");
  Entry entry{name,
              find_view(info, json.value("view", std::string("color"))),
              parse_size(json.value("size", std::string("512x512"))),
              {}};
  if (entry.file.extension() != ".png" && entry.file.extension() != ".pfm") entry.file += ".png";
  check_ending(entry.file, entry.view);
  if (json.contains("set"))
    for (const auto& [parameter, value] : json.at("set").items())
      entry.values.emplace_back(parameter, as_text(value));
  return entry;
}

std::vector<Entry> parse_list(const std::filesystem::path& list, AnyLab& lab) {
  std::vector<Entry> entries;
  std::set<std::filesystem::path> names;
  std::size_t index = 0;
  try {
    const Json json = Json::parse(read_file(list));
    if (!json.is_array()) throw Error::usage("the file is a list of entries");
    for (const Json& item : json) {
      ++index;
      entries.push_back(parse_entry(item, lab.info()));
      if (!names.insert(entries.back().file).second)
        throw Error::usage(fmt::format("two entries are called '{}'", entries.back().file.string()));
      for (const auto& [parameter, value] : entries.back().values) {
        params::Parameter& p = lab.parameters().at(parameter);
        const std::string before = p.text();
        p.set(value);
        p.set(before);
      }
    }
  } catch (const Json::exception& error) {
    throw Error::usage(fmt::format("{}: {}", list.string(), error.what()));
  } catch (const Error& error) {
    if (error.exit_code() == Exit::failed) throw;
    throw Error::usage(fmt::format("{}: entry {}: {}", list.string(), index, error.what()));
  }
  return entries;
}

}  // namespace

void draw_batch(Canvas& canvas, AnyLab& lab, const std::filesystem::path& list,
                const std::filesystem::path& folder, int samples) {
  const std::vector<Entry> entries = parse_list(list, lab);
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    throw Error::failed(fmt::format("cannot make the folder: {}", error.message()), {folder.string()});
  std::vector<std::string> start;
  for (const params::Parameter& p : lab.parameters()) start.push_back(p.text());
  for (const Entry& entry : entries) {
    auto value = start.begin();
    for (params::Parameter& p : lab.parameters()) p.set(*value++);
    for (const auto& [parameter, text] : entry.values) lab.parameters().at(parameter).set(text);
    write_snapshot(canvas, lab, entry.view, entry.size, samples, folder / entry.file);
  }
}

}  // namespace texel::app
