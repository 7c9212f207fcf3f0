// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "sandbox/sandbox.hpp"
#include "store/class_results.hpp"

/// Grading a class: each student's files into the starter, built and run in a sandbox, every picture judged
/// beside the solution's, every result kept as it comes.
namespace texel::grade {

struct GradeOptions {
  std::filesystem::path class_folder;  ///< one entry a student: a folder, .zip or .tar.gz
  std::filesystem::path out;           ///< results.sqlite, pictures and reports
  std::filesystem::path course;        ///< the course's source tree
  std::filesystem::path build;         ///< and where Ninja built it
  std::filesystem::path cache;         ///< starter, references and programs, shared by all runs
  std::vector<int> labs;               ///< numbers; none for all that have steps
  unsigned jobs = 0;                   ///< at a time; 0: one a processor and GiB of memory
  unsigned shard = 1, shards = 1;      ///< of the students, in the order of their ids, every so many-th
  bool resume = false;                 ///< go on where an earlier run was cut off
  Run run = sandbox::run_locked_in;    ///< the students' programs; plainly, where one trusts them
  std::string context = "auto";        ///< the lab programs' --context
  bool judge_alone = true;             ///< what fails, once more; off to measure what it costs
  std::filesystem::path seed_file;     ///< the course's secret; made in `out` when it is empty
};

/// What a run came to.
struct GradeSummary {
  std::size_t students = 0;
  std::size_t cases = 0;      ///< judged by this run
  std::size_t incidents = 0;  ///< students whom the machine kept from being graded in full
  double seconds = 0;         ///< since starter and references were ready
};

/// Grades the class, or this shard of it, into `out`. `say` gets a line at a time, at most one a second while
/// it runs. Without `resume` an earlier run's results become those that the new ones are compared with, and
/// overrides stay. With it, what was judged is not judged again. Throws Error: exit 2 when what is there to
/// be resumed was graded otherwise (seed, course, labs, renderer) and for a shard that cannot be; exit 3 when
/// there is no sandbox, the course does not build, or the results cannot be written.
GradeSummary grade_class(const GradeOptions& options, const std::function<void(const std::string&)>& say);

/// The results in a folder, with each step's place in the sources.
store::ClassResult read_results(const std::filesystem::path& folder, const std::filesystem::path& course);

/// The store in a results' folder.
std::filesystem::path store_file(const std::filesystem::path& folder);

}  // namespace texel::grade
