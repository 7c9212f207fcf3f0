// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace texel::tools {

/// One entry of ctest.
struct Test {
  int number = 0;       ///< ctest's, from 1
  std::string name;     ///< as ctest prints it
  std::string key;      ///< its program and its name, in lower case
  std::string target;   ///< what must be built for it: its program, or "" for everything
  double seconds = 0;   ///< in the unchanged tree
  bool is_used = true;  ///< a test of behaviour that passes in the unchanged tree
};

/// When a test runs: those that are likely to notice a change first, and of those that are as likely the
/// quick ones. Tests of one rank and pace run together.
struct Order {
  int rank = 0;
  int pace = 0;  ///< 0: below kQuickSeconds, 1: up to twice as long, 2: up to four times …

  auto operator<=>(const Order&) const = default;
};
constexpr double kQuickSeconds = 1.5;

/// When `test` runs after a change of `file` (relative to `tree`): first the tests whose program or name has
/// the file's lab ("lab05") or subject ("unit_mesh weld"), then those of its folder ("unit_mesh"), then the
/// others, at the end those of the assets, the compiler and the window. A file of shaders/lib belongs to the
/// labs whose shaders include it. None for a test in which the file has no part.
std::optional<Order> order_of(const Test& test, const std::filesystem::path& tree, const std::string& file);

/// What the tests say of a changed tree.
struct Verdict {
  bool builds = true;                  ///< C++ and GLSL
  std::vector<std::string> caught_by;  ///< the tests that failed, of the first that ran together; or none
};

/// The tests of a tree: a CMake project with a preset `release`, built in build/release.
class Suite {
 public:
  /// `logs`: a folder for what the build and the tests print.
  Suite(std::filesystem::path tree, std::filesystem::path logs);

  /// Configures and builds. Throws Error (exit 3) when that fails.
  void prepare() const;

  /// Runs every test of behaviour in the unchanged tree and takes its time; from `logs` when that was done
  /// already in a tree of this state. Tests that fail are not used, nor are those of ctest's labels "tree"
  /// (they read sources, build or documents, and fail for any change) and "class" (minutes). Throws Error
  /// (exit 3) when no test passes.
  void measure(const std::string& state);

  [[nodiscard]] const std::vector<Test>& tests() const { return tests_; }

  /// Runs the tests that can notice a change of these files, those together that have one Order, until some
  /// fail, and builds first what they need. `name`: that of the log.
  [[nodiscard]] Verdict judge(const std::vector<std::string>& files, const std::string& name) const;

 private:
  /// Builds these targets, or all when there are none; false when that fails.
  [[nodiscard]] bool build(const std::set<std::string>& targets, const std::filesystem::path& log) const;
  /// Runs the tests of these numbers; JUnit's XML goes into `xml`.
  void run(const std::vector<int>& numbers, const std::filesystem::path& xml,
           const std::filesystem::path& log) const;
  void list();

  std::filesystem::path tree_, logs_;
  std::vector<Test> tests_;
};

}  // namespace texel::tools
