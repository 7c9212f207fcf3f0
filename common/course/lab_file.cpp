// SPDX-License-Identifier: MIT
#include "course/lab_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>

#include "core/files.hpp"
#include "core/plain_text.hpp"
#include "course/reader.hpp"
#include "params/set.hpp"

namespace texel::course {
namespace {

namespace fs = std::filesystem;

/// A parameter's value as the command line takes it.
std::string as_text(const toml::node& value, const Reader& reader) {
  if (const auto* toggle = value.as_boolean()) return toggle->get() ? "on" : "off";
  if (const auto* integer = value.as_integer()) return fmt::format("{}", integer->get());
  if (const auto* number = value.as_floating_point()) return fmt::format("{}", number->get());
  if (const auto* word = value.as_string()) return word->get();
  throw reader.error(value, "a parameter's value must be a text, number or boolean");
}

/// The entries of an inline table in the order of the file, which the table itself sorts by key.
std::vector<std::pair<std::string, const toml::node*>> in_order(const toml::table& table) {
  std::vector<std::pair<std::string, const toml::node*>> entries;
  for (const auto& [key, value] : table) entries.emplace_back(key.str(), &value);
  std::sort(entries.begin(), entries.end(),
            [](const auto& a, const auto& b) { return a.second->source().begin < b.second->source().begin; });
  return entries;
}

std::vector<Setting> read_settings(Reader& reader) {
  const toml::node* node = reader.find("set");
  if (node == nullptr) return {};
  const toml::table* table = node->as_table();
  if (table == nullptr) throw reader.error(*node, "'set' must be a table { parameter = value, … }");
  std::vector<Setting> settings;
  for (const auto& [parameter, value] : in_order(*table))
    settings.push_back({parameter, as_text(*value, reader)});
  return settings;
}

std::vector<Variation> read_variations(Reader& reader, const toml::table& bench) {
  const toml::node* node = reader.find("vary");
  const toml::table* table = node == nullptr ? nullptr : node->as_table();
  if (table == nullptr || table->empty())
    throw reader.error(
        node == nullptr ? bench : *node,
        "'vary' must be a table { parameter = [values], … }; [] stands for all values of a choice");
  std::vector<Variation> variations;
  for (const auto& [parameter, values] : in_order(*table)) {
    if (!values->is_array())
      throw reader.error(*values, fmt::format("'{}' must be a list of values", parameter));
    Variation variation{parameter, {}};
    for (const toml::node& value : *values->as_array()) variation.values.push_back(as_text(value, reader));
    variations.push_back(std::move(variation));
  }
  return variations;
}

bool is_file_name(const std::string& name) {
  return std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  });
}

View read_view(Reader& reader) {
  const std::string name = reader.text("view", name_of(View::color));
  const std::optional<View> view = find_view(name);
  if (!view) throw reader.error("view", fmt::format("there is no view '{}'", name));
  return *view;
}

/// A view that can be seen: only the cases of a step may have the vertex stream.
View read_picture_view(Reader& reader) {
  const View view = read_view(reader);
  if (view == View::mesh)
    throw reader.error("view", "a mesh is no picture: only a [[case]] has the view 'mesh'");
  return view;
}

/// What every case of a lab file has.
void read_case(Reader& reader, const std::string& lab, Case& one) {
  one.lab = lab;
  one.settings = read_settings(reader);
  const std::string size = reader.text("size", as_text(one.size));
  if (const auto found = find_size(size))
    one.size = *found;
  else
    throw reader.error("size", fmt::format("'{}' is not a size", size), "write WIDTHxHEIGHT in pixels");
}

Look read_look(Reader& reader, const std::string& lab) {
  Look look;
  look.name = reader.text("name");
  look.file = look.name + ".png";
  look.caption = reader.text("caption");
  read_case(reader, lab, look);
  look.view = read_picture_view(reader);
  look.source = reader.text("source", look.source);
  look.hero = reader.optional("hero", look.hero, "true or false");
  reader.reject_unknown();
  return look;
}

std::vector<Look> read_looks(Reader& head, const std::string& file, const std::string& lab) {
  std::vector<Look> looks;
  for (const toml::table* table : head.tables("look")) {
    Reader reader(*table, file);
    Look look = read_look(reader, lab);
    if (!is_file_name(look.name))
      throw head.error(*table, fmt::format("'{}' is not a valid picture name", look.name),
                       "use lower-case letters, digits, '_' and '-'");
    if (std::any_of(looks.begin(), looks.end(), [&](const Look& l) { return l.name == look.name; }))
      throw head.error(*table, fmt::format("two looks are called '{}'", look.name));
    looks.push_back(std::move(look));
  }
  return looks;
}

