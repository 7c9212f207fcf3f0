// SPDX-License-Identifier: MIT
// The third part of grading a class: what was judged, in the store and the results' folder as it comes.
#pragma once
#include <fmt/format.h>

#include <atomic>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "class_setup.hpp"
#include "core/stopwatch.hpp"
#include "store/store.hpp"
#include "student_run.hpp"

namespace texel::grade {

/// A time as text: "12 s", from 90 seconds on "2 min".
inline std::string duration_text(double seconds) {
  return seconds < 90 ? fmt::format("{:.0f} s", seconds) : fmt::format("{:.0f} min", seconds / 60);
}

/// Its members may be called by several threads.
class Record {
 public:
  /// Opens the store of `options.out`, in which earlier results become those that the new ones are compared
  /// with, unless they are resumed. Keeps the expected pictures of public cases, for the reports. `say` gets
  /// progress over so many cases. Throws Error: exit 2 when what is resumed was graded otherwise; exit 3 when
  /// nothing can be written.
  Record(const GradeOptions& options, const ClassSetup& setup, std::size_t cases,
         std::function<void(const std::string&)> say);

  /// The students who are to be graded.
  void expect(const std::vector<Entry>& entries);
  /// A student, and the submission where it could be opened. Returns the cases, as "05_normal_map/bumps",
  /// that were judged before.
  std::set<std::string> begin(const Entry& entry, const StudentRun* run);
  void begin_lab(const Entry& entry, const course::Lab& plan);
  void keep(const Entry& entry, const JudgedCase& judged);
  /// After a lab: of its cases, so many were judged before. `incident` is what kept it from being judged, or
  /// "".
  void end_lab(const Entry& entry, const course::Lab& plan, const JudgedLab& judged,
               std::size_t judged_before, const std::string& incident);

  /// Cases judged by this run, and students whom the machine kept from being graded in full.
  [[nodiscard]] std::size_t judged() const { return judged_; }
  [[nodiscard]] std::size_t incidents() const;
  /// Since this was made.
  [[nodiscard]] double seconds() const { return stopwatch_.milliseconds() / 1000; }

 private:
  void progress();  ///< the caller holds the mutex
  void keep_references() const;

  const GradeOptions& options_;
  const ClassSetup& setup_;
  std::size_t cases_;
  std::function<void(const std::string&)> say_;
  std::unique_ptr<store::Store> store_;
  Stopwatch stopwatch_;
  std::atomic<std::size_t> judged_ = 0, finished_ = 0;
  std::mutex mutex_;
  double said_ = 0;  ///< seconds at which `say_` was called last
  std::map<std::pair<std::string, std::string>, double> running_;  ///< since when, by student and lab
};

}  // namespace texel::grade
