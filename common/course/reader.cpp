// SPDX-License-Identifier: MIT
#include "course/reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/files.hpp"

namespace texel::course {
namespace {

Place place_at(const toml::source_region& source, const std::string& file) {
  return {file, static_cast<int>(source.begin.line), static_cast<int>(source.begin.column)};
}

}  // namespace

toml::table read_toml(const std::filesystem::path& file, const std::string& remedy) {
  try {
    return toml::parse(read_file(file), file.string());
  } catch (const toml::parse_error& error) {
    throw Error::failed(std::string(error.description()), place_at(error.source(), file.string()), remedy);
  }
}

Error Reader::error(const toml::node& node, const std::string& what, const std::string& remedy) const {
  return Error::failed(what, place_at(node.source(), file_), remedy);
}

Error Reader::error(const std::string& key, const std::string& what, const std::string& remedy) const {
  const toml::node* node = table_.get(key);
  return error(node == nullptr ? table_ : *node, what, remedy);
}

const toml::node* Reader::find(const std::string& key) {
  if (std::find(known_.begin(), known_.end(), key) == known_.end()) known_.push_back(key);
  return table_.get(key);
}

std::string Reader::text(const std::string& key, const std::string& otherwise) {
  const toml::node* node = find(key);
  if (node == nullptr) return otherwise;
  if (!node->is_string()) throw error(*node, fmt::format("'{}' is a text in quotes", key));
  return node->as_string()->get();
}

std::string Reader::text(const std::string& key) {
  std::string value = text(key, "");
  if (value.empty()) throw error(table_, fmt::format("'{}' is missing or empty", key));
  return value;
}

std::vector<std::string> Reader::texts(const std::string& key) {
  const toml::node* node = find(key);
  if (node == nullptr) return {};
  const std::string rule = fmt::format("'{}' must be a list of texts", key);
  if (!node->is_array()) throw error(*node, rule);
  std::vector<std::string> texts;
  for (const toml::node& one : *node->as_array()) {
    texts.push_back(one.value_or(std::string()));
    if (texts.back().empty()) throw error(*node, rule);
  }
  return texts;
}

bool Reader::toggle(const std::string& key) {
  const toml::node* node = find(key);
  if (node != nullptr && !node->is_boolean()) throw error(*node, fmt::format("'{}' is true or false", key));
  return node != nullptr && node->as_boolean()->get();
}

double Reader::number(const std::string& key) {
  const toml::node* node = find(key);
  const double value = node == nullptr ? -1 : node->value_or(-1.0);
  if (!(value >= 0)) throw error(key, fmt::format("'{}' must be a number, 0 or larger", key));
  return value;
}

std::vector<std::pair<std::string, const toml::node*>> Reader::entries(const std::string& key,
                                                                       const std::string& values) {
  const toml::node* node = find(key);
  if (node == nullptr) return {};
  if (!node->is_table())
    throw error(*node, fmt::format("'{}' must be a table {{ parameter = {}, … }}", key, values));
  std::vector<std::pair<std::string, const toml::node*>> entries;
  for (const auto& [parameter, value] : *node->as_table()) entries.emplace_back(parameter.str(), &value);
  // The table itself sorts them by key.
  std::sort(entries.begin(), entries.end(),
            [](const auto& a, const auto& b) { return a.second->source().begin < b.second->source().begin; });
  return entries;
}

std::string Reader::setting(const toml::node& value) const {
  if (const auto* toggle = value.as_boolean()) return toggle->get() ? "on" : "off";
  if (const auto* integer = value.as_integer()) return fmt::format("{}", integer->get());
  if (const auto* number = value.as_floating_point()) return fmt::format("{}", number->get());
  if (const auto* word = value.as_string()) return word->get();
  throw error(value, "a parameter's value must be a text, number or boolean");
}

std::vector<Reader> Reader::tables(const std::string& key) {
  const toml::node* node = find(key);
  if (node == nullptr) return {};
  const std::string rule = fmt::format("{}s are written as [[{}]] tables", key, key);
  if (!node->is_array()) throw error(*node, rule);
  std::vector<Reader> found;
  for (const toml::node& entry : *node->as_array()) {
    if (!entry.is_table()) throw error(entry, rule);
    found.emplace_back(*entry.as_table(), file_);
  }
  return found;
}

void Reader::reject_unknown() const {
  for (const auto& [key, node] : table_) {
    if (std::find(known_.begin(), known_.end(), key.str()) != known_.end()) continue;
    throw error(node, fmt::format("there is no key '{}'", key.str()),
                did_you_mean(key.str(), known_, fmt::format("the keys are {}", fmt::join(known_, ", "))));
  }
}

}  // namespace texel::course
