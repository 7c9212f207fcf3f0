// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace texel {

/// A regular expression of ECMAScript. std::regex takes each file that names it two seconds to compile.
class Pattern {
 public:
  /// What matched, then its groups; "" for a group that took no part. Empty if nothing matched.
  using Groups = std::vector<std::string>;

  explicit Pattern(const std::string& expression);

  [[nodiscard]] Groups match(const std::string& text) const;        ///< the whole text
  [[nodiscard]] Groups match_begin(const std::string& text) const;  ///< its first characters
  /// Every place that matches becomes what `by` makes of it, from the left.
  [[nodiscard]] std::string replace(const std::string& text,
                                    const std::function<std::string(const Groups&)>& by) const;

 private:
  struct Compiled;
  std::shared_ptr<const Compiled> compiled_;
};

}  // namespace texel
