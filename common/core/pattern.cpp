// SPDX-License-Identifier: MIT
#include "core/pattern.hpp"

#include <regex>

namespace texel {

struct Pattern::Compiled {
  std::regex regex;
};

Pattern::Pattern(const std::string& expression) : compiled_(new Compiled{std::regex(expression)}) {}

Pattern::Groups Pattern::match(const std::string& text) const {
  std::smatch found;
  std::regex_match(text, found, compiled_->regex);
  return {found.begin(), found.end()};
}

Pattern::Groups Pattern::match_begin(const std::string& text) const {
  std::smatch found;
  std::regex_search(text, found, compiled_->regex, std::regex_constants::match_continuous);
  return {found.begin(), found.end()};
}

std::string Pattern::replace(const std::string& text,
                             const std::function<std::string(const Groups&)>& by) const {
  std::string result;
  auto at = text.begin();
  for (std::sregex_iterator found(at, text.end(), compiled_->regex), end; found != end; ++found) {
    result.append(at, (*found)[0].first).append(by({found->begin(), found->end()}));
    at = (*found)[0].second;
  }
  return result.append(at, text.end());
}

}  // namespace texel
