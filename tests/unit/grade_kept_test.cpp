// SPDX-License-Identifier: MIT
// What the grader's cache keeps, and for how long.
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>

#include "../../common/grade/kept.hpp"
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
  const fs::path stay[] = {used_before(29, "objects/a"), used_before(29, "solutions/programs/b"),
                           used_before(6, "starter-c"), used_before(400, "models/of_a_seed")};
  const fs::path go[] = {used_before(31, "objects/d"),
                         used_before(31, "programs/e"),
                         used_before(31, "references/f"),
                         used_before(31, "solutions/objects/g"),
                         used_before(31, "solutions/programs/h"),
                         used_before(8, "starter-i"),
                         used_before(8, "solutions/compile-1-2"),
                         used_before(8, "references-3-4")};
  remove_unused(cache_.path());
  for (const fs::path& folder : stay) EXPECT_TRUE(fs::exists(folder / "thing")) << folder;
  for (const fs::path& folder : go) EXPECT_FALSE(fs::exists(folder)) << folder;
}

TEST_F(Kept, counts_as_used_when_it_is_asked_for) {
  const fs::path old = used_before(31, "programs/a");
  EXPECT_TRUE(is_kept(old));
  EXPECT_FALSE(is_kept(cache_.path() / "programs/b"));
  remove_unused(cache_.path());
  EXPECT_TRUE(fs::exists(old / "thing"));
}

TEST_F(Kept, of_a_cache_that_is_not_there_is_nothing) {
  remove_unused(cache_.path() / "nowhere");
  EXPECT_FALSE(fs::exists(cache_.path() / "nowhere"));
}

}  // namespace
}  // namespace texel::grade
