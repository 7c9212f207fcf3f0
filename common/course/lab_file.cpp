// SPDX-License-Identifier: MIT
#include "course/lab_file.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>

#include "core/error.hpp"
#include "core/files.hpp"
#include "params/set.hpp"

namespace texel::course {
namespace {

namespace fs = std::filesystem;

/// A table of the file that is read key by key; what nobody asked for is an error.
class Reader {
 public:
  Reader(const toml::table& table, std::string file) : table_(table), file_(std::move(file)) {}

  [[nodiscard]] Error error(const toml::node& node, const std::string& what,
                            const std::string& remedy = {}) const {
    const toml::source_position at = node.source().begin;
    return Error::failed(what, {file_, static_cast<int>(at.line), static_cast<int>(at.column)}, remedy);
  }

  const toml::node* find(const std::string& key) {
    known_.push_back(key);
    return table_.get(key);
  }

  template <class Value>
  Value optional(const std::string& key, Value otherwise, const char* type) {
    const toml::node* node = find(key);
    if (node == nullptr) return otherwise;
    const std::optional<Value> value = node->value_exact<Value>();
    if (!value) throw error(*node, fmt::format("'{}' is {}", key, type));
    return *value;
  }

  std::string text(const std::string& key, const std::string& otherwise) {
    return optional<std::string>(key, otherwise, "a text in quotes");
  }

  std::string text(const std::string& key) {
    std::string value = text(key, "");
    if (value.empty()) throw error(table_, fmt::format("'{}' is missing or empty", key));
    return value;
  }

  void reject_unknown() const {
    for (const auto& [key, node] : table_) {
      if (std::find(known_.begin(), known_.end(), key.str()) != known_.end()) continue;
      const std::string near = nearest(std::string(key.str()), known_);
      throw error(node, fmt::format("there is no key '{}'", key.str()),
                  near.empty() ? fmt::format("the keys are {}", fmt::join(known_, ", "))
                               : fmt::format("did you mean '{}'?", near));
    }
  }

 private:
  const toml::table& table_;
  std::string file_;
  std::vector<std::string> known_;
};

std::vector<Setting> read_settings(Reader& reader) {
  const toml::node* node = reader.find("set");
  if (node == nullptr) return {};
  const toml::table* table = node->as_table();
  if (table == nullptr) throw reader.error(*node, "'set' is a table { parameter = value, … }");
  std::vector<std::pair<toml::source_position, Setting>> found;
  for (const auto& [key, value] : *table) {
    std::string text;
    if (const auto* toggle = value.as_boolean())
      text = toggle->get() ? "on" : "off";
    else if (const auto* integer = value.as_integer())
      text = fmt::format("{}", integer->get());
    else if (const auto* number = value.as_floating_point())
      text = fmt::format("{}", number->get());
    else if (const auto* word = value.as_string())
      text = word->get();
    else
      throw reader.error(value, "a parameter's value is a text, number or boolean");
    found.emplace_back(value.source().begin, Setting{std::string(key.str()), text});
  }
  // The table is sorted by key; the author's order reads better in a command.
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Setting> settings;
  for (auto& [position, setting] : found) settings.push_back(std::move(setting));
  return settings;
}

bool is_file_name(const std::string& name) {
  return std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  });
}

Look read_look(Reader& reader) {
  Look look;
  look.name = reader.text("name");
  look.caption = reader.text("caption");
  look.settings = read_settings(reader);
  look.view = reader.text("view", look.view);
  look.size = reader.text("size", look.size);
  look.source = reader.text("source", look.source);
  look.hero = reader.optional("hero", look.hero, "true or false");
  reader.reject_unknown();
  return look;
}

std::vector<Look> read_looks(const toml::node& node, const Reader& head, const std::string& file) {
  const toml::array* tables = node.as_array();
  if (tables == nullptr) throw head.error(node, "looks are written as [[look]] tables");
  std::vector<Look> looks;
  for (const toml::node& entry : *tables) {
    if (!entry.is_table()) throw head.error(entry, "looks are written as [[look]] tables");
    Reader reader(*entry.as_table(), file);
    Look look = read_look(reader);
    if (!is_file_name(look.name))
      throw head.error(entry, fmt::format("'{}' is no picture's name", look.name),
                       "use lower-case letters, digits, '_' and '-'");
    if (std::any_of(looks.begin(), looks.end(), [&](const Look& l) { return l.name == look.name; }))
      throw head.error(entry, fmt::format("two looks are called '{}'", look.name));
    looks.push_back(std::move(look));
  }
  return looks;
}

toml::table parse(const fs::path& file) {
  try {
    return toml::parse(read_file(file), file.string());
  } catch (const toml::parse_error& error) {
    const toml::source_position at = error.source().begin;
    throw Error::failed(std::string(error.description()),
                        {file.string(), static_cast<int>(at.line), static_cast<int>(at.column)});
  }
}

/// "05_normal_map" is lab 5; 0 for a folder that is none.
int lab_number(const std::string& folder) {
  const auto digit = [&](std::size_t i) { return folder[i] >= '0' && folder[i] <= '9'; };
  if (folder.size() < 4 || !digit(0) || !digit(1) || folder[2] != '_') return 0;
  return (folder[0] - '0') * 10 + (folder[1] - '0');
}

}  // namespace

Lab read_lab(const fs::path& file) {
  const toml::table table = parse(file);
  Reader reader(table, file.string());
  Lab lab;
  lab.folder = reader.text("lab");
  lab.number = lab_number(lab.folder);
  if (lab.number == 0 || lab.folder != fs::absolute(file).parent_path().filename())
    throw reader.error(*table.get("lab"),
                       fmt::format("'{}' is not the name of the file's folder", lab.folder));
  lab.title = reader.text("title");
  lab.lesson = reader.text("lesson");
  if (const toml::node* looks = reader.find("look")) lab.looks = read_looks(*looks, reader, file.string());
  reader.find("step");
  reader.find("case");
  reader.reject_unknown();
  return lab;
}

std::vector<Lab> read_labs(const fs::path& folder) {
  std::vector<Lab> labs;
  std::error_code missing;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, missing)) {
    const fs::path file = entry.path() / "lab.toml";
    if (fs::exists(file)) labs.push_back(read_lab(file));
  }
  if (labs.empty()) throw Error::failed("holds no NN_name/lab.toml", {folder.string()});
  std::sort(labs.begin(), labs.end(), [](const Lab& a, const Lab& b) { return a.folder < b.folder; });
  return labs;
}

std::string command(const Lab& lab, const Look& look) {
  const Look usual;
  std::string text = fmt::format("./run lab {}", lab.number);
  for (const Setting& setting : look.settings) {
    std::string flag = setting.parameter;
    std::replace(flag.begin(), flag.end(), '_', '-');
    text += fmt::format(" --{} {}", flag, params::shell_quoted(setting.value));
  }
  if (look.view != usual.view) text += fmt::format(" --view {}", look.view);
  if (look.size != usual.size) text += fmt::format(" --size {}", look.size);
  return text + fmt::format(" --snapshot {}.png", look.name);
}

}  // namespace texel::course
