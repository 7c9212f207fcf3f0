// SPDX-License-Identifier: MIT
#include "material/mutant_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <regex>

#include "course/reader.hpp"

namespace texel::material {
namespace {

namespace fs = std::filesystem;

bool is_name(const std::string& name) {
  return name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") == name.npos;
}

bool is_below_root(const fs::path& file) {
  return file.is_relative() && std::find(file.begin(), file.end(), "..") == file.end();
}

/// `kind` is the table's name, which is also the word for what is in it.
Mutant read_mutant(course::Reader& reader, const std::string& kind) {
  Mutant mutant;
  mutant.is_right = kind == "equivalent";
  mutant.place = reader.error("", "").place();
  mutant.name = reader.text("name");
  mutant.file = reader.text("file");
  mutant.what = reader.text("what");
  if (reader.find("by") == nullptr)
    throw reader.error("by", "'by' is missing", "write by = \"\" to remove the text");
  mutant.by = reader.text("by", "");
  mutant.step = reader.text("step", "");
  mutant.says = reader.text("says");
  if (kind == "mutant") {
    mutant.same = reader.text("same", "");
    mutant.survives = reader.text("survives", "");
  }
  reader.reject_unknown();
  if (!is_name(mutant.name))
    throw reader.error("name", fmt::format("'{}' is not a valid {} name", mutant.name, kind),
                       "use lower-case letters, digits and '-'");
  if (!is_below_root(mutant.file))
    throw reader.error("file", fmt::format("'{}' is not a path below the project's root", mutant.file),
                       "write it as shaders/lib/light.glsl");
  if (!mutant.step.empty() && !std::regex_match(mutant.step, std::regex("[0-9]+\\.[0-9]+")))
    throw reader.error("step", fmt::format("'{}' is not a step", mutant.step), "write it as 5.1");
  if (mutant.what == mutant.by) throw reader.error("by", "the replacement changes nothing");
  return mutant;
}

/// Adds a mutant whose name no other has.
void add(std::vector<Mutant>& mutants, Mutant mutant, const std::string& kind) {
  const auto same = std::ranges::find(mutants, mutant.name, &Mutant::name);
  if (same != mutants.end())
    throw Error::failed(fmt::format("two {}s are called '{}'", kind, mutant.name), mutant.place,
                        fmt::format("the other one is at {}:{}", same->place.file, same->place.line));
  mutants.push_back(std::move(mutant));
}

}  // namespace

std::vector<Mutant> read_catalogue(const fs::path& folder, const std::vector<std::string>& kinds) {
  std::vector<fs::path> files;
  std::error_code missing;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, missing))
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::vector<Mutant> mutants;
  for (const fs::path& file : files) {
    const toml::table table = course::read_toml(file);
    course::Reader reader(table, file.string());
    for (const std::string& kind : kinds)
      for (course::Reader& entry : reader.tables(kind)) add(mutants, read_mutant(entry, kind), kind);
    reader.reject_unknown();
  }
  if (mutants.empty())
    throw Error::failed(fmt::format("holds no {}s", fmt::join(kinds, "s and no ")), {folder.string()},
                        "name another catalogue");
  return mutants;
}

std::string title_of(const std::string& says) {
  const std::size_t end = std::min({says.find(": "), says.find(". "), says.size()});
  return says.substr(0, end == says.size() && says.ends_with('.') ? end - 1 : end);
}

std::vector<Mutant> read_mistakes(const fs::path& tree) {
  std::vector<Mutant> all = read_catalogue(tree / "tests/mutants");
  for (Mutant& mutant : read_catalogue(tree / "tests/mistakes")) add(all, std::move(mutant), "mutant");
  std::erase_if(all, [](const Mutant& mutant) { return mutant.step.empty(); });
  for (const Mutant& mutant : all)
    if (!mutant.same.empty() && std::none_of(all.begin(), all.end(), [&](const Mutant& other) {
          return other.name == mutant.same && other.step == mutant.step && other.same.empty();
        }))
      throw Error::failed(fmt::format("step {} has no other mutant '{}'", mutant.step, mutant.same),
                          mutant.place, "name one that has no 'same' itself");
  return all;
}

std::string mutated(const Mutant& mutant, const std::string& text) {
  const std::size_t at = text.find(mutant.what);
  if (at == std::string::npos)
    throw Error::failed(fmt::format("'{}' does not apply: its text is not in {}", mutant.name, mutant.file),
                        mutant.place, "copy the current text from the file");
  if (text.find(mutant.what, at + 1) != std::string::npos)
    throw Error::failed(
        fmt::format("'{}' does not apply: its text occurs more than once in {}", mutant.name, mutant.file),
        mutant.place, "add more of the text around it");
  return text.substr(0, at) + mutant.by + text.substr(at + mutant.what.size());
}

}  // namespace texel::material
