// SPDX-License-Identifier: MIT
#pragma once
#include <toml++/toml.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/error.hpp"

namespace texel::course {

/// Where a node stands in its file.
Place place_of(const toml::node& node, const std::string& file);

/// A TOML file as a table. Throws Error (exit 3) with file, line and column for broken TOML.
toml::table read_toml(const std::filesystem::path& file);

/// The lab of a step that is written as "5.1", two numbers with a point between them; 0 for a text that is
/// none.
int lab_of_step(const std::string& step);

/// A table of a file that is read key by key; what nobody asked for is an error.
class Reader {
 public:
  Reader(const toml::table& table, std::string file) : table_(table), file_(std::move(file)) {}

  [[nodiscard]] Error error(const toml::node& node, const std::string& what,
                            const std::string& remedy = {}) const;
  /// An error of the value at `key`, which was read already.
  [[nodiscard]] Error error(const std::string& key, const std::string& what,
                            const std::string& remedy = {}) const;

  /// The value at `key`, or nullptr.
  const toml::node* find(const std::string& key);

  /// The value at `key`, or `otherwise`; an error that it is `type` when it has another type than asked for.
  template <class Value>
  Value optional(const std::string& key, Value otherwise, const char* type) {
    const toml::node* node = find(key);
    if (node == nullptr) return otherwise;
    const std::optional<Value> value = node->value_exact<Value>();
    if (!value) throw error(*node, "'" + key + "' is " + type);
    return *value;
  }

  std::string text(const std::string& key, const std::string& otherwise);
  /// A text that must be there and not empty.
  std::string text(const std::string& key);

  /// The tables that the file writes as [[key]]; none when the key is missing.
  std::vector<const toml::table*> tables(const std::string& key);

  void reject_unknown() const;

 private:
  const toml::table& table_;
  std::string file_;
  std::vector<std::string> known_;
};

}  // namespace texel::course
