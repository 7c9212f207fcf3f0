// SPDX-License-Identifier: MIT
// What a student waits for, in this tree and in an earlier commit's: the first ./run, and from a save to the
// verdict.
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

/// A starter that a course's tree made.
struct Starter {
  fs::path tree;

  Starter(const fs::path& course, fs::path to) : tree(std::move(to)) {
    run_process({(course / "build/release/bin/texel").string(), "starter", "--out", tree.string()});
  }

  /// Milliseconds of `./run …` there. It ends with at most this exit code.
  [[nodiscard]] double run(const std::string& arguments, int most_code,
                           const std::string& environment = {}) const {
    const Stopwatch stopwatch;
    const Ran ran = run_program(
        {"sh", "-c",
         fmt::format("cd '{}' && TEXEL_NO_APT=1 {} ./run {}", tree.string(), environment, arguments)},
        true);
    if (ran.exit_code > most_code)
      throw Error::failed(fmt::format("./run {} failed: {}", arguments, ran.output), {tree.string()});
    return stopwatch.milliseconds();
  }

  /// Nothing is built, and the compiler's cache has nothing.
  [[nodiscard]] double first_run() const {
    fs::remove_all(tree / "build");
    fs::remove_all(tree / "out");
    return run("", 0, "CCACHE_DISABLE=1");
  }

  /// A text that was never compiled, so that the compiler's cache does not have it.
  [[nodiscard]] double save_to_verdict(const std::string& file, int edit) const {
    const std::string text = read_file(tree / file), mark = "\n// edited: ";
    const std::string name = fmt::format("edited_{}", edit);
    const std::string line = fs::path(file).extension() == ".cpp"
                                 ? fmt::format("namespace {{ [[maybe_unused]] constexpr int {} = 0; }}", name)
                                 : fmt::format("const float {} = 0.0;", name);
    write_file(tree / file, text.substr(0, text.find(mark)) + mark + "\n" + line + "\n");
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
  if (options.before.empty()) return;
  std::string commit =
      run_program({"git", "-C", options.before.string(), "rev-parse", "--short", "HEAD"}).output;
  commit.erase(commit.find_last_not_of('\n') + 1);
  report.begin(
      "What a student waits for",
      fmt::format("Starters of this tree and of the earlier commit {}, in turn. `./run` with nothing "
                  "built, without the compiler's cache, all packages installed. `./run check 5` "
                  "after a save of a file.",
                  commit));
  const Starter now(options.root, options.work / "now"), before(options.before, options.work / "before");
  const auto add = [&](const std::string& what, const std::string& unit, int rounds, double target,
                       const std::function<double(const Starter&)>& measure, const std::string& why = {}) {
    report.add(row_of(what, "now", "before", unit,
                      interleaved(
                          rounds, [&] { return measure(now); }, [&] { return measure(before); }),
                      Target::at_most, target, why));
  };
  add("C++ in a student's tree", "lines", 1, 0.5, [](const Starter& s) { return s.lines_of_cpp(); });
  add(
      "the first ./run", "ms", options.long_rounds(), 0.5, [](const Starter& s) { return s.first_run(); },
      "59 of 64 s compile. The window takes 14 % of that, app 13, the command line and the judge 10 each, "
      "meshes, pictures, OpenGL, course and check 6 to 7 each, the nine labs together 6.");
  int edit = 0;
  for (const auto& [file, target] :
       {std::pair("shaders/05_normal_map/decode_normal.glsl", 0.8),
        std::pair("labs/05_normal_map/lab.cpp", 0.45), std::pair("common/mesh/tangents.cpp", 0.5)})
    add(fmt::format("save to verdict: {}", file), "ms", options.rounds, target,
        [&](const Starter& s) { return s.save_to_verdict(file, ++edit); });
}

}  // namespace texel::bench
