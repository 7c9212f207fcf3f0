// SPDX-License-Identifier: MIT
#include "course/lab_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "core/files.hpp"
#include "core/pattern.hpp"
#include "core/plain_text.hpp"
#include "course/reader.hpp"
#include "params/set.hpp"

namespace texel::course {
namespace {

namespace fs = std::filesystem;

/// A name that may be a file's and that no other of its kind has.
template <class Named>
std::string read_name(Reader& reader, const std::vector<Named>& others, const char* kind) {
  std::string name = reader.text("name");
  if (name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_-") != name.npos)
    throw reader.error("name", fmt::format("'{}' is not a valid {} name", name, kind),
                       "use lower-case letters, digits, '_' and '-'");
  if (std::any_of(others.begin(), others.end(), [&](const Named& other) { return other.name == name; }))
    throw reader.error("name", fmt::format("two {}s are called '{}'", kind, name));
  return name;
}

/// The settings and the view of a case. Only the cases of a step may have the vertex stream as their view.
void read_what_is_seen(Reader& reader, Case& one, bool may_be_mesh) {
  for (const auto& [parameter, value] : reader.entries("set", "value"))
    one.settings.push_back({parameter, reader.setting(*value)});
  const std::string name = reader.text("view", name_of(View::color));
  const std::optional<View> view = find_view(name);
  if (!view) throw reader.error("view", fmt::format("there is no view '{}'", name));
  if (*view == View::mesh && !may_be_mesh)
    throw reader.error("view", "a mesh is no picture: only a [[case]] has the view 'mesh'");
  one.view = *view;
}

Size read_size(Reader& reader, Size otherwise) {
  const std::string text = reader.text("size", as_text(otherwise));
  const std::optional<Size> size = find_size(text);
  if (!size)
    throw reader.error("size", fmt::format("'{}' is not a size", text), "write WIDTHxHEIGHT in pixels");
  return *size;
}

std::vector<Look> read_looks(Reader& head, const std::string& lab, const std::string& kind) {
  const bool is_opening = kind == "opening";
  std::vector<Look> looks;
  for (Reader& reader : head.tables(kind)) {
    Look look;
    look.lab = lab;
    look.name = is_opening ? kind : read_name(reader, looks, "look");
    look.file = look.name + ".png";
    look.caption = reader.text("caption");
    read_what_is_seen(reader, look, false);
    look.size = read_size(reader, look.size);
    look.source = reader.text("source", "");
    if (!is_opening) look.hero = reader.toggle("hero");
    if (is_opening) {
      for (const auto& [parameter, value] : reader.entries("right", "value"))
        look.right = {parameter, reader.setting(*value)};
      look.sides = reader.texts("sides");
      if (look.sides.size() != 2 || !look.right)
        throw reader.error("sides", "an opening has a value 'right' of the line, and the names of two sides");
    }
    reader.reject_unknown();
    looks.push_back(std::move(look));
  }
  return looks;
}

std::vector<Step>::const_iterator find_step(const std::vector<Step>& steps, const std::string& id) {
  return std::find_if(steps.begin(), steps.end(), [&](const Step& step) { return step.id == id; });
}

/// The earlier steps that a step needs, with those that they need, in the lab's order.
std::vector<std::string> read_needs(Reader& reader, const std::vector<Step>& earlier) {
  std::set<std::string> all;
  for (const std::string& need : reader.texts("needs")) {
    const auto found = find_step(earlier, need);
    if (found == earlier.end())
      throw reader.error("needs", fmt::format("there is no step '{}' before this one", need));
    all.insert(need);
    all.insert(found->needs.begin(), found->needs.end());
  }
  std::vector<std::string> needs;
  for (const Step& step : earlier)
    if (all.contains(step.id)) needs.push_back(step.id);
  return needs;
}

std::vector<Step> read_steps(Reader& head, int lab) {
  std::vector<Step> steps;
  for (Reader& reader : head.tables("step")) {
    Step step;
    step.id = reader.text("id");
    step.title = reader.text("title");
    step.points = reader.number("points");
    step.needs = read_needs(reader, steps);
    step.hints = reader.texts("hints");
    for (const auto& [begin, hint] : reader.entries("hint_of", "number"))
      if ((step.hint_of[begin] = hint->value_or(std::size_t{0})) - 1 >= step.hints.size())
        throw reader.error(*hint, fmt::format("'{}' must name one of the step's hints, from 1", begin));
    read_what_is_seen(reader, step.see, false);
    reader.find("seen_with");
    reader.reject_unknown();
    if (const std::string next = fmt::format("{}.{}", lab, steps.size() + 1); step.id != next)
      throw reader.error("id",
                         fmt::format("this is step '{}', but the next one must be '{}'", step.id, next));
    if (step.hints.empty() || step.hints.size() > 3)
      throw reader.error("hints", "a step must have one to three hints");
    steps.push_back(std::move(step));
  }
  return steps;
}

std::vector<Hidden> read_hidden(Reader& reader) {
  std::vector<Hidden> all;
  for (const auto& [parameter, node] : reader.entries("hidden", "[values]")) {
    Hidden& hidden = all.emplace_back(Hidden{parameter, {}, true});
    if (!node->is_array()) throw reader.error(*node, fmt::format("'{}' must be a list of values", parameter));
    for (const toml::node& value : *node->as_array()) {
      hidden.values.push_back(reader.setting(value));
      hidden.are_numbers &= value.is_number();
    }
  }
  return all;
}

std::vector<Case> read_cases(Reader& head, const std::string& lab, const std::vector<Step>& steps) {
  std::vector<Case> cases;
  for (Reader& reader : head.tables("case")) {
    Case one;
    one.lab = lab;
    one.name = read_name(reader, cases, "case");
    one.step = reader.text("step");
    if (find_step(steps, one.step) == steps.end())
      throw reader.error("step", fmt::format("there is no step '{}'", one.step));
    read_what_is_seen(reader, one, true);
    one.size = read_size(reader, {128, 128});
    one.file = one.name + (one.is_mesh() ? ".ply" : one.view == View::color ? ".png" : ".pfm");
    one.limit = reader.number("limit");
    reader.text("why");  // where the limit comes from: for who reads the file
    one.hidden_settings = read_hidden(reader);
    one.hidden = !one.hidden_settings.empty() ||
                 std::any_of(one.settings.begin(), one.settings.end(),
                             [](const Setting& setting) { return setting.value.starts_with(kUnseen); });
    reader.reject_unknown();
    cases.push_back(std::move(one));
  }
  for (const Step& step : steps)
    if (std::none_of(cases.begin(), cases.end(), [&](const Case& c) { return c.step == step.id; }))
      throw head.error("step", fmt::format("no case judges step '{}'", step.id));
  return cases;
}

/// "05_normal_map" is lab 5; 0 for a folder that is none.
int lab_number(const std::string& folder) {
  static const Pattern kLab("([0-9][0-9])_.+");
  const Pattern::Groups found = kLab.match(folder);
  return found.empty() ? 0 : std::stoi(found[1]);
}

}  // namespace

Lab read_lab(const fs::path& file) {
  const toml::table table = read_toml(file);
  Reader reader(table, file.string());
  Lab lab;
  lab.folder = reader.text("lab");
  lab.number = lab_number(lab.folder);
  if (lab.number == 0 || lab.folder != fs::absolute(file).parent_path().filename())
    throw reader.error("lab", fmt::format("'{}' is not the name of the file's folder", lab.folder),
                       "rename one of them");
  lab.title = reader.text("title");
  lab.lesson = reader.text("lesson");
  reader.find("choice");
  lab.looks = read_looks(reader, lab.folder, "look");
  lab.openings = read_looks(reader, lab.folder, "opening");
  lab.steps = read_steps(reader, lab.number);
  lab.cases = read_cases(reader, lab.folder, lab.steps);
  for (const char* of_the_benchmark : {"bench", "claim", "driver_methods"}) reader.find(of_the_benchmark);
  reader.reject_unknown();
  return lab;
}

std::string copied_from(const fs::path& folder) {
  const fs::path file = folder / "lab.toml";
  std::error_code missing;
  if (!fs::exists(file, missing)) return {};
  // Not as TOML: check asks often.
  static const Pattern kLab("lab *= *\"([^\"]*)\".*");
  for (const std::string& line : lines_of(read_file(file))) {
    const Pattern::Groups found = kLab.match(line);
    if (found.empty()) continue;
    const std::string of = found[1];
    const bool is_copy = of != folder.filename() && lab_number(of) > 0 &&
                         fs::exists(folder.parent_path() / of / "lab.toml", missing);
    return is_copy ? of : "";
  }
  return {};
}

bool is_left_over(const fs::path& file) {
  static const Pattern kProgram(R"(.*\.(cpp|hpp|glsl|vert|frag).*)"),
      kPlain(R"([\w-]+\.(cpp|hpp|glsl|vert|frag))"),
      kMerged(R"(.*_(BACKUP|BASE|LOCAL|REMOTE)_.*)");  // by git mergetool
  const std::string name = file.filename();
  return !kProgram.match(name).empty() && !name.ends_with(".in") &&
         (kPlain.match(name).empty() || !kMerged.match(name).empty());
}

std::vector<Lab> read_labs(const fs::path& folder) {
  std::vector<Lab> labs;
  std::multimap<std::string, std::string> copies;
  std::error_code missing;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, missing)) {
    const fs::path file = entry.path() / "lab.toml";
    if (const std::string of = copied_from(entry.path()); !of.empty())
      copies.emplace(of, entry.path().filename());
    else if (fs::exists(file, missing))
      labs.push_back(read_lab(file));
  }
  for (Lab& lab : labs)
    for (auto [at, end] = copies.equal_range(lab.folder); at != end; ++at) lab.copies.push_back(at->second);
  if (labs.empty()) throw Error::failed("has no NN_name/lab.toml", {folder.string()});
  std::sort(labs.begin(), labs.end(), [](const Lab& a, const Lab& b) { return a.folder < b.folder; });
  return labs;
}

std::string flag(const Setting& setting) {
  std::string name = setting.parameter;
  std::replace(name.begin(), name.end(), '_', '-');
  return fmt::format(" --{} {}", name, params::shell_quoted(setting.value));
}

Lab with_public_cases(Lab lab) {
  std::erase_if(lab.cases, [](const Case& one) { return one.hidden; });
  return lab;
}

std::string command(const Lab& lab, const Case& of) {
  const Look usual;
  const bool is_graded = !of.step.empty();
  std::string text = fmt::format("./run lab {}", lab.number);
  for (Setting setting : of.settings) {
    // Where the grader's own files lie is nobody's business, and is not on the student's machine.
    if (setting.value.starts_with('/')) setting.value = fs::path(setting.value).filename();
    text += flag(setting);
  }
  if (of.is_mesh()) return text + fmt::format(" --mesh {}", of.file);
  if (of.view != usual.view) text += fmt::format(" --view {}", name_of(of.view));
  if (of.view == usual.view && is_graded) text += " --samples 1";
  if (of.size != usual.size || is_graded) text += fmt::format(" --size {}", as_text(of.size));
  return text + fmt::format(" --snapshot {}", of.file);
}

}  // namespace texel::course
