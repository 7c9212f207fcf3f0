// SPDX-License-Identifier: MIT
#include "batch.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>
#include <future>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "command_line.hpp"
#include "core/error.hpp"
#include "core/files.hpp"
#include "core/parallel.hpp"
#include "mesh/ply.hpp"
#include "snapshot.hpp"

namespace texel::app {
namespace {

using Json = nlohmann::ordered_json;

BatchEntry parse_entry(const Json& json, AnyLab& lab) {
  if (!json.is_object()) throw Error::usage("an entry must be an object {name, view, size, set}");
  for (const auto& [key, value] : json.items())
    if (key != "name" && key != "view" && key != "size" && key != "set")
      throw Error::usage(fmt::format("there is no key '{}'", key), "the keys are name, view, size and set");
  const std::string name = json.value("name", std::string());
  // The name is a file in the folder and nowhere else.
  if (name.empty() || name.find('/') != std::string::npos || name.starts_with('.'))
    throw Error::usage(fmt::format("'{}' is not a file name", name),
                       "give each entry a name without folders");
  BatchEntry entry{name,
                   find_view(lab, json.value("view", std::string("color"))),
                   parse_size(json.value("size", std::string("512x512"))),
                   {}};
  const std::string ending = entry.file.extension().string();
  if (ending != ".png" && ending != ".pfm" && ending != ".ply") entry.file += ".png";
  if (ending != ".ply") check_ending(entry.file, entry.view);
  entry.values = read_settings(json, "set", lab.parameters());
  return entry;
}

}  // namespace

Batch read_batch(AnyLab& lab, const std::filesystem::path& list) {
  Batch entries;
  std::set<std::filesystem::path> names;
  std::size_t index = 0;
  try {
    const Json json = Json::parse(read_file(list));
    if (!json.is_array()) throw Error::usage("the file must be a list of entries");
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

double pixels_per_program(const Batch& batch, const params::Set& parameters) {
  double pixels = 0;
  std::set<std::string> programs;
  for (const BatchEntry& entry : batch) {
    if (entry.file.extension() == ".ply") continue;
    pixels += static_cast<double>(entry.size.x) * entry.size.y;
    std::set<std::string> constants = {name_of(entry.view)};
    for (const auto& [name, value] : entry.values) {
      const params::Parameter::Type type = parameters.find(name)->type;
      if (type == params::Parameter::Type::choice || type == params::Parameter::Type::toggle)
        constants.insert(name + "=" + value);
    }
    programs.insert(fmt::format("{}", fmt::join(constants, " ")));
  }
  return pixels / static_cast<double>(std::max<std::size_t>(programs.size(), 1));
}

void write_mesh(AnyLab& lab, const Assets& assets, const std::filesystem::path& file) {
  const mesh::Mesh* mesh = lab.mesh(assets);
  if (mesh == nullptr) throw Error::usage("this lab has no mesh to write", "labs 3, 4 and 5 do");
  mesh::write_ply(file, *mesh);
}

void draw_batch(Canvas& canvas, AnyLab& lab, const Assets& assets, const Batch& batch,
                const std::filesystem::path& folder, int samples) {
  const bool at_once = processors() > 1;  // a picture is compressed while the next is drawn
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    throw Error::failed(fmt::format("cannot make the folder: {}", error.message()), {folder.string()});
  const StartValues start(lab.parameters());
  std::size_t faults = 0;
  const auto attempt = [&](const BatchEntry& entry, const std::function<void()>& act) {
    try {
      act();
    } catch (const Error& fault) {
      ++faults;
      std::fprintf(stderr, "%s: %s\n", entry.file.c_str(), fault.what());
    }
  };
  const BatchEntry* before = nullptr;
  std::future<void> written;
  const auto finish_writing = [&] {
    if (written.valid()) attempt(*before, [&] { written.get(); });
  };
  for (const BatchEntry& entry : batch) {
    std::optional<Snapshot> snapshot;
    attempt(entry, [&] {
      start.set(entry.values);
      const std::filesystem::path file = folder / entry.file;
      if (file.extension() == ".ply") return write_mesh(lab, assets, file);
      canvas.draw(entry.view, entry.size, samples);
      snapshot = take_snapshot(canvas, lab, entry.view, entry.size, file);
    });
    finish_writing();
    if (!snapshot) continue;
    before = &entry;
    written = std::async([taken = std::move(*snapshot)] { taken.write(); });
    if (!at_once) finish_writing();
  }
  finish_writing();
  if (faults > 0)
    throw Error::failed(fmt::format("{} of {} entries could not be drawn", faults, batch.size()));
}

}  // namespace texel::app
