// SPDX-License-Identifier: MIT
#include "course/reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>

#include "core/files.hpp"

namespace texel::course {

Place place_of(const toml::node& node, const std::string& file) {
  const toml::source_position at = node.source().begin;
  return {file, static_cast<int>(at.line), static_cast<int>(at.column)};
}

int lab_of_step(const std::string& step) {
  const char* const end = step.data() + step.size();
  unsigned lab = 0, number = 0;
  const auto [point, lab_error] = std::from_chars(step.data(), end, lab);
  if (lab_error != std::errc{} || lab > 99 || point == end || *point != '.') return 0;
  const auto [rest, number_error] = std::from_chars(point + 1, end, number);
  return number_error == std::errc{} && rest == end ? static_cast<int>(lab) : 0;
}

toml::table read_toml(const std::filesystem::path& file) {
  try {
    return toml::parse(read_file(file), file.string());
  } catch (const toml::parse_error& error) {
    const toml::source_position at = error.source().begin;
    throw Error::failed(std::string(error.description()),
                        {file.string(), static_cast<int>(at.line), static_cast<int>(at.column)});
  }
}

Error Reader::error(const toml::node& node, const std::string& what, const std::string& remedy) const {
  return Error::failed(what, place_of(node, file_), remedy);
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
  return optional<std::string>(key, otherwise, "a text in quotes");
}

std::string Reader::text(const std::string& key) {
  std::string value = text(key, "");
  if (value.empty()) throw error(table_, fmt::format("'{}' is missing or empty", key));
  return value;
}

std::vector<const toml::table*> Reader::tables(const std::string& key) {
  const toml::node* node = find(key);
  if (node == nullptr) return {};
  std::vector<const toml::table*> found;
  const std::string rule = fmt::format("{}s are written as [[{}]] tables", key, key);
  const toml::array* array = node->as_array();
  if (array == nullptr) throw error(*node, rule);
  for (const toml::node& entry : *array) {
    if (!entry.is_table()) throw error(entry, rule);
    found.push_back(entry.as_table());
  }
  return found;
}

void Reader::reject_unknown() const {
  for (const auto& [key, node] : table_) {
    if (std::find(known_.begin(), known_.end(), key.str()) != known_.end()) continue;
    const std::string near = nearest(std::string(key.str()), known_);
    throw error(node, fmt::format("there is no key '{}'", key.str()),
                near.empty() ? fmt::format("the keys are {}", fmt::join(known_, ", "))
                             : fmt::format("did you mean '{}'?", near));
  }
}

}  // namespace texel::course
