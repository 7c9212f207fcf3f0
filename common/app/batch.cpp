// SPDX-License-Identifier: MIT
#include "batch.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <set>

#include "command_line.hpp"
#include "core/error.hpp"
#include "core/files.hpp"
#include "mesh/ply.hpp"
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
  const std::string ending = entry.file.extension().string();
  if (ending != ".png" && ending != ".pfm" && ending != ".ply") entry.file += ".png";
  if (ending != ".ply") check_ending(entry.file, entry.view);
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

void write_entry(Canvas& canvas, AnyLab& lab, const Assets& assets, const Entry& entry,
                 const std::filesystem::path& file, int samples) {
  if (file.extension() == ".ply")
    write_mesh(lab, assets, file);
  else
    write_snapshot(canvas, lab, entry.view, entry.size, samples, file);
}

}  // namespace

void write_mesh(AnyLab& lab, const Assets& assets, const std::filesystem::path& file) {
  const mesh::Mesh* mesh = lab.mesh(assets);
  if (mesh == nullptr) throw Error::usage("this lab has no mesh to write", "labs 3, 4 and 5 do");
  mesh::write_ply(file, *mesh);
}

void draw_batch(Canvas& canvas, AnyLab& lab, const Assets& assets, const std::filesystem::path& list,
                const std::filesystem::path& folder, int samples) {
  const std::vector<Entry> entries = parse_list(list, lab);
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    throw Error::failed(fmt::format("cannot make the folder: {}", error.message()), {folder.string()});
  const StartValues start(lab.parameters());
  std::size_t faults = 0;
  for (const Entry& entry : entries) try {
      start.set(entry.values);
      write_entry(canvas, lab, assets, entry, folder / entry.file, samples);
    } catch (const Error& fault) {
      ++faults;
      std::fprintf(stderr, "%s: %s\n", entry.file.c_str(), fault.what());
    }
  if (faults > 0)
    throw Error::failed(fmt::format("{} of {} entries could not be drawn", faults, entries.size()));
}

}  // namespace texel::app
