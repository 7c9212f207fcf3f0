// SPDX-License-Identifier: MIT
// What the grader's cache keeps, and for how long.
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>

#include "../../teach/grade/cache.hpp"
#include "core/files.hpp"
#include "core/scratch_folder.hpp"

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
  const fs::path stay[] = {used_before(29, "objects/" + a), used_before(29, "solutions/programs/" + a),
                           used_before(6, "starter-" + b), used_before(400, "models/" + b)};
  const fs::path go[] = {used_before(31, "objects/" + b),
                         used_before(31, "programs/" + a),
                         used_before(31, "references/" + std::string(32, '0')),
                         used_before(31, "solutions/objects/" + a),
                         used_before(31, "solutions/programs/" + b),
                         used_before(8, "starter-fedcba9876543210")};
  remove_unused(cache_.path());
  for (const fs::path& folder : stay) EXPECT_TRUE(fs::exists(folder / "thing")) << folder;
  for (const fs::path& folder : go) EXPECT_FALSE(fs::exists(folder)) << folder;
}

/// --cache may name a folder that holds more than the grader's.
TEST_F(Kept, leaves_alone_what_is_somebody_elses) {
  const fs::path stay[] = {used_before(4000, "programs/my_ray_tracer"),
                           used_before(4000, "references/papers_of_the_year_2020"),
                           used_before(4000, "starter-code-for-lab-1"), used_before(4000, "objects/cafe"),
                           used_before(4000, "references-2024")};
  remove_unused(cache_.path());
  for (const fs::path& folder : stay) EXPECT_TRUE(fs::exists(folder / "thing")) << folder;
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
