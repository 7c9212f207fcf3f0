// SPDX-License-Identifier: MIT
// The course's catalogues of mutants and of right solutions written another way.
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "../support/said.hpp"
#include "core/files.hpp"
#include "course/lab_file.hpp"
#include "course/mutant_file.hpp"

namespace texel {
namespace {

using test::has;

/// The mutants, and the right solutions written another way.
std::vector<course::Mutant> both_catalogues() {
  std::vector<course::Mutant> all = course::read_catalogue("tests/mutants");
  const std::vector<course::Mutant> right = course::read_catalogue("tests/equivalents");
  all.insert(all.end(), right.begin(), right.end());
  return all;
}

TEST(MutantCatalogue, applies_to_the_files_as_they_are) {
  for (const course::Mutant& mutant : both_catalogues())
    EXPECT_NO_THROW(course::mutated(mutant, read_file(mutant.file)))
        << mutant.place.file << ":" << mutant.place.line << ": " << mutant.name << " in " << mutant.file;
}

TEST(MutantCatalogue, has_at_least_six_for_each_lab_and_110_in_all) {
  for (const course::Lab& lab : course::read_labs("labs")) {
    const std::filesystem::path file = "tests/mutants/" + lab.folder + ".toml";
    EXPECT_GE(course::read_mutants(file).size(), 6U) << file;
    EXPECT_GE(course::read_mutants("tests/equivalents/" + lab.folder + ".toml").size(), 4U) << lab.folder;
  }
  EXPECT_GE(course::read_catalogue("tests/mutants").size(), 110U);
}

TEST(MutantCatalogue, names_steps_that_the_mutant_s_file_has) {
  for (const course::Mutant& mutant : both_catalogues()) {
    if (mutant.step.empty()) continue;
    EXPECT_TRUE(has(read_file(mutant.file), "@step " + mutant.step + " begin"))
        << mutant.name << ": " << mutant.file << " has no step " << mutant.step;
  }
}

TEST(MutantCatalogue, says_one_sentence_of_each) {
  std::set<std::string> sentences;
  for (const course::Mutant& mutant : course::read_catalogue("tests/mutants")) {
    EXPECT_TRUE(sentences.insert(mutant.says).second) << mutant.name << " says what another says";
    EXPECT_EQ(mutant.says.back(), '.') << mutant.name;
    EXPECT_FALSE(has(mutant.says, "\n")) << mutant.name;
    EXPECT_LE(mutant.says.size(), 160U) << mutant.name;
  }
}

}  // namespace
}  // namespace texel
