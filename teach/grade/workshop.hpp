// SPDX-License-Identifier: MIT
// Programs out of a built tree with some of its files changed: without CMake, which a student could talk into
// anything, and each file apart, so that what was compiled once is never compiled again.
#pragma once
#include <filesystem>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "core/process.hpp"
#include "store/class_results.hpp"

namespace texel::grade {

/// A source tree and where CMake built it, with Ninja.
struct BuiltTree {
  std::filesystem::path source, build;
  std::string fingerprint;  ///< of all that goes into its programs
};

/// A program with some changed files in it.
struct Program {
  std::filesystem::path file;  ///< alone in its folder
  /// Changed files that did not compile or link: the tree's are in place.
  std::vector<store::CompilerLog> refused;
};

/// Makes programs and keeps them in `cache`, under the fingerprint of what they were made of. Members may be
/// called by several threads and processes at a time.
class Workshop {
 public:
  /// `how` compiles and links: in a sandbox that sees the tree, for what nobody trusts. Throws Error (exit 3)
  /// when the build folder is none of Ninja's.
  Workshop(BuiltTree tree, std::filesystem::path cache, Run how);

  /// The lab's program with the changed C++ files, by path in the tree; others are passed over. A file that
  /// does not compile or link is left out alone.
  /// Each file is compiled once for all labs, also one at which the compiler had to be stopped. The compiler
  /// may use up `budget`. Throws Error (exit 3) for faults of the machine.
  Program make(const std::string& program, const std::map<std::string, std::string>& files,
               TimeBudget* budget = nullptr);

  [[nodiscard]] const BuiltTree& tree() const { return tree_; }

 private:
  using Words = std::vector<std::string>;
  /// How a program is compiled and linked.
  struct Recipe {
    std::map<std::string, Words> compile;  ///< by the file's path in the tree
    Words link;
  };
  struct Compilation {
    std::mutex mutex;     ///< held by who compiles
    std::string stopped;  ///< what is said where the compiler had to be stopped
  };
  struct Object {
    std::filesystem::path file;  ///< none when it did not compile
    std::string key, log;
  };

  const Recipe& recipe(const std::string& program);
  Object compile(const Recipe& recipe, const std::string& path, const std::string& text, TimeBudget* budget);
  std::string link(const Recipe& recipe, const std::string& program,
                   const std::map<std::string, Object>& objects, const std::filesystem::path& to);
  Outcome run(const Words& command, const std::vector<std::filesystem::path>& readable,
              const std::filesystem::path& out, double wall_seconds) const;
  std::filesystem::path new_folder(const char* what);

  BuiltTree tree_;
  std::filesystem::path cache_;
  Run run_;
  std::mutex mutex_;
  std::map<std::string, Recipe> recipes_;
  std::map<std::string, Compilation> compilations_;  ///< by an object's key
  int count_ = 0;
};

/// The tree that students begin with, written and built into `cache` unless it is there. Throws Error (exit
/// 3) when it does not build.
BuiltTree starter_tree(const std::filesystem::path& course, const std::filesystem::path& cache);

/// The course's own tree, from which that starter was made, as it was built.
BuiltTree solution_tree(const std::filesystem::path& course, const std::filesystem::path& build,
                        const BuiltTree& starter);

}  // namespace texel::grade