std::vector<BenchCase> read_bench(Reader& head, const std::string& file, const std::string& lab) {
  std::vector<BenchCase> cases;
  for (const toml::table* table : head.tables("bench")) {
    Reader reader(*table, file);
    BenchCase c;
    c.name = reader.text("case");
    c.teaches = reader.text("teaches");
    c.hard = reader.optional("hard", c.hard, "true or false");
    c.size = {256, 256};
    read_case(reader, lab, c);
    c.variations = read_variations(reader, *table);
    reader.reject_unknown();
    if (std::any_of(cases.begin(), cases.end(), [&](const BenchCase& other) { return other.name == c.name; }))
      throw head.error(*table, fmt::format("two cases are called '{}'", c.name));
    cases.push_back(std::move(c));
  }
  return cases;
}

std::vector<Claim> read_claims(Reader& head, const std::string& file) {
  std::vector<Claim> claims;
  for (const toml::table* table : head.tables("claim")) {
    Reader reader(*table, file);
    claims.push_back({reader.text("source"), reader.text("says"), reader.text("found"), reader.text("see")});
    reader.reject_unknown();
  }
  return claims;
}

std::vector<std::string> read_texts(Reader& reader, const std::string& key) {
  const toml::node* node = reader.find(key);
  if (node == nullptr) return {};
  std::vector<std::string> texts;
  const toml::array* array = node->as_array();
  for (std::size_t i = 0; array != nullptr && i < array->size(); ++i)
    if (const auto* text = array->get(i)->as_string(); text != nullptr && !text->get().empty())
      texts.push_back(text->get());
  if (array == nullptr || texts.size() != array->size())
    throw reader.error(*node, fmt::format("'{}' must be a list of texts", key));
  return texts;
}

double read_number(Reader& reader, const std::string& key, const toml::table& table) {
  const toml::node* node = reader.find(key);
  const std::optional<double> value = node == nullptr ? std::nullopt : node->value<double>();
  if (!value || !(*value >= 0))
    throw reader.error(node == nullptr ? table : *node,
                       fmt::format("'{}' must be a number, 0 or larger", key));
  return *value;
}

bool has_step(const std::vector<Step>& steps, const std::string& id) {
  return std::any_of(steps.begin(), steps.end(), [&](const Step& step) { return step.id == id; });
}

std::vector<Step> read_steps(Reader& head, const std::string& file, int lab) {
  std::vector<Step> steps;
  for (const toml::table* table : head.tables("step")) {
    Reader reader(*table, file);
    Step step;
    step.id = reader.text("id");
    step.title = reader.text("title");
    step.points = read_number(reader, "points", *table);
    step.needs = read_texts(reader, "needs");
    step.hints = read_texts(reader, "hints");
    step.see.settings = read_settings(reader);
    step.see.view = read_picture_view(reader);
    step.seen_with = read_texts(reader, "seen_with");
    reader.reject_unknown();
    const std::string expected = fmt::format("{}.{}", lab, steps.size() + 1);
    if (step.id != expected)
      throw reader.error("id",
                         fmt::format("this is step '{}', but the next one must be '{}'", step.id, expected));
    for (const std::string& need : step.needs)
      if (const int of = lab_of_step(need); (of == 0 || of >= lab) && !has_step(steps, need))
        throw reader.error("needs", fmt::format("there is no step '{}' before this one", need));
    if (step.hints.empty() || step.hints.size() > 3)
      throw reader.error("hints", "a step must have one to three hints");
    steps.push_back(std::move(step));
  }
  for (const Step& step : steps)
    for (const std::string& later : step.seen_with)
      if (!has_step(steps, later) || later == step.id)
        throw head.error("step", fmt::format("step '{}' cannot be seen with '{}'", step.id, later),
                         "seen_with names other steps of this lab");
  return steps;
}

std::vector<Hidden> read_hidden(Reader& reader) {
  const toml::node* node = reader.find("hidden");
  if (node == nullptr) return {};
  const toml::table* table = node->as_table();
  if (table == nullptr) throw reader.error(*node, "'hidden' must be a table { parameter = [values], … }");
  std::vector<Hidden> all;
  for (const auto& [parameter, values] : in_order(*table)) {
    Hidden hidden{parameter, 0, 0, {}};
    const toml::array* array = values->as_array();
    const bool is_range =
        array != nullptr && array->size() == 2 && array->get(0)->is_number() && array->get(1)->is_number();
    if (is_range) {
      hidden.least = *array->get(0)->value<double>();
      hidden.most = *array->get(1)->value<double>();
    } else {
      for (std::size_t i = 0; array != nullptr && i < array->size(); ++i)
        hidden.values.push_back(as_text(*array->get(i), reader));
    }
    if (is_range ? !(hidden.least < hidden.most) : hidden.values.size() < 2)
      throw reader.error(*values, fmt::format("'{}' must be a range [least, most] of numbers, or a "
                                              "list of two texts or more",
                                              parameter));
    all.push_back(std::move(hidden));
  }
  return all;
}

