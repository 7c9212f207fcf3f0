// SPDX-License-Identifier: MIT
#include "check/studio.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <csignal>

#include "core/crash.hpp"
#include "core/files.hpp"
#include "core/plain_text.hpp"
#include "course/batch.hpp"

extern char** environ;

namespace texel::check {
namespace {

namespace fs = std::filesystem;
using course::Case;

/// Measured: a lab's 20 cases take 2 s of a processor, and 10 s where eight others want it too.
constexpr double kProcessorSeconds = 30, kWallSeconds = 120;
/// How often a program is started: again after it died, but for those that use up their time only once.
constexpr int kMostStarts = 4;

double seconds_left(const Studio& studio) {
  return studio.budget == nullptr ? kWallSeconds : studio.budget->load();
}

/// Starts the program with a work folder and an output (its folder `out`) that are empty: what an earlier
/// start left there can not be in its way.
Outcome run(const Studio& studio, const std::vector<Case>& cases, const fs::path& work) {
  const fs::path folder = work / "cases", out = work / "out";
  fs::remove_all(work);
  fs::create_directories(folder);
  fs::create_directories(out);
  write_file(folder / "cases.json", course::to_batch(cases));
  Confines confines;
  confines.read_only = {studio.program.parent_path(), studio.root, folder};
  confines.read_only.insert(confines.read_only.end(), studio.readable.begin(), studio.readable.end());
  confines.writable = {out};
  // So that a case can name a file as one does in the project's root: assets/models/….
  confines.working_folder = studio.root;
  confines.limits.cpu_seconds = kProcessorSeconds;
  confines.limits.wall_seconds = std::clamp(seconds_left(studio), 1.0, kWallSeconds);
  confines.limits.files = 1024;
  confines.environment = {
      {"TEXEL_ROOT", studio.root.string()},
      // All processors are busy with other students. And so each picture is written before
      // the next is begun: the first that is missing is what a dying program was at.
      {"LP_NUM_THREADS", "0"},
      {"TEXEL_THREADS", "1"}};
  if (studio.shader_cache.empty())
    confines.environment.emplace_back("MESA_SHADER_CACHE_DISABLE", "true");
  else
    confines.environment.emplace_back("MESA_SHADER_CACHE_DIR", studio.shader_cache.string());
  for (const auto& variable : driver_variables())
    if (studio.run == run_plainly || variable.first != "LD_PRELOAD") confines.environment.push_back(variable);
  // Where several samples of a pixel lie, and whether there are several, is the driver's choice.
  return studio.run(confines, {studio.program.string(), "--context", studio.context, "--samples", "1",
                               "--batch", (folder / "cases.json").string(), "--out", out.string()});
}

/// How a program ended that did not draw what it should; `at` is the line where it was, or "here".
std::string end_of(const Outcome& outcome, const std::string& at = "here") {
  if (outcome.limit != Limit::none)
    return fmt::format("The program was stopped {}: it used too much {}", at, name_of(outcome.limit));
  if (outcome.signal == SIGSEGV)
    return fmt::format("The program crashed {}: it read or wrote invalid memory (SIGSEGV)", at);
  if (outcome.signal == SIGABRT) return fmt::format("The program aborted {} (SIGABRT)", at);
  if (outcome.signal == SIGFPE)
    return fmt::format("The program crashed {}: it divided an integer by zero (SIGFPE)", at);
  if (outcome.signal != 0) return fmt::format("The program was stopped {} by signal {}", at, outcome.signal);
  return fmt::format("The program ended with exit code {} and drew nothing", outcome.exit_code);
}

/// Takes the picture or vertex stream of a case out of a program's output, and nothing else that may be
/// there; whether there is one.
bool take(const Case& of, const fs::path& from, const fs::path& to) {
  if (!fs::is_regular_file(fs::symlink_status(from / of.file))) return false;
  fs::create_directories(to);
  fs::rename(from / of.file, to / of.file);
  return true;
}

/// What the program itself says of its cases, by file. Nobody may trust what it wrote.
std::map<std::string, course::Drawing> drawings_in(const fs::path& out) {
  constexpr std::uintmax_t most = 1U << 20U;
  std::map<std::string, course::Drawing> all;
  const fs::path file = out / course::kDrawingsFile;
  if (!fs::is_regular_file(fs::symlink_status(file)) || fs::file_size(file) > most) return all;
  for (const course::Drawing& drawing : course::parse_drawings(read_file(file))) all[drawing.file] = drawing;
  return all;
}

}  // namespace

std::vector<std::pair<std::string, std::string>> driver_variables() {
  constexpr std::array kSteer = {"GALLIUM_",    "GALLIVM_", "LIBGL_", "LP_NATIVE",
                                 "MESA_LOADER", "VK_",      "__EGL_", "LD_PRELOAD"};
  // Of several makers' drivers EGL takes the first that fits; Mesa's is the one that draws in software.
  constexpr const char* kMesa = "/usr/share/glvnd/egl_vendor.d/50_mesa.json";
  std::map<std::string, std::string> all = {{"LIBGL_ALWAYS_SOFTWARE", "1"}};
  if (fs::exists(kMesa)) all["__EGL_VENDOR_LIBRARY_FILENAMES"] = kMesa;
  for (char** variable = environ; *variable != nullptr; ++variable) {
    const std::string text = *variable;
    if (std::any_of(kSteer.begin(), kSteer.end(), [&](const char* head) { return text.starts_with(head); }))
      all[text.substr(0, text.find('='))] = text.substr(text.find('=') + 1);
  }
  return {all.begin(), all.end()};
}

Drawn draw(const Studio& studio, const std::vector<Case>& cases, const fs::path& out) {
  Drawn drawn;
  std::vector<Case> left = cases;
  if (cases.empty()) return drawn;
  const fs::path work = fmt::format("{}.{}.work", out.string(), cases.front().name);  // others may draw there
  int timeouts = 0;
  std::string place;  // where it died the last time
  for (int start = 0; start < kMostStarts && timeouts < studio.timeouts && !left.empty(); ++start) {
    if (seconds_left(studio) <= 0) break;
    const Outcome outcome = run(studio, left, work);
    if (studio.budget != nullptr) *studio.budget -= outcome.wall_seconds;
    const std::map<std::string, course::Drawing> drawings = drawings_in(work / "out");
    std::erase_if(left, [&](const Case& one) {
      const auto said = drawings.find(one.file);
      const bool is_said = said != drawings.end();
      if (take(one, work / "out", out)) {
        if (is_said) drawn.renderer = plain_text(said->second.drawn_by);
        return true;
      }
      if (!is_said || said->second.is_drawn) return false;
      drawn.faults[one.file] = plain_lines(said->second.message);
      drawn.refused[one.file] = plain_text(said->second.place);
      return true;
    });
    if (left.empty()) break;
    if (outcome.signal == 0 && outcome.limit == Limit::none) {  // it did not die
      const std::string text = plain_lines(outcome.errors.substr(0, 2000));
      for (const Case& one : left)
        drawn.faults[one.file] = end_of(outcome) + (text.empty() ? "" : ": " + text);
      left.clear();
      break;
    }
    if (outcome.limit == Limit::wall || outcome.limit == Limit::cpu) ++timeouts;
    // A student's own machine runs its program plainly. Of any other, what it writes is nothing to rely on.
    if (studio.run == run_plainly) place = crash_place(outcome.errors, studio.program, studio.root / "labs");
    drawn.crashed_at[left.front().file] = place;
    drawn.faults[left.front().file] = end_of(outcome, place.empty() ? "here" : "at " + place);
    drawn.notes.push_back(fmt::format("{}: {}", left.front().name, end_of(outcome)));
    left.erase(left.begin());
  }
  std::string why = "Not drawn: the program crashed or was stopped before this case";
  if (!place.empty()) why += ", the last time at " + place;
  if (seconds_left(studio) <= 0) why = "Not drawn: the submission used up its time";
  for (const Case& one : left) drawn.faults[one.file] = why, drawn.crashed_at[one.file] = place;
  fs::remove_all(work);
  return drawn;
}

}  // namespace texel::check
