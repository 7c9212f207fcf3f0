// SPDX-License-Identifier: MIT
// What people wait for in this tree and in an earlier commit's: a student for the first ./run, and from a
// save to the verdict; who changes the course for its tests.
#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "core/files.hpp"
#include "core/process.hpp"
#include "core/stopwatch.hpp"
#include "measures.hpp"

namespace texel::bench {
namespace {

namespace fs = std::filesystem;

/// Milliseconds of `./run …` in a tree. It ends with at most this exit code. `environment` is as env takes
/// it.
double run_in(const fs::path& tree, const std::string& arguments, int most_code,
              const std::string& environment = {}) {
  const Stopwatch stopwatch;
  const Ran ran = run_program(
      {"sh", "-c",
       fmt::format("cd '{}' && env TEXEL_NO_APT=1 {} ./run {}", tree.string(), environment, arguments)},
      true);
  if (ran.exit_code > most_code)
    throw Error::failed(fmt::format("./run {} failed: {}", arguments, ran.output), {tree.string()});
  return stopwatch.milliseconds();
}

/// A line that was never compiled, so that the compiler's cache does not have it, at the end of a file.
void edit(const fs::path& file, int number) {
  const std::string text = read_file(file), mark = "\n// edited: ";
  const std::string name = fmt::format("edited_{}", number);
  const std::string line = file.extension() == ".cpp"
                               ? fmt::format("namespace {{ [[maybe_unused]] constexpr int {} = 0; }}", name)
                               : fmt::format("const float {} = 0.0;", name);
  write_file(file, text.substr(0, text.find(mark)) + mark + "\n" + line + "\n");
}

std::string commit_of(const fs::path& tree) {
  std::string commit = run_program({"git", "-C", tree.string(), "rev-parse", "--short", "HEAD"}).output;
  commit.erase(commit.find_last_not_of('\n') + 1);
  return commit;
}

/// A course's tree as its last commit has it.
struct Tested {
  fs::path tree;

  Tested(const fs::path& course, fs::path to) : tree(std::move(to)) {
    run_process({"git", "clone", "--quiet", course.string(), tree.string()});
  }
  /// The tests have their own display, and the driver's cache as ./run sets it.
  [[nodiscard]] double run(const std::string& arguments) const {
    return run_in(tree, "test " + arguments, 0,
                  "--unset=DISPLAY --unset=MESA_SHADER_CACHE_DISABLE CCACHE_DISABLE=1");
  }
  [[nodiscard]] double run_of_changed_lab(int number) const {
    edit(tree / "labs/05_normal_map/lab.cpp", number);
    return run("5");
  }
};

/// A starter that a course's tree made.
struct Starter {
  fs::path tree;

  Starter(const fs::path& course, fs::path to) : tree(std::move(to)) {
    run_process({(course / "build/release/bin/texel").string(), "starter", "--out", tree.string()});
  }

  double run(const std::string& arguments, int most_code, const std::string& environment = {}) const {
    return run_in(tree, arguments, most_code, environment);
  }

  /// Nothing is built, and the compiler's cache has nothing.
  [[nodiscard]] double first_run() const {
    fs::remove_all(tree / "build");
    fs::remove_all(tree / "out");
    return run("", 0, "CCACHE_DISABLE=1");
  }

  [[nodiscard]] double save_to_verdict(const std::string& file, int number) const {
    edit(tree / file, number);
    return run("check 5", 1);
  }

