// SPDX-License-Identifier: MIT
// The course's catalogues of mutants, of mistakes, and of right solutions written another way.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "../support/said.hpp"
#include "core/files.hpp"
#include "course/lab_file.hpp"
#include "material/mutant_file.hpp"

namespace texel {
namespace {

using test::has;

/// The mutants, more mistakes of students, and the right solutions written another way.
std::vector<material::Mutant> all_catalogues() {
  std::vector<material::Mutant> all;
  for (const char* folder : {"tests/mutants", "tests/mistakes", "tests/equivalents"})
    for (material::Mutant& one : material::read_catalogue(folder)) all.push_back(std::move(one));
  return all;
}

TEST(MutantCatalogue, applies_to_the_files_as_they_are) {
  for (const material::Mutant& mutant : all_catalogues())
    EXPECT_NO_THROW(material::mutated(mutant, read_file(mutant.file)))
        << mutant.place.file << ":" << mutant.place.line << ": " << mutant.name << " in " << mutant.file;
}

TEST(MutantCatalogue, has_at_least_six_for_each_lab_and_110_in_all) {
  for (const course::Lab& lab : course::read_labs("labs")) {
    const std::filesystem::path file = "tests/mutants/" + lab.folder + ".toml";
    EXPECT_GE(material::read_mutants(file).size(), 6U) << file;
    EXPECT_GE(material::read_mutants("tests/equivalents/" + lab.folder + ".toml").size(), 4U) << lab.folder;
  }
  EXPECT_GE(material::read_catalogue("tests/mutants").size(), 110U);
}

TEST(MutantCatalogue, names_steps_that_the_mutant_s_file_has) {
  for (const material::Mutant& mutant : all_catalogues()) {
    if (mutant.step.empty()) continue;
    EXPECT_TRUE(has(read_file(mutant.file), "@step " + mutant.step + " begin"))
        << mutant.name << ": " << mutant.file << " has no step " << mutant.step;
  }
}

/// `texel marks` holds that these are told apart by their pictures.
TEST(MutantCatalogue, has_names_for_200_mistakes_in_steps) {
  const std::vector<material::Mutant> mistakes = material::read_mistakes(".");
  EXPECT_GE(std::count_if(mistakes.begin(), mistakes.end(),
                          [](const material::Mutant& one) { return one.same.empty(); }),
            200);
}

TEST(MutantCatalogue, has_a_title_for_each_mistake_that_is_a_sentence_of_its_own) {
  std::set<std::pair<std::string, std::string>> titles;
  for (const material::Mutant& mutant : material::read_mistakes(".")) {
    const std::string title = material::title_of(mutant.says);
    SCOPED_TRACE(mutant.name + ": " + title);
    if (mutant.same.empty()) {
      EXPECT_TRUE(titles.insert({mutant.step, title}).second);
    }
    EXPECT_GE(std::count(title.begin(), title.end(), ' '), 2) << "a sentence has some words";
    EXPECT_LE(title.size(), 120U);
    // What is wrong, not what to do.
    for (const char* rule :
         {"Use ", "Take ", "Subtract ", "Multiply ", "Divide ", "Set ", "Do not ", "Invert ", "Draw "})
      EXPECT_FALSE(title.starts_with(rule));
  }
  EXPECT_EQ(material::title_of("Green is inverted: up is +Y."), "Green is inverted");
  EXPECT_EQ(material::title_of("The ray is short. Make it long."), "The ray is short");
  EXPECT_EQ(material::title_of("T and B are swapped."), "T and B are swapped");
}

TEST(MutantCatalogue, says_one_sentence_of_each) {
  std::set<std::pair<std::string, std::string>> sentences;
  for (const material::Mutant& mutant : all_catalogues()) {
    if (mutant.is_right) continue;
    EXPECT_TRUE(sentences.insert({mutant.step, mutant.says}).second)
        << mutant.name << " says what another says";
    EXPECT_EQ(mutant.says.back(), '.') << mutant.name;
    EXPECT_FALSE(has(mutant.says, "\n")) << mutant.name;
    EXPECT_LE(mutant.says.size(), 160U) << mutant.name;
  }
}

}  // namespace
}  // namespace texel
