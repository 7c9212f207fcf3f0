// SPDX-License-Identifier: MIT
#include "batch.hpp"

#include <fmt/format.h>

#include <set>

#include "command_line.hpp"
#include "core/error.hpp"
#include "core/files.hpp"
#include "settings.hpp"
#include "snapshot.hpp"

namespace texel::app {
namespace {

using Json = nlohmann::ordered_json;

struct Entry {
  std::filesystem::path file;
  View view;
  glm::ivec2 size;
  Settings values;
};

Entry parse_entry(const Json& json, AnyLab& lab) {
  if (!json.is_object()) throw Error::usage("an entry is an object {name, view, size, set}");
  for (const auto& [key, value] : json.items())
    if (key != "name" && key != "view" && key != "size" && key != "set")
      throw Error::usage(fmt::format("there is no key '{}'", key), "the keys are name, view, size and set");
  const std::string name = json.value("name", std::string());
  // The name is a file in the folder and nowhere else.
  if (name.empty() || name.find('/') != std::string::npos || name.starts_with('.'))
    throw Error::usage(fmt::format("'{}' is no file name", name), "give each entry a name without folders");
  Entry entry{name,
              find_view(lab.info(), json.value("view", std::string("color"))),
              parse_size(json.value("size", std::string("512x512"))),
              {}};
  if (entry.file.extension() != ".png" && entry.file.extension() != ".pfm") entry.file += ".png";
  check_ending(entry.file, entry.view);
  entry.values = read_settings(json, "set", lab.parameters());
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
      entries.push_back(parse_entry(item, lab));
      if (!names.insert(entries.back().file).second)
        throw Error::usage(fmt::format("two entries are called '{}'", entries.back().file.string()));
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
  const StartValues start(lab.parameters());
  for (const Entry& entry : entries) {
    start.set(entry.values);
    write_snapshot(canvas, lab, entry.view, entry.size, samples, folder / entry.file);
  }
}

}  // namespace texel::app
