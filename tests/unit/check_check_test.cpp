// SPDX-License-Identifier: MIT
// What a check leaves where the tree's own pictures lie.
#include "check/check.hpp"

#include <gtest/gtest.h>

#include <atomic>

#include "../support/picture_files.hpp"
#include "../support/said.hpp"
#include "core/error.hpp"
#include "core/files.hpp"
#include "image/load.hpp"
#include "image/save.hpp"
#include "judge/judge.hpp"

namespace texel::check {
namespace {

namespace fs = std::filesystem;

class CheckedPictures : public testing::Test {
 protected:
  CheckedPictures() {
    for (course::Lab& lab : course::read_labs(tree_.source / "labs"))
      if (lab.number == 6) lab_ = std::move(lab);
  }

  /// Of these cases: others are drawn in the same folder at the same time.
  using Spoil = std::function<void(const fs::path& out, const std::vector<course::Case>& cases)>;

  /// Draws as the solution does; then `spoil` may change what was drawn.
  std::map<std::string, judge::CaseResult> checked(const Spoil& spoil = {}) const {
    const Draws draws = [&](const course::Lab& lab, const std::vector<course::Case>& cases,
                            const fs::path& out) {
      fs::create_directories(out);
      for (const course::Case& one : cases)
        fs::copy_file(expected_folder(tree_.source, lab) / one.file, out / one.file,
                      fs::copy_options::overwrite_existing);
      if (spoil) spoil(out, cases);
      Drawn drawn;
      for (const course::Case& one : cases)
        if (!fs::exists(out / one.file))
          drawn.faults[one.file] = "not drawn", drawn.crashed_at[one.file] = crashed_at_;
      // What an earlier check drew is still there.
      for (const auto& [file, fault] : drawn.faults) write_file(out / file, "old");
      return drawn;
    };
    std::map<std::string, judge::CaseResult> results;
    for (const judge::LabResult& lab : check(tree_, {lab_}, draws))
      for (const judge::StepResult& step : lab.steps)
        for (const judge::CaseResult& one : step.cases) results[one.name] = one;
    return results;
  }

  test::TemporaryFolder folder_;
  OwnTree tree_{TEXEL_SOURCE, folder_ / "build"};
  course::Lab lab_;
  std::string crashed_at_;
};

/// `see` and the window show a picture when a watch may be checking the lab again.
TEST_F(CheckedPictures, stay_while_the_lab_is_checked_again) {
  const std::map<std::string, judge::CaseResult> first = checked();
  ASSERT_GE(first.size(), 5U);
  std::atomic<int> calls = 0;
  checked([&](const fs::path&, const auto&) {
    ++calls;
    for (const auto& [name, one] : first) EXPECT_TRUE(one.passed() && fs::exists(one.picture)) << name;
  });
  EXPECT_GE(calls, 1);
}

TEST_F(CheckedPictures, are_gone_where_the_next_check_draws_none) {
  const judge::CaseResult first = checked().begin()->second;
  for (const auto& [name, one] :
       checked([&](const fs::path&out, const auto&) { fs::remove(out / first.file); }))
    EXPECT_EQ(fs::exists(one.picture), name != first.name) << name;
  EXPECT_FALSE(fs::exists(first.picture));
  for (const fs::directory_entry& left : fs::directory_iterator(fs::path(first.picture).parent_path()))
    EXPECT_FALSE(left.is_directory()) << left.path();
}

TEST_F(CheckedPictures, earn_all_or_nothing) {
  int wrong = 0;
  for (const auto& [name, one] : checked([](const fs::path&out, const auto&cases) {
         for (const course::Case& of : cases) {
           if (!of.file.ends_with(".png")) continue;
           image::Image8 picture = image::load8(out / of.file, 3);
           for (std::uint8_t& sample : picture.samples) sample ^= 8;  // some limits off, not many
           image::save_png(out / of.file, picture);
         }
       })) {
    EXPECT_EQ(one.score, one.passed() ? 1 : 0) << name;
    if (!one.passed() && judge::score(one.error / one.limit) > 0) ++wrong;
  }
  EXPECT_GE(wrong, 1) << "a score of a part, which a class would give";
}

TEST_F(CheckedPictures, are_missing_by_the_step_in_whose_file_the_program_crashed) {
  const std::string first = checked().begin()->second.file;
  for (const auto& [place, step] : {std::pair("", ""),
                                    {"labs/06_cube_map/scene.hpp:3", ""},
                                    {"labs/06_cube_map/upload_faces.cpp:2", "6.3"},
                                    {"labs/06_cube_map/upload_faces.cpp:14", "6.3"},
                                    {"labs/01_texture_quad/lab.cpp:1", "1.2"},
                                    {"labs/01_texture_quad/lab.cpp:999", "1.5"}}) {
    crashed_at_ = place;
    for (const auto& [name, one] : checked([&](const fs::path&out, const auto&) { fs::remove(out / first); }))
      EXPECT_EQ(one.crashed_in, one.file == first ? step : "") << place << " " << name;
  }
}

TEST_F(CheckedPictures, have_known_mistakes_beside_them_or_an_error_names_the_file) {
  EXPECT_FALSE(known_mistakes(expected_folder(tree_.source, lab_)).empty());
  const std::string message = test::error_of([&] { known_mistakes(folder_ / "nothing"); });
  EXPECT_TRUE(test::has(message, (folder_ / "nothing" / kMistakesFile).string())) << message;
}

}  // namespace
}  // namespace texel::check
