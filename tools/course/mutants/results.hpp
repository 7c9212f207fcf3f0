// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "course/mutant_file.hpp"

namespace texel::tools {

enum class Fate { caught, survived, broken };  ///< broken: it does not apply or does not build

/// What became of a mutant.
struct MutantResult {
  course::Mutant mutant;
  Fate fate = Fate::broken;
  std::vector<std::string> by;  ///< the tests that caught it, or what is broken
  double seconds = 0;           ///< to build it and to run tests
  std::string tree;             ///< Tree::state() of the tree it was made in

  /// It changes nothing, and yet tests "caught" it: those fail for any edit.
  [[nodiscard]] bool is_false_alarm() const { return mutant.is_right && fate == Fate::caught; }
};

/// How many of them the tests caught. Those that change nothing are not counted.
struct Score {
  std::size_t caught = 0, explained = 0, broken = 0, all = 0;  ///< explained: survivors with a reason

  /// Of all that are not broken; 0 when there are none.
  [[nodiscard]] double percent() const;
  /// "102 of 112 caught (91 %)"
  [[nodiscard]] std::string text() const;

  void add(const MutantResult& result);
};
Score score(const std::vector<MutantResult>& results);

/// Reads a .json report; of it only the results of these very mutants, none when there is no such file.
/// Throws Error (exit 3) when it is something else.
std::vector<MutantResult> read_report(const std::filesystem::path& file,
                                      const std::vector<course::Mutant>& mutants);

/// Writes a report, JSON or Markdown by the file's ending. `catalogue`: how many mutants there are, made or
/// not. Throws Error (exit 3) when it cannot.
void write_report(const std::filesystem::path& file, const std::vector<MutantResult>& results,
                  std::size_t catalogue);

}  // namespace texel::tools
