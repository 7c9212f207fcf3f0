// SPDX-License-Identifier: MIT
// A program that dies in the way that it is asked for, for the tests of core/crash.hpp.
#include <csignal>
#include <cstdlib>
#include <string>

#include "core/crash.hpp"

namespace {

volatile int zero = 0;
int* volatile nowhere = nullptr;

/// Nearly all of a call writes its room: there the stack ends.
int goes_down(int depth) {
  volatile char room[65536] = {};  // stack
  if (depth < 0) return 0;
  return room[depth % 65536] + goes_down(depth + 1) + 1;
}

}  // namespace

int main(int, char** argv) {
  texel::report_crashes();
  const std::string what = argv[1];
  if (what == "memory") *nowhere = 1;          // memory
  if (what == "division") return 1000 / zero;  // division
  if (what == "abort") std::abort();           // abort
  if (what == "stack") return goes_down(0);
  while (what == "loop" && zero == 0) continue;  // loop
  return 0;
}
