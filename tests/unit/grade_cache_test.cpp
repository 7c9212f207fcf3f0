// SPDX-License-Identifier: MIT
// What the grader's cache keeps, and for how long.
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>

#include "../../teach/grade/cache.hpp"
#include "core/files.hpp"

namespace texel::grade {
namespace {

namespace fs = std::filesystem;

class Kept : public testing::Test {
 protected:
  /// A folder of the cache with something in it that was last used so many days ago.
  fs::path used_before(int days, const std::string& name) {
    const fs::path folder = cache_.path() / name;
    fs::create_directories(folder);
    write_file(folder / "thing", "made once");
    fs::last_write_time(folder, fs::file_time_type::clock::now() - std::chrono::days(days));
    return folder;
  }

  ScratchFolder cache_;
};

TEST_F(Kept, goes_after_a_month_without_use_and_starters_after_a_week) {
  const std::string a(64, 'a'), b = "0123456789abcdef";
  const std::tuple<int, std::string, bool> rows[] = {
      {29, "objects/" + a, true},
      {31, "objects/" + b, false},
      {29, "solutions/programs/" + a, true},
      {31, "solutions/programs/" + b, false},
      {31, "solutions/objects/" + a, false},
      {31, "programs/" + a, false},
      {31, "references/" + std::string(32, '0'), false},
      {6, "starter-" + b, true},
      {8, "starter-fedcba9876543210", false},
      {400, "models/" + b, true},
      // --cache may name a folder that holds more than the grader's.
      {4000, "programs/my_ray_tracer", true},
      {4000, "references/papers_of_the_year_2020", true},
      {4000, "starter-code-for-lab-1", true},
      {4000, "objects/cafe", true},
      {4000, "references-2024", true}};
  for (const auto& [days, name, stays] : rows) used_before(days, name);
  remove_unused(cache_.path());
  for (const auto& [days, name, stays] : rows) EXPECT_EQ(fs::exists(cache_.path() / name), stays) << name;
}

TEST_F(Kept, counts_as_used_when_it_is_asked_for) {
  const fs::path old = used_before(31, "programs/" + std::string(64, 'a'));
  EXPECT_TRUE(is_cached(old));
  EXPECT_FALSE(is_cached(cache_.path() / "programs" / std::string(64, 'b')));
  remove_unused(cache_.path());
  EXPECT_TRUE(fs::exists(old / "thing"));
}

TEST_F(Kept, of_a_cache_that_is_not_there_is_nothing) {
  remove_unused(cache_.path() / "nowhere");
  EXPECT_FALSE(fs::exists(cache_.path() / "nowhere"));
}

}  // namespace
}  // namespace texel::grade
