// SPDX-License-Identifier: MIT
// The second part of grading a class: one student's submission, from the archive to the judged cases.
#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "check/studio.hpp"
#include "class_setup.hpp"
#include "grade/submission.hpp"
#include "judge/mistakes.hpp"

namespace texel::grade {

/// A mark, or an error in the case's unit, of what was judged alone, in steps of a hundredth of it at least:
/// exact numbers could carry text out. The mark is rounded down.
double coarse_score(double score);
double coarse_error(double error);

/// A case that was judged, and the student's picture where it is wrong.
struct JudgedCase {
  judge::CaseResult result;
  std::filesystem::path picture;  ///< a file that is gone after the lab, or none
};

/// What one lab of one student came to.
struct JudgedLab {
  std::vector<store::CompilerLog> logs;
  std::vector<std::string> notes;
};

/// Members of different labs may be called at the same time.
class StudentRun {
 public:
  /// Opens the submission, and makes its shaders' tree in `folder`, which is gone with this. Throws Error
  /// (exit 3) for faults of the machine.
  StudentRun(const ClassSetup& setup, const GradeOptions& options, const Entry& entry,
             std::filesystem::path folder);
  ~StudentRun();
  StudentRun& operator=(StudentRun&&) = delete;

  [[nodiscard]] const Submission& submission() const { return submission_; }
  /// A text that changes when the submission does.
  [[nodiscard]] const std::string& digest() const { return digest_; }
  /// What the student should know of the files that were not taken: files of the course that came back
  /// unchanged are no news; of the others the first hundred.
  [[nodiscard]] std::vector<store::Ignored> worth_telling() const;

  /// Compiles the lab's program, draws the cases and judges them, step by step, what failed also alone;
  /// `keep` gets each as it is judged. Throws Error (exit 3) for faults of the machine.
  JudgedLab judge(const course::Lab& plan, const std::vector<course::Case>& cases,
                  const std::function<void(const JudgedCase&)>& keep) const;

 private:
  using Files = std::map<std::string, std::string>;
  [[nodiscard]] bool is_of_course(const std::string& path) const;
  [[nodiscard]] check::Studio studio(const Program& program, const std::filesystem::path& root) const;
  /// What was drawn of a case in the folder `out`; `refused` is Drawn::refused.
  [[nodiscard]] judge::Failed failed_by(const course::Lab& plan, const Files& refused, const course::Case& of,
                                        const std::filesystem::path& out) const;
  /// What became of the cases of one step, each judged as the student's tree draws it.
  struct StepCases {
    std::string step;
    std::vector<judge::CaseResult> results;
    std::map<std::string, judge::Failed> failed;  ///< by the case's name
    std::map<std::string, double> wrong;          ///< the marks of wrong pictures in the student's tree
  };
  /// Judges the failed cases again, with the solution standing in for all other steps: the better mark
  /// counts. Those that still fail are then the failed ones. Nothing changes but `judged` where it cannot be
  /// done.
  void judge_alone(const course::Lab& plan, StepCases& cases) const;
  /// Where pictures are wrong, but no step that was begun lost a mark: mends one of these steps after the
  /// other. If all of the pictures become right by one of them and by no other, that step loses, and has
  /// their mean mark.
  void blame(const course::Lab& plan, std::vector<StepCases>& steps) const;
  /// All files with steps of the lab as the student has them.
  [[nodiscard]] Files own_files(const course::Lab& lab) const;
  /// Draws cases of one step into the folder `out`/pictures, where the solution stands in for all other
  /// steps: in the step's files what stands between their markers is the solution's, and all other files of
  /// the lab, and those that labs share, are the solution's. So the program of a GLSL step has no C++ of the
  /// student.
  ///
  /// The student's text is compiled and drawn beside the solution's, in the sandbox, and could carry it out.
  /// So nothing but the pictures comes back, for the judge alone: not what programs, compiler and driver say,
  /// and not why a picture is missing. Of cases that were refused (Drawn::refused) their file and place come
  /// back, for judge::explain alone. Nothing comes back where markers in the step's files are gone. Throws
  /// Error (exit 3), which says nothing of the files either, for faults of the machine. All of it counts to
  /// the student's time.
  [[nodiscard]] std::optional<Files> draw_alone(const course::Lab& plan, const std::string& step,
                                                const std::vector<course::Case>& cases,
                                                const std::filesystem::path& out) const;
  [[nodiscard]] Files draw_spliced(const Files& spliced, const course::Lab& plan,
                                   const std::vector<course::Case>& cases,
                                   const std::filesystem::path& out) const;
  [[nodiscard]] judge::CaseResult judged(const course::Lab& plan, const course::Case& of,
                                         const Program& program, const check::Drawn& drawn,
                                         const std::filesystem::path& out) const;
  [[nodiscard]] std::string fault_of(const course::Case& of, const Program& program,
                                     const check::Drawn& drawn) const;

  const ClassSetup& setup_;
  const GradeOptions& options_;
  std::filesystem::path folder_;
  Submission submission_;
  std::string digest_;
  /// What a student's compilers and programs may take together: one without end in each of nine labs takes as
  /// long (60 s), and a sound one a minute in all.
  mutable TimeBudget budget_{900};
  std::set<std::string> begun_;  ///< steps whose code is not the starter's
};

}  // namespace texel::grade
