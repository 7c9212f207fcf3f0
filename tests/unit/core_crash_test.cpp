// SPDX-License-Identifier: MIT
#include "core/crash.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/files.hpp"
#include "core/plain_text.hpp"
#include "core/process.hpp"

namespace texel {
namespace {

#ifdef CRASH_GUEST  // not for the sanitizers, which have their own ends of a program

TEST(CrashPlace, is_the_line_in_which_a_program_died_by_whatever_cause) {
  const std::vector<std::string> lines = lines_of(read_file(CRASH_GUEST_TEXT));
  for (const std::string what : {"memory", "division", "abort", "stack", "loop"}) {
    Confines confines;
    confines.working_folder = "/";
    confines.limits.cpu_seconds = 1;  // which the loop uses up
    const Outcome ended = run_plainly(confines, {CRASH_GUEST, what});
    const auto line =
        std::ranges::find_if(lines, [&](const auto& one) { return one.ends_with("// " + what); });
    EXPECT_EQ(crash_place(ended.errors, CRASH_GUEST, std::filesystem::path(CRASH_GUEST_TEXT).parent_path()),
              "support/crash_guest.cpp:" + std::to_string(line - lines.begin() + 1));
    EXPECT_EQ(crash_place(ended.errors, CRASH_GUEST, "/elsewhere/support"), "") << "it has no such file";
  }
}

#endif

}  // namespace
}  // namespace texel
