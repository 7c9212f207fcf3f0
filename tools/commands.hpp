// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "course/lab_file.hpp"

namespace CLI {
class App;
}

/// The commands of `texel`; each returns the exit code or throws Error.
namespace texel::tools {

/// Adds --context to a command that draws.
void add_context(CLI::App* command, std::string& context);

/// Commands that only some trees have: teach/commands adds those of who makes or teaches the course.
class MoreCommands {
 public:
  virtual ~MoreCommands() = default;
  /// Runs the one that was asked for; nothing when it was none of these.
  [[nodiscard]] virtual std::optional<Exit> run() const = 0;

  /// Adds them to the command line; null where the tree has none.
  static inline std::unique_ptr<MoreCommands> (*make)(CLI::App& app) = nullptr;
};

/// The tree that the programs belong to: TEXEL_ROOT, else beside the program, else the source tree.
std::filesystem::path course_root();
/// The build that this program belongs to.
std::filesystem::path course_build();

/// The labs of the course: from TEXEL_ROOT, else beside the program, else the source tree.
std::vector<course::Lab> course_labs();
/// The labs with these numbers; all for an empty list. Throws Error (usage) for a number without a lab.
std::vector<course::Lab> chosen_labs(const std::vector<int>& numbers);

/// The lab's program in this build.
std::filesystem::path program_of(const course::Lab& lab);
/// `texel list`: the labs at a glance.
Exit list();

/// `texel gallery`: draws the looks of each of these labs that changed, all for an empty list, and writes the
/// page that shows them.
Exit gallery(const std::vector<int>& labs, const std::filesystem::path& out);

struct CheckOptions {
  std::vector<std::string> places;  ///< labs as "9" and steps as "9.4"; none for all labs
  bool json = false;
  bool unless_begun = false;  ///< exit code 0 while no step of these labs is begun
};

/// `texel check`: which steps of the student's tree are right. Differs when one is not.
Exit check(const CheckOptions& options, const std::string& context);

/// `texel progress`: all labs at a glance.
Exit progress(const std::string& context);

/// `texel see STEP`: writes a picture of the step's case that says most: the student's, the expected one, and
/// where they differ. Into out/see/STEP.png if `out` is empty.
Exit see(const std::string& step, std::filesystem::path out, const std::string& context);

/// `texel watch`: checks after every save, until 'q' or an interrupt.
Exit watch(int lab, const std::string& context);

/// `texel hint`: one more hint each time. `where` is a step, a lab's number, or "" for what comes next in the
/// course.
Exit hint(const std::string& where, const std::string& context);

/// `texel predict STEP [CHOICE]`: the handout's question of a step, or what it says to a choice, from 1.
Exit predict(const std::string& step, std::size_t choice);

/// `texel reset STEP`: restores a step's starting code, and saves the student's.
Exit reset(const std::string& step);

}  // namespace texel::tools
