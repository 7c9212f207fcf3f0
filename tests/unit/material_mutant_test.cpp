// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "../support/picture_files.hpp"
#include "../support/said.hpp"
#include "core/error.hpp"
#include "core/files.hpp"
#include "material/mutant_file.hpp"

namespace texel::material {
namespace {

using test::replaced;

/// A catalogue of two files.
class MutantFile : public testing::Test {
 protected:
  /// What reading `text` as a file says from the line on, or "".
  std::string refusal(const std::string& text) {
    write_file(first_, text);
    return message([&] { read_catalogue(first_.parent_path()); });
  }

  template <class Read>
  static std::string message(Read read) {
    const std::string text = test::error_of(read);
    const std::size_t name = text.find(".toml:");
    return name == std::string::npos ? text : text.substr(name + 6);
  }

  test::TemporaryFolder folder_;
  std::filesystem::path first_ = folder_ / "01_first.toml", second_ = folder_ / "second.toml";
};

const std::string kMutant = R"([[mutant]]
name = "no-factor"
file = "shaders/lib/light.glsl"
what = "2.0 * x"
by = "x"
says = "The factor is missing."
)";

TEST_F(MutantFile, is_read_in_full) {
  write_file(first_, kMutant + R"(
[[mutant]]
name = "gone"
file = "labs/05_normal_map/lab.cpp"
what = '''
  first("a");
  second();
'''
by = ""
step = "5.1"
says = "Both are needed."
survives = "Neither does anything."
)");
  const std::vector<Mutant> mutants = read_catalogue(first_.parent_path());
  ASSERT_EQ(mutants.size(), 2U);
  const auto& [is_right, name, file, what, by, step, says, same, survives, place] = mutants[1];
  EXPECT_EQ(fmt::format("{}|{}|{}|{}|{}|{}|{}", name, file, what, by, step, says, survives),
            "gone|labs/05_normal_map/lab.cpp|  first(\"a\");\n  second();\n||5.1|Both are needed.|Neither "
            "does anything.");
  EXPECT_EQ(place.file, first_.string());
  EXPECT_EQ(mutants[0].name + mutants[0].step + mutants[0].survives, "no-factor");
  EXPECT_EQ(mutants[0].place.line, 1);
}

TEST_F(MutantFile, is_refused_with_place_and_remedy) {
  const auto with = [](const std::string& key, const std::string& value) {
    std::string text = kMutant;
    const std::size_t at = text.find(key + " = ");
    return text.replace(at, text.find('\n', at) - at, key + " = \"" + value + "\"");
  };
  std::vector<std::pair<std::string, std::string>> rows = {
      {"[[mutant]]\nname = \"a\"\n", "1:1: 'file' is missing or empty"},
      {with("what", ""), "1:1: 'what' is missing or empty"},
      {replaced(kMutant, "by = \"x\"\n", ""), "1:1: 'by' is missing; write by = \"\" to remove the text"},
      {kMutant + "stop = \"5.1\"\n", "7:8: there is no key 'stop'; did you mean 'step'?"},
      {kMutant + "[[mutants]]\n", "7:1: there is no key 'mutants'; did you mean 'mutant'?"},
      {kMutant + "step = 5.1\n", "7:8: 'step' is a text in quotes"},
      {"mutant = 1\n", "1:10: mutants are written as [[mutant]] tables"},
      {"mutant = [1]\n", "1:11: mutants are written as [[mutant]] tables"},
      {with("name", "No factor"),
       "2:8: 'No factor' is not a valid mutant name; use lower-case letters, digits and '-'"},
      {with("by", "2.0 * x"), "5:6: the replacement changes nothing"}};
  for (const std::string file : {"/etc/passwd", "../other", "shaders/../../other"})
    rows.emplace_back(
        with("file", file),
        "3:8: '" + file + "' is not a path below the project's root; write it as shaders/lib/light.glsl");
  for (const std::string step : {"5", "5.", ".1", "5.1.2", "5.a"})
    rows.emplace_back(kMutant + "step = \"" + step + "\"\n",
                      "7:8: '" + step + "' is not a step; write it as 5.1");
  for (const auto& [text, expected] : rows) EXPECT_EQ(refusal(text), expected) << text;
}

TEST_F(MutantFile, refuses_a_name_that_is_taken_in_its_file_or_another) {
  EXPECT_EQ(refusal(kMutant + kMutant),
            "7:1: two mutants are called 'no-factor'; the other one is at " + first_.string() + ":1");
  write_file(first_, kMutant);
  write_file(second_, "\n" + kMutant);
  EXPECT_EQ(message([&] { read_catalogue(first_.parent_path()); }),
            "2:1: two mutants are called 'no-factor'; the other one is at " + first_.string() + ":1");
}

TEST_F(MutantFile, has_equivalents_too) {
  const std::string equivalent = replaced(kMutant, "mutant", "equivalent");
  write_file(first_, equivalent + replaced(kMutant, "no-factor", "no-sum"));
  const std::vector<Mutant> both = read_catalogue(first_.parent_path());
  ASSERT_EQ(both.size(), 2U);
  EXPECT_EQ(both[0].name, "no-sum");
  EXPECT_FALSE(both[0].is_right);
  EXPECT_EQ(both[1].name, "no-factor");
  EXPECT_TRUE(both[1].is_right);
  EXPECT_EQ(both[1].place.line, 1);
  EXPECT_EQ(mutated(both[1], "y = 2.0 * x;"), "y = x;");

  write_file(first_, equivalent);
  EXPECT_EQ(read_catalogue(first_.parent_path()).size(), 1U) << "a catalogue of equivalents alone is one";
  EXPECT_EQ(refusal(equivalent + "survives = \"No.\"\n"),
            "7:12: there is no key 'survives'; the keys are name, file, what, by, step, says");
  for (const std::string& other : {equivalent, kMutant})
    EXPECT_EQ(refusal(other + equivalent),
              "7:1: two equivalents are called 'no-factor'; the other one is at " + first_.string() + ":1");
  EXPECT_EQ(refusal(replaced(equivalent, "no-f", "No f")),
            "2:8: 'No factor' is not a valid equivalent name; use lower-case letters, digits and '-'");
}

TEST_F(MutantFile, refuses_a_catalogue_without_mutants) {
  for (const auto& folder : {first_.parent_path(), folder_ / "none"})
    EXPECT_TRUE(test::has(message([&] { read_catalogue(folder); }), "holds no mutants"));
}

TEST_F(MutantFile, changes_the_one_place_that_it_names) {
  write_file(first_, kMutant);
  const Mutant mutant = read_catalogue(first_.parent_path()).at(0);
  EXPECT_EQ(mutated(mutant, "y = 2.0 * x;"), "y = x;");
  EXPECT_EQ(
      message([&] { mutated(mutant, "y = 2 * x;"); }),
      "1:1: 'no-factor' does not apply: its text is not in shaders/lib/light.glsl; copy the current text "
      "from the file");
  EXPECT_EQ(message([&] { mutated(mutant, "2.0 * x + 2.0 * x"); }),
            "1:1: 'no-factor' does not apply: its text occurs more than once in shaders/lib/light.glsl; add "
            "more of the text around it");
}

}  // namespace
}  // namespace texel::material
