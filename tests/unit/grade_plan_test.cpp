// SPDX-License-Identifier: MIT
#include "grade/hidden_cases.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "../../teach/grade/cache.hpp"
#include "../../teach/grade/class_run.hpp"
#include "../support/picture_files.hpp"
#include "../support/said.hpp"
#include "core/files.hpp"
#include "core/json.hpp"
#include "course/batch.hpp"
#include "mesh/bounds.hpp"
#include "mesh/obj.hpp"
#include "mesh/ply.hpp"
#include "mesh/weld.hpp"

namespace texel::grade {
namespace {

namespace fs = std::filesystem;
using course::Case;
using course::Hidden;
using course::Lab;

Lab lab_of(int number, std::vector<Case> cases) {
  Lab lab;
  lab.number = number, lab.folder = fmt::format("0{}_lab", number), lab.cases = std::move(cases);
  return lab;
}

Case case_of(const std::string& name, std::vector<course::Setting> settings = {},
             std::vector<Hidden> hidden = {}, course::View view = course::View::color) {
  Case graded;
  graded.name = name, graded.step = "1.1", graded.view = view;
  graded.file = name + (view == course::View::mesh ? ".ply" : ".png"), graded.size = {128, 128};
  graded.hidden = !hidden.empty() || name == "unseen";
  graded.settings = std::move(settings), graded.hidden_settings = std::move(hidden);
  return graded;
}

class Plan : public testing::Test {
 protected:
  std::vector<course::Lab> plan_of(const Lab& lab, const std::string& seed) {
    return full_plan({lab}, seed, models_);
  }

  test::TemporaryFolder folder_;
  fs::path models_ = folder_ / "models";
  const Lab lab_ = lab_of(1, {case_of("open", {{"turn", "10"}}),
                              case_of("secret", {{"turn", "10"}, {"tilt", "1"}},
                                      {{"turn", {"-90", "90"}, true}, {"wood", {"a", "b", "c"}}}),
                              case_of("unseen", {{"model", "unseen:polygons"}}, {}, course::View::mesh)});
};

TEST_F(Plan, draws_hidden_values_from_the_seed_within_their_range) {
  const course::Lab plan = plan_of(lab_, "a seed").front();
  ASSERT_EQ(plan.cases.size(), 3U);
  const course::Case& secret = plan.cases[1];
  EXPECT_TRUE(secret.hidden);
  ASSERT_EQ(secret.settings.size(), 3U);
  EXPECT_EQ(secret.settings[1].parameter, "turn");
  EXPECT_LE(std::abs(std::stod(secret.settings[1].value)), 90);
  EXPECT_NE(secret.settings[1].value, "10");
  // The text is the same as a float: it has four digits at most.
  EXPECT_EQ(secret.settings[1].value, fmt::format("{:.4g}", std::stod(secret.settings[1].value)));
  EXPECT_EQ(secret.settings[0].value, "1");
  EXPECT_NE(std::string("abc").find(secret.settings[2].value), std::string::npos);
  EXPECT_EQ(plan_of(lab_, "a seed").front().cases, plan.cases);
  EXPECT_NE(plan_of(lab_, "another").front().cases[1].settings[1].value, secret.settings[1].value);
}

TEST_F(Plan, draws_the_same_for_a_case_whatever_others_there_are) {
  Lab fewer = lab_;
  fewer.cases.erase(fewer.cases.begin());
  EXPECT_EQ(plan_of(fewer, "s").front().cases[0].settings, plan_of(lab_, "s").front().cases[1].settings);
}

TEST_F(Plan, refuses_hidden_values_between_which_there_is_nothing_to_draw) {
  for (const Hidden& hidden :
       {Hidden{"turn", {"3", "3"}, true}, {"turn", {"4", "3"}, true}, {"wood", {"a"}}, {"wood", {}}})
    EXPECT_TRUE(test::has(test::error_of([&] { plan_of(lab_of(1, {case_of("secret", {}, {hidden})}), "s"); }),
                          "must be a range [least, most] of numbers"));
}

TEST_F(Plan, writes_models_that_nobody_has_seen) {
  const course::Case unseen = plan_of(lab_, "s").front().cases[2];
  EXPECT_TRUE(unseen.hidden);
  const fs::path file = unseen.settings[0].value;
  EXPECT_EQ(file, models_ / fmt::format("polygons_{:.16}.obj", fingerprint({read_file(file)})));
  EXPECT_FALSE(mesh::load_obj(file).corners.empty());
  EXPECT_NE(read_file(file), read_file(plan_of(lab_, "t").front().cases[2].settings[0].value));
}

/// So the student's reader of OBJ files does not matter.
TEST_F(Plan, writes_the_mesh_of_such_a_model_where_a_lab_does_not_teach_the_reader) {
  const auto model = [&](const char* value) -> fs::path {
    const Lab lab = lab_of(1, {case_of("unseen", {{"model", value}}, {}, course::View::mesh)});
    return plan_of(lab, "s").front().cases[0].settings[0].value;
  };
  const fs::path obj = model("unseen:shared"), ply = model("unseen:shared.ply");
  EXPECT_EQ(obj.extension(), ".obj");
  EXPECT_EQ(ply.extension(), ".ply");
  mesh::Mesh read = mesh::weld(mesh::load_obj(obj));
  mesh::normalize_to_unit(read);
  EXPECT_TRUE(read_file(ply) == mesh::to_ply(read));
}

TEST_F(Plan, lists_what_the_programs_batch_option_takes) {
  const course::Lab plan = plan_of(lab_, "s").front();
  const auto list = parse_json(course::to_batch(plan.cases));
  ASSERT_EQ(list.size(), 3U);
  EXPECT_EQ(to_text(list[0]), R"({"name":"open.png","view":"color","size":"128x128","set":{"turn":"10"}})");
  EXPECT_EQ(list[2]["name"], "unseen.ply");
  EXPECT_FALSE(list[2].contains("view"));
  EXPECT_EQ(course::parse_batch(course::to_batch({plan.cases[0]})).at(0).settings, plan.cases[0].settings);
  const auto masks = parse_json(course::to_batch(masks_of(plan)));
  ASSERT_EQ(masks.size(), 2U) << "a vertex stream has no mask";
  EXPECT_EQ(masks[1]["view"], "mask");
}

TEST_F(Plan, shows_the_command_that_repeats_a_picture) {
  const course::Lab plan = plan_of(lab_, "s").front();
  EXPECT_EQ(course::command(plan, plan.cases[0]),
            "./run lab 1 --turn 10 --samples 1 --size 128x128 --snapshot open.png");
}

TEST(Coarse, marks_are_rounded_down_and_errors_to_two_digits) {
  for (const auto& [score, coarse] :
       {std::pair(0.0, 0.0), {0.999, 0.99}, {0.123, 0.12}, {0.128, 0.12}, {1.0, 1.0}})
    EXPECT_EQ(coarse_score(score), coarse);
  for (const auto& [error, coarse] : {std::pair(0.01234, 0.012), {0.0168, 0.017}, {179.4, 180.0}, {0.0, 0.0}})
    EXPECT_EQ(coarse_error(error), coarse);
  EXPECT_TRUE(std::isnan(coarse_error(NAN)));
}

}  // namespace
}  // namespace texel::grade
