// SPDX-License-Identifier: MIT
#pragma once
#include <toml++/toml.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "core/error.hpp"

namespace texel::course {

/// A TOML file as a table. Throws Error (exit 3) with file, line, column and remedy for broken TOML.
toml::table read_toml(const std::filesystem::path& file, const std::string& remedy = {});

/// A table of a file that is read key by key; what nobody asked for is an error. All members throw Error
/// (exit 3) with file, line and column for what is not as it must be.
class Reader {
 public:
  Reader(const toml::table& table, std::string file) : table_(table), file_(std::move(file)) {}

  /// An error of a value, or of the one at `key`, or of the table where the key is missing.
  [[nodiscard]] Error error(const toml::node& node, const std::string& what,
                            const std::string& remedy = {}) const;
  [[nodiscard]] Error error(const std::string& key, const std::string& what,
                            const std::string& remedy = {}) const;

  /// The value at `key`, or nullptr.
  const toml::node* find(const std::string& key);

  std::string text(const std::string& key, const std::string& otherwise);
  /// A text that must be there and not empty.
  std::string text(const std::string& key);
  /// Texts that are not empty; none when the key is missing.
  std::vector<std::string> texts(const std::string& key);
  /// False when the key is missing.
  bool toggle(const std::string& key);
  /// A number that must be there, 0 or larger.
  double number(const std::string& key);

  /// The entries of the table { parameter = `values`, … } at `key`, in the file's order; none when the key is
  /// missing.
  std::vector<std::pair<std::string, const toml::node*>> entries(const std::string& key,
                                                                 const std::string& values);
  /// A parameter's value as the command line takes it.
  [[nodiscard]] std::string setting(const toml::node& value) const;

  /// The tables that the file writes as [[key]]; none when the key is missing.
  std::vector<Reader> tables(const std::string& key);

  void reject_unknown() const;

 private:
  const toml::table& table_;
  std::string file_;
  std::vector<std::string> known_;
};

}  // namespace texel::course