std::vector<GradedCase> read_cases(Reader& head, const std::string& file, const std::string& lab,
                                   const std::vector<Step>& steps) {
  std::vector<GradedCase> cases;
  for (const toml::table* table : head.tables("case")) {
    Reader reader(*table, file);
    GradedCase c;
    c.name = reader.text("name");
    c.step = reader.text("step");
    c.size = {128, 128};
    read_case(reader, lab, c);
    c.view = read_view(reader);
    c.file = c.name + (c.is_mesh() ? ".ply" : c.view == View::color ? ".png" : ".pfm");
    c.limit = read_number(reader, "limit", *table);
    c.why = reader.text("why");
    c.hidden_settings = read_hidden(reader);
    c.hidden = !c.hidden_settings.empty() ||
               std::any_of(c.settings.begin(), c.settings.end(),
                           [](const Setting& setting) { return setting.value.starts_with(kUnseen); });
    reader.reject_unknown();
    if (!is_file_name(c.name))
      throw reader.error("name", fmt::format("'{}' is not a valid case name", c.name),
                         "use lower-case letters, digits, '_' and '-'");
    if (std::any_of(cases.begin(), cases.end(),
                    [&](const GradedCase& other) { return other.name == c.name; }))
      throw reader.error("name", fmt::format("two cases are called '{}'", c.name));
    if (!has_step(steps, c.step)) throw reader.error("step", fmt::format("there is no step '{}'", c.step));
    cases.push_back(std::move(c));
  }
  for (const Step& step : steps)
    if (std::none_of(cases.begin(), cases.end(), [&](const GradedCase& c) { return c.step == step.id; }))
      throw head.error("step", fmt::format("no case judges step '{}'", step.id));
  return cases;
}

/// Looks for the steps of other labs that a step needs: read_steps has seen but one lab.
void check_needs(const std::vector<Lab>& labs, const fs::path& folder) {
  for (const Lab& lab : labs)
    for (const Step& step : lab.steps)
      for (const std::string& need : step.needs)
        if (std::none_of(labs.begin(), labs.end(),
                         [&](const Lab& earlier) { return has_step(earlier.steps, need); }))
          throw Error::failed(fmt::format("step '{}' needs step '{}', but no lab has it", step.id, need),
                              {(folder / lab.folder / "lab.toml").string()});
}

/// "05_normal_map" is lab 5; 0 for a folder that is none.
int lab_number(const std::string& folder) {
  const auto digit = [&](std::size_t i) { return folder[i] >= '0' && folder[i] <= '9'; };
  if (folder.size() < 4 || !digit(0) || !digit(1) || folder[2] != '_') return 0;
  return (folder[0] - '0') * 10 + (folder[1] - '0');
}

constexpr const char* kSides[] = {"_BACKUP_", "_BASE_", "_LOCAL_", "_REMOTE_"};

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
  lab.looks = read_looks(reader, file.string(), lab.folder);
  lab.bench = read_bench(reader, file.string(), lab.folder);
  lab.claims = read_claims(reader, file.string());
  lab.choice = reader.text("choice", "");
  lab.driver_methods = read_texts(reader, "driver_methods");
  lab.steps = read_steps(reader, file.string(), lab.number);
  lab.cases = read_cases(reader, file.string(), lab.folder, lab.steps);
  reader.reject_unknown();
  return lab;
}

std::string copied_from(const fs::path& folder) {
  std::error_code missing;
  if (!fs::exists(folder / "lab.toml", missing)) return {};
  // Not as TOML: check asks often.
  for (const std::string& line : lines_of(read_file(folder / "lab.toml"))) {
    const std::size_t begin = line.find('"') + 1, end = line.find('"', begin);
    if (!line.starts_with("lab") || line.find_first_not_of(" =", 3) + 1 != begin || end == line.npos)
      continue;
    const std::string of = line.substr(begin, end - begin);
    const bool is_copy = of != folder.filename() && lab_number(of) > 0 &&
                         fs::exists(folder.parent_path() / of / "lab.toml", missing);
    return is_copy ? of : "";
  }
  return {};
}

bool is_left_over(const fs::path& file) {
  const std::string name = file.filename(), stem = file.stem();
  for (const char* ending : {".cpp", ".hpp", ".glsl", ".vert", ".frag"}) {
    if (name.find(ending) == name.npos || file.extension() == ".in") continue;
    const bool is_plain =
        file.extension() == ending && std::all_of(stem.begin(), stem.end(), [](unsigned char c) {
          return std::isalnum(c) != 0 || c == '_' || c == '-';
        });
    // What git mergetool makes.
    return !is_plain || std::any_of(std::begin(kSides), std::end(kSides),
                                    [&](const char* side) { return stem.find(side) != stem.npos; });
  }
  return false;
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
  check_needs(labs, folder);
  return labs;
}

std::string flag(const Setting& setting) {
  std::string name = setting.parameter;
  std::replace(name.begin(), name.end(), '_', '-');
  return fmt::format(" --{} {}", name, params::shell_quoted(setting.value));
}

std::string command(const Lab& lab, const Look& look) {
  const Look usual;
  std::string text = fmt::format("./run lab {}", lab.number);
  for (const Setting& setting : look.settings) text += flag(setting);
  if (look.view != usual.view) text += fmt::format(" --view {}", name_of(look.view));
  if (look.size != usual.size) text += fmt::format(" --size {}", as_text(look.size));
  return text + fmt::format(" --snapshot {}", look.file);
}

}  // namespace texel::course
