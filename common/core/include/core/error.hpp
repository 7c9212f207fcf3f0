// SPDX-License-Identifier: MIT
#pragma once
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace texel {

/// Exit codes of every program: a contract with the scripts that call us.
enum class Exit { holds = 0, differs = 1, usage = 2, failed = 3 };

/// Where something is wrong. An unknown line or column is 0.
struct Place {
  std::string file;
  int line = 0;
  int column = 0;
};

/// One clear error: what is wrong, where, and what to try. Thrown only while loading, parsing, linking and
/// reading arguments; `what()` is `file:line:column: what; remedy`.
class Error : public std::runtime_error {
 public:
  /// The arguments are wrong: exit code 2.
  static Error usage(const std::string& what, const std::string& remedy = {});
  /// Something could not be loaded, rendered, written or compared: exit code 3.
  static Error failed(const std::string& what, const Place& place = {}, const std::string& remedy = {});

  [[nodiscard]] Exit exit_code() const { return exit_; }
  [[nodiscard]] const Place& place() const { return place_; }

 private:
  Error(Exit exit, const std::string& text, Place place);
  Exit exit_;
  Place place_;
};

/// "did you mean 'gallery'?" with the nearest of `choices` to a mistyped `word` (edit distance at most a
/// third of its length), or `otherwise` when none is near.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& choices,
                         const std::string& otherwise = {});

}  // namespace texel
