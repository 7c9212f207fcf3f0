// SPDX-License-Identifier: MIT
// The trusted side: what the course's own solution, starter and mutants draw for the cases.
#pragma once
#include <filesystem>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "check/check.hpp"
#include "check/studio.hpp"
#include "course/lab_file.hpp"
#include "judge/mistakes.hpp"
#include "material/mutant_file.hpp"
#include "workshop.hpp"

namespace texel::grade {

/// The driver that draws there, as the program says it: "llvmpipe (LLVM 15.0.6), Mesa 22.3.6". Throws Error
/// (exit 3) when it does not draw.
std::string renderer_of(const check::Studio& studio);

/// The same by a trusted program. Throws Error (exit 3) when one cannot be drawn.
void draw_all(const check::Studio& studio, const std::vector<course::Case>& cases,
              const std::filesystem::path& out);

/// Pictures of the course's own, drawn once and kept in `cache` under the fingerprint of what they depend on:
/// program, shaders, assets, cases, renderer and processor. May be used by several threads.
class References {
 public:
  /// Of the course's source tree, where Ninja built it; makes the starter unless the cache has it.
  References(const std::filesystem::path& course, const std::filesystem::path& build,
             std::filesystem::path cache, std::string context);

  /// Draws what the lab's cases are judged by, unless it is there. Throws Error (exit 3).
  void prepare(const course::Lab& plan);
  /// The folder of what the starter draws.
  [[nodiscard]] std::filesystem::path starter_folder(const course::Lab& plan) const {
    return folder_of(plan) / "starter";
  }
  [[nodiscard]] check::ExpectedFiles expected(const course::Lab& plan, const course::Case& of) const;

  /// What a mutant of a step draws in the cases of its step: a folder with the pictures that there are.
  /// Throws Error (exit 3).
  std::filesystem::path drawn_by(const course::Lab& plan, const material::Mutant& mutant);
  /// The same for the solution with another text in one of its files; `name` is any. Error (exit 3) also
  /// where it does not compile: the program would be the solution's.
  std::filesystem::path draw_changed(const course::Lab& plan, const std::string& name,
                                     const std::string& step, const std::string& file,
                                     const std::string& text);
  /// One of the pictures in such a folder.
  [[nodiscard]] judge::Failed drawn_in(const course::Lab& plan, const std::filesystem::path& folder,
                                       const course::Case& of) const;
  /// Those of the course's steps.
  [[nodiscard]] const std::vector<material::Mutant>& mutants() const { return mutants_; }
  [[nodiscard]] std::vector<const material::Mutant*> mutants_of(const course::Lab& lab) const;

  /// What a mutant looks like in the cases of its step. Throws Error (exit 3).
  judge::Mistake mistake_of(const course::Lab& plan, const material::Mutant& mutant);

  /// check::known_mistakes, read once. Throws Error (exit 3).
  const std::vector<judge::Mistake>& known_mistakes(const course::Lab& plan);

  /// judge::explain for a student's failed cases of a step. The public ones are compared with known_mistakes,
  /// as `check` does: nothing is drawn. Where no public case failed, the hidden ones are compared with what
  /// the other mutants draw. Throws Error (exit 3).
  std::map<std::string, judge::Seen> explain(const course::Lab& plan, const std::string& step,
                                             const std::map<std::string, judge::Failed>& failed);

  [[nodiscard]] const BuiltTree& starter() const { return starter_; }
  /// "llvmpipe …": what draws.
  [[nodiscard]] const std::string& renderer() const { return renderer_; }
  /// Where a step is written.
  [[nodiscard]] const std::map<std::string, Place>& places() const { return places_; }

 private:
  [[nodiscard]] std::filesystem::path folder_of(const course::Lab& plan) const;
  [[nodiscard]] check::Studio studio(const BuiltTree& tree, const course::Lab& plan) const;
  const std::vector<judge::Mistake>& unseen_mistakes(const course::Lab& plan, const std::string& step);

  BuiltTree starter_, solution_;
  std::filesystem::path cache_;
  std::string context_;
  Workshop workshop_;
  std::vector<material::Mutant> mutants_;
  std::string renderer_;
  std::string surroundings_;  ///< fingerprint of all that pictures depend on besides program and cases
  std::map<std::string, Place> places_;
  std::mutex mutex_;
  std::map<std::string, std::filesystem::path> folders_;
  std::map<std::string, std::mutex> drawing_;                           ///< by mutant and lab
  std::map<std::string, std::vector<judge::Mistake>> known_mistakes_;   ///< by the lab's folder
  std::map<std::string, std::vector<judge::Mistake>> unseen_mistakes_;  ///< by step
};

}  // namespace texel::grade