  [[nodiscard]] double lines_of_cpp() const {
    double lines = 0;
    for (const char* folder : {"common", "labs", "tools"})
      for (const fs::directory_entry& file : fs::recursive_directory_iterator(tree / folder)) {
        const std::string ending = file.path().extension().string();
        if (ending != ".cpp" && ending != ".hpp") continue;
        const std::string text = read_file(file.path());
        lines += static_cast<double>(std::count(text.begin(), text.end(), '\n'));
      }
    return lines;
  }
};

}  // namespace

void measure_waits(const Options& options, Report& report) {
  const auto add = [&](const std::string& what, const std::string& unit, int rounds, double target,
                       const Starter& now, const Starter& before,
                       const std::function<double(const Starter&)>& measure, const std::string& why = {}) {
    report.add(row_of(what, "now", "before", unit,
                      interleaved(
                          rounds, [&] { return measure(now); }, [&] { return measure(before); }),
                      Target::at_most, target, why));
  };
  if (!options.first_run_before.empty()) {
    report.begin("A student's first ./run",
                 fmt::format("In starters of this tree and of the earlier commit {}, in turn: with nothing "
                             "built, without the compiler's cache, all packages installed.",
                             commit_of(options.first_run_before)));
    const Starter now(options.root, options.work / "now"),
        before(options.first_run_before, options.work / "before");
    add(
        "C++ in a student's tree", "lines", 1, 0.5, now, before,
        [](const Starter& s) { return s.lines_of_cpp(); },
        "window 4000 lines, meshes 3300, OpenGL 2500, app 2500, pictures 2300, labs 2200, course 1800, "
        "command line 1600, judge 1300, core 1200, procedural 1100. The grader is left out already.");
    add(
        "the first ./run", "ms", options.long_rounds(), 0.5, now, before,
        [](const Starter& s) { return s.first_run(); },
        "nearly all of it compiles: app takes 12 %, commands and judge 10 each, meshes and window 9 "
        "each, the nine labs 8, pictures 7, start, course and precompiled headers 6 each. Files that "
        "nobody edits are compiled seven at a time, and the window with few optimisations; before that "
        "the ratio was 0.93. Tried: no optimisation at all for the two files with the command line's "
        "library saves 2 s of processor time of 92.");
  }
  if (options.saves_before.empty()) return;
  report.begin("From a save to the verdict",
               fmt::format("`./run check 5` in starters of this tree and of the earlier commit {}, in turn, "
                           "after a save of a file.",
                           commit_of(options.saves_before)));
  const Starter now(options.root, options.work / "saved_now"),
      before(options.saves_before, options.work / "saved_before");
  now.run("build", 0), before.run("build", 0);
  int edits = 0;
  struct Save {
    const char* file;
    double target;
    const char* why = "";
    const char* was = file;  ///< in a tree that does not have `file` yet
  };
  for (const Save& save :
       {Save{"shaders/05_normal_map/decode_normal.glsl", 0.8},
        {"labs/05_normal_map/lab.cpp", 0.45,
         "0.9 of 1.1 s of processor time compile and link it, 0.2 check. The file is compiled with few "
         "optimisations and with precompiled headers."},
        {"labs/05_normal_map/triangle_frame.cpp", 0.5, "It is a small file, and the lab alone is linked.",
         "common/mesh/tangents.cpp"}})
    add(
        save.file, "ms", options.rounds, save.target, now, before,
        [&](const Starter& s) {
          return s.save_to_verdict(fs::exists(s.tree / save.file) ? save.file : save.was, ++edits);
        },
        save.why);
}

void measure_tests(const Options& options, Report& report) {
  if (options.saves_before.empty()) return;
  report.begin(
      "The tests",
      fmt::format("`./run test` in clones of this commit and of the earlier commit {}, once each, with "
                  "nothing built, without the compiler's cache, all packages installed; and `./run "
                  "test 5` in the same clone after a line was added to lab 5's `lab.cpp`.",
                  commit_of(options.saves_before)));
  const Tested now(options.root, options.work / "tests_now"),
      before(options.saves_before, options.work / "tests_before");
  const double from_nothing_before = before.run("");
  report.add(row_of(
      "./run test", "now", "before", "ms", {{now.run(""), from_nothing_before}}, Target::at_most, 0.7,
      "37 tests more than before. Two changes are younger than this figure. The build for the sanitizers is "
      "not optimised any more, and takes 127 s; it took 204. The grader does not draw the catalogue of "
      "mistakes any more, so the test of steps that are judged alone takes 81 s; it took 236. In a bare root "
      "of another machine all tests took 939 s after both changes: the tests themselves 594, those with the "
      "sanitizers 38, and nearly all of the rest compiles."));
  std::vector<Pair> changed;
  for (int i = 0; i < options.long_rounds(); ++i)
    changed.push_back({now.run_of_changed_lab(i), from_nothing_before});
  report.add(
      row_of("./run test 5, beside all from nothing", "now", "before", "ms", changed, Target::at_most, 0.05));
}

}  // namespace texel::bench
