// SPDX-License-Identifier: MIT
// How a mistake is known again: by samples of its pictures, or by what the program says in place of one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/error.hpp"
#include "core/files.hpp"
#include "image/save.hpp"
#include "judge/mistakes.hpp"
#include "material/mistake_samples.hpp"

namespace texel::judge {
namespace {

/// Three cases of step 1.1, and what the solution, two mistakes and a student draw for them.
class Mistakes : public testing::Test {
 protected:
  Mistakes() {
    for (const char* name : {"a", "b", "c"}) {
      course::Case one;
      one.name = name, one.step = "1.1", one.view = course::View::texcoord;
      one.size = {16, 16}, one.limit = 1e-3;
      plan_.cases.push_back(one);
    }
  }

  /// A ramp, of which `wrong` rows from the bottom are off by `by`, in each second column by `odd` if given.
  [[nodiscard]] std::string picture(const std::string& name, int wrong, float by,
                                    std::optional<float> odd = {}) const {
    image::ImageF image(16, 16, 3);
    for (int y = 0; y < 16; ++y)
      for (int x = 0; x < 16; ++x) {
        const float here = x % 2 == 1 ? odd.value_or(by) : by;
        image.at(x, y, 0) = static_cast<float>(x) / 16 + (y < wrong ? here : 0), image.at(x, y, 1) = 0.5F;
      }
    image::save_pfm(folder_.path() / (name + ".pfm"), image);
    return read_file(folder_.path() / (name + ".pfm"));
  }

  [[nodiscard]] Samples samples(int wrong, float by) const {
    return material::sampled(plan_.cases[0], picture("right", 0, 0), picture("wrong", wrong, by));
  }

  [[nodiscard]] std::string known(const std::vector<Mistake>& mistakes,
                                  const std::map<std::string, Failed>& failed) const {
    const std::map<std::string, Seen> seen = explain(mistakes, plan_, "1.1", failed);
    return seen.empty() ? "" : seen.begin()->second.mistake;
  }

  ScratchFolder folder_;
  course::Lab plan_;
};

TEST_F(Mistakes, are_known_by_their_pictures_and_not_by_others) {
  const std::vector<Mistake> mistakes = {{"off by a half", "1.1", "", {{"a", samples(8, 0.5F)}}},
                                         {"off by a third", "1.1", "", {{"a", samples(8, 0.333F)}}},
                                         {"of another step", "1.2", "", {{"a", samples(8, 0.25F)}}}};
  for (const auto& [wrong, by, name] : {std::tuple{8, 0.5F, "off by a half"},
                                        {8, 0.333F, "off by a third"},
                                        {8, 0.25F, ""},
                                        {16, 0.5F, ""}})  // also wrong where the mistake is right
    EXPECT_EQ(known(mistakes, {{"a", {picture("s", wrong, by), ""}}}), name) << wrong << " by " << by;
  EXPECT_EQ(known(mistakes, {}), "");
  // Told apart by all columns: each twelfth of 240 pixels would be in the columns 2, 6, 10 and 14 alone.
  const std::vector<Mistake> everywhere = {{"everywhere", "1.1", "", {{"a", samples(15, 0.5F)}}}};
  EXPECT_EQ(known(everywhere, {{"a", {picture("s", 15, 0.5F), ""}}}), "everywhere");
  EXPECT_EQ(known(everywhere, {{"a", {picture("s", 15, 0.5F, 0.25F), ""}}}), "");
}

TEST_F(Mistakes, that_would_have_spoilt_more_than_what_failed_are_not_meant) {
  const Samples half = samples(8, 0.5F);
  const std::vector<Mistake> mistakes = {{"everywhere", "1.1", "", {{"a", half}, {"b", half}, {"c", half}}},
                                         {"in two", "1.1", "", {{"a", half}, {"b", half}}}};
  const Failed failed{picture("s", 8, 0.5F), ""};
  EXPECT_EQ(known(mistakes, {{"a", failed}, {"b", failed}}), "in two");
  EXPECT_EQ(known(mistakes, {{"a", failed}, {"b", failed}, {"c", failed}}), "everywhere");
  EXPECT_EQ(known(mistakes, {{"a", failed}}), "") << "a wrong name is worse than none";
}

TEST_F(Mistakes, that_are_two_in_one_step_have_a_sentence_each) {
  const std::vector<Mistake> mistakes = {{"in a", "1.1", "a", {{"a", samples(16, 0.5F)}}},
                                         {"in b", "1.1", "b", {{"b", samples(16, 0.25F)}}}};
  plan_.cases[1].view = course::View::depth;  // so that the values of b differ in another way than those of a
  image::Image8 mask(16, 16, 1);
  std::ranges::fill(mask.samples, std::uint8_t{255});
  const auto failed = [&](float by) {
    return Failed{picture("s", 16, by), "", picture("right", 0, 0), image::encode_png(mask, "mask")};
  };
  const auto seen = explain(mistakes, plan_, "1.1", {{"a", failed(0.5F)}, {"b", failed(0.25F)}});
  EXPECT_EQ(seen.at("a").mistake, "in a") << "a cause comes before how values differ in some pictures alone";
  EXPECT_EQ(seen.at("b").says, "In the case b: b");
  const auto both = explain({}, plan_, "1.1", {{"a", failed(0.5F)}, {"b", failed(0.25F)}});
  const auto alike = explain({}, plan_, "1.1", {{"a", failed(0.5F)}, {"c", failed(0.5F)}});
  EXPECT_TRUE(both.at("a").says.starts_with("In the case a: The"));
  EXPECT_TRUE(alike.at("a").says.starts_with("The expected texture coordinate"));
}

TEST_F(Mistakes, that_draw_nothing_are_known_by_what_the_program_says) {
  Samples refused;
  refused.refused = "cube.obj:9";
  const std::vector<Mistake> mistakes = {{"from 0", "1.1", "", {{"a", refused}}},
                                         {"off by a half", "1.1", "", {{"a", samples(8, 0.5F)}}}};
  EXPECT_EQ(known(mistakes, {{"a", {{}, refused.refused}}}), "from 0");
  EXPECT_EQ(known(mistakes, {{"a", {{}, "cube.obj:8"}}}), "");
  EXPECT_EQ(known(mistakes, {{"a", {picture("s", 8, 0.5F), ""}}}), "off by a half");
}

TEST_F(Mistakes, are_the_same_when_they_were_written_and_read) {
  Samples refused;
  refused.refused = "\"x\".obj:1";
  const std::vector<Mistake> mistakes = {
      {"off", "1.1", "It is off.", {{"a", samples(8, std::nanf(""))}, {"b", refused}}},
      {"half", "1.2", "It is half.", {{"c", samples(4, 0.5F)}}}};
  const std::vector<Mistake> read = parse_mistakes(material::to_json(mistakes), "mistakes.json");
  ASSERT_EQ(material::to_json(read), material::to_json(mistakes));
  EXPECT_EQ(read[0].says, "It is off.");
  EXPECT_EQ(read[0].cases.at("b").refused, refused.refused);
  EXPECT_EQ(read[0].cases.at("a").count, 256U);
  EXPECT_TRUE(std::ranges::any_of(read[0].cases.at("a").samples,
                                  [](const auto& sample) { return std::isnan(sample.values.at(0)); }));
  for (const char* text : {"", "{}x", R"([{"name": 1}])", R"([{"name": "n", "step": "1.1", "says": ""}])"})
    EXPECT_THROW(parse_mistakes(text, "mistakes.json"), Error) << text;
}

}  // namespace
}  // namespace texel::judge
