// SPDX-License-Identifier: MIT
// The parts of grading a class: what is the same for all students, one student's submission, and the record.
#pragma once
#include <fmt/format.h>

#include <atomic>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "check/studio.hpp"
#include "core/stopwatch.hpp"
#include "course/lab_file.hpp"
#include "grade/grader.hpp"
#include "grade/submission.hpp"
#include "judge/mistakes.hpp"
#include "references.hpp"
#include "store/store.hpp"
#include "workshop.hpp"

namespace texel::grade {

// --- What is the same for all students ---------------------------------------------------------------------

struct ClassSetup {
  std::vector<course::Lab> labs;     ///< that are asked for and have steps
  std::vector<course::Lab> plans;    ///< theirs
  std::string seed;                  ///< the course's secret
  std::filesystem::path models;      ///< models that nobody has seen
  std::vector<std::string> allowed;  ///< files that a student may change
  std::map<std::string, std::uint64_t>
      given;  ///< the sizes of all files that students get, by path in small letters
  std::map<std::string, std::string> solution;                 ///< the same with all steps solved, by path
  std::map<std::string, std::set<std::string>> files_of_step;  ///< the paths of those with a part of it
  BuiltTree starter;
  std::unique_ptr<References> course;  ///< the solution, and what it draws
  std::unique_ptr<Workshop> workshop;  ///< where students' programs are made
};

/// Reads the course, makes the seed unless there is one, builds the starter, and has the solution and the
/// starter draw all cases, `jobs` labs at a time. Throws Error: exit 2 when no lab that is asked for has
/// steps, exit 3 when something does not build or draw.
ClassSetup prepare(const GradeOptions& options, unsigned jobs);

// --- One student's submission, from the archive to the judged cases ----------------------------------------

/// A mark, or an error in the case's unit, of what was judged alone, in steps of a hundredth of it at least:
/// exact numbers could carry text out. The mark is rounded down.
double coarse_score(double score);
double coarse_error(double error);

/// Gets a case that was judged, and where it is wrong the student's picture: a file that is gone after the
/// lab.
using Keep = std::function<void(const judge::CaseResult& result, const std::filesystem::path& picture)>;

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
  JudgedLab judge(const course::Lab& plan, const std::vector<course::Case>& cases, const Keep& keep) const;

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

// --- What was judged, in the store and the results' folder as it comes -------------------------------------

/// A time as text: "12 s", from 90 seconds on "2 min".
inline std::string duration_text(double seconds) {
  return seconds < 90 ? fmt::format("{:.0f} s", seconds) : fmt::format("{:.0f} min", seconds / 60);
}

/// Its members may be called by several threads.
class Record {
 public:
  /// Opens the store of `options.out`, in which earlier results become those that the new ones are compared
  /// with, unless they are resumed. Keeps the expected pictures of public cases, for the reports. `entries`
  /// are to be graded, and `say` gets progress over their cases. Throws Error: exit 2 when what is resumed
  /// was graded otherwise; exit 3 when nothing can be written.
  Record(const GradeOptions& options, const ClassSetup& setup, const std::vector<Entry>& entries,
         std::function<void(const std::string&)> say);

  /// A student, and the submission where it could be opened. Returns the cases, as "05_normal_map/bumps",
  /// that were judged before.
  std::set<std::string> begin(const Entry& entry, const StudentRun* run);
  void begin_lab(const Entry& entry, const course::Lab& plan);
  void keep(const Entry& entry, judge::CaseResult result, const std::filesystem::path& picture);
  /// After a lab: of its cases, so many were judged before. `incident` is what kept it from being judged, or
  /// "".
  void end_lab(const Entry& entry, const course::Lab& plan, const JudgedLab& judged,
               std::size_t judged_before, const std::string& incident);

  /// Cases judged by this run, and students whom the machine kept from being graded in full.
  [[nodiscard]] std::size_t judged() const { return judged_; }
  [[nodiscard]] std::size_t incidents() const;
  /// How long each student of this run took, the slowest first: a table with the columns id and seconds.
  [[nodiscard]] std::string times_as_csv() const;
  /// Since this was made.
  [[nodiscard]] double seconds() const { return stopwatch_.milliseconds() / 1000; }

 private:
  void progress();  ///< the caller holds the mutex
  void keep_references() const;

  const GradeOptions& options_;
  const ClassSetup& setup_;
  std::size_t cases_ = 0;
  std::function<void(const std::string&)> say_;
  std::unique_ptr<store::Store> store_;
  Stopwatch stopwatch_;
  std::atomic<std::size_t> judged_ = 0, finished_ = 0;
  std::mutex mutex_;
  double said_ = 0;  ///< seconds at which `say_` was called last
  std::map<std::pair<std::string, std::string>, double> running_;  ///< since when, by student and lab
  std::map<std::string, double> took_;                             ///< seconds of all labs, by student
};

}  // namespace texel::grade
