// SPDX-License-Identifier: MIT
// What a check leaves where the tree's own pictures lie.
#include "check/check.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../support/picture_files.hpp"
#include "core/error.hpp"
#include "core/files.hpp"

namespace texel::check {
namespace {

namespace fs = std::filesystem;

class CheckedPictures : public testing::Test {
 protected:
  CheckedPictures() : folder_("check") {
    for (course::Lab& lab : course::read_labs(tree_.source / "labs"))
      if (lab.number == 6) lab_ = std::move(lab);
  }

  /// Draws as the solution does, but for one picture; `meanwhile` is called before.
  std::map<std::string, std::string> pictures_of_check(const std::function<void()>& meanwhile = {},
                                                       const std::string& without = "") const {
    const Draws draws = [&](const course::Lab& lab, const std::vector<course::Case>& cases,
                            const fs::path& out) {
      if (meanwhile) meanwhile();
      fs::create_directories(out);
      for (const course::Case& one : cases)
        if (one.name != without) fs::copy_file(expected_folder(tree_.source, lab) / one.file, out / one.file);
      return Drawn{};
    };
    std::map<std::string, std::string> pictures;
    for (const judge::LabResult& lab : check(tree_, {lab_}, draws))
      for (const judge::StepResult& step : lab.steps)
        for (const judge::CaseResult& one : step.cases) pictures[one.name] = one.picture;
    return pictures;
  }

  test::TemporaryFolder folder_;
  OwnTree tree_{TEXEL_SOURCE, folder_ / "build"};
  course::Lab lab_;
};

/// `see` and the window show a picture when a watch may be checking the lab again.
TEST_F(CheckedPictures, stay_while_the_lab_is_checked_again) {
  const std::map<std::string, std::string> first = pictures_of_check();
  ASSERT_GE(first.size(), 5U);
  int calls = 0;
  pictures_of_check([&] {
    ++calls;
    for (const auto& [name, picture] : first) EXPECT_TRUE(fs::exists(picture)) << name;
  });
  EXPECT_GE(calls, 1);
}

TEST_F(CheckedPictures, are_gone_where_the_next_check_draws_none) {
  const auto [name, picture] = *pictures_of_check().begin();
  std::map<std::string, std::string> later = pictures_of_check({}, name);
  EXPECT_EQ(later.at(name), "");
  EXPECT_FALSE(fs::exists(picture));
  later.erase(name);
  for (const auto& [other, there] : later) EXPECT_TRUE(fs::exists(there)) << other;
  for (const fs::directory_entry& left : fs::directory_iterator(fs::path(picture).parent_path()))
    EXPECT_FALSE(left.is_directory()) << left.path();
}

TEST_F(CheckedPictures, have_known_mistakes_beside_them_or_an_error_names_the_file) {
  EXPECT_FALSE(known_mistakes(expected_folder(tree_.source, lab_)).empty());
  try {
    known_mistakes(folder_ / "nothing");
    FAIL() << "a file that is not there was read";
  } catch (const Error& error) {
    EXPECT_EQ(error.exit_code(), Exit::failed);
    EXPECT_NE(std::string(error.what()).find((folder_ / "nothing" / kMistakesFile).string()),
              std::string::npos);
  }
}

}  // namespace
}  // namespace texel::check
