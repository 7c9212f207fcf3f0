// SPDX-License-Identifier: MIT
// What an error says, and texts with one part or another.
#pragma once
#include <gtest/gtest.h>

#include <string>

#include "core/error.hpp"

namespace texel::test {

inline bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// The text with `by` in place of `what`, where it stands first.
inline std::string replaced(std::string text, const std::string& what, const std::string& by) {
  return text.replace(text.find(what), what.size(), by);
}

/// The message of the Error that `act` throws, which has that exit code; "" when it throws none.
template <class Act>
std::string error_of(Act&& act, Exit exit_code = Exit::failed) {
  try {
    act();
  } catch (const Error& error) {
    EXPECT_EQ(error.exit_code(), exit_code) << error.what();
    return error.what();
  }
  return "";
}

}  // namespace texel::test
