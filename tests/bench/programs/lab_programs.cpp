// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "core/error.hpp"
#include "core/files.hpp"
#include "core/process.hpp"
#include "image/difference.hpp"
#include "image/load.hpp"
#include "measures.hpp"

namespace texel::bench {
namespace {

struct LabProgram {
  int number;
  std::string program, floor;
};
const LabProgram kFloors[] = {{1, "lab01_texture_quad", "floor_lab01"},
                              {5, "lab05_normal_map", "floor_lab05"},
                              {9, "lab09_bump", "floor_lab09"}};

/// Of llvmpipe, as gl::Shaders sets it, for where both sides are to have the same.
const std::vector<std::string> kQuickToDraw = {"GALLIVM_PERF=no_aos_sampling"},
                               kQuickToCompile = {"GALLIVM_PERF=no_aos_sampling,nopt"};

void check_same(const std::string& a, const std::string& b) {
  if (image::compare(image::load8(a, 3), image::load8(b, 3)).max > 0)
    throw Error::failed("draws another picture than " + a, {b}, "what is not the same cannot be compared");
}

void add_batch(const Options& options, Report& report, const std::string& what, const LabProgram& lab,
               const Json& list, const std::vector<std::vector<std::string>>& alone, double target) {
  const std::string file = options.work_file("list.json");
  write_file(file, to_text(list));
  const std::vector<Pair> pairs = interleaved(
      options.long_rounds(),
      [&] {
        return run_process(
                   {options.program(lab.program), "--batch", file, "--out", options.work_file("batch")})
            .milliseconds;
      },
      [&] {
        double sum = 0;
        for (const std::vector<std::string>& command : alone) sum += run_process(command).milliseconds;
        return sum;
      });
  for (std::size_t i = 0; i < alone.size(); ++i)
    check_same(options.work_file(fmt::format("alone_{}.png", i)),
               options.work_file(fmt::format("batch/{}.png", i)));
  report.add(row_of(what, "one process", "36 processes", "ms", pairs, Target::at_least, target));
}

struct WindowTimes {
  double first, panel, frame, plumbing;  ///< milliseconds
};
WindowTimes window_times(const Options& options, const LabProgram& lab, int frames,
                         const std::vector<std::string>& environment = {},
                         const std::vector<std::string>& arguments = {}) {
  std::vector<std::string> command = {"env"};
  command.insert(command.end(), environment.begin(), environment.end());
  command.insert(command.end(), {options.program(lab.program), "--frames", fmt::format("{}", frames),
                                 "--context", "window"});
  command.insert(command.end(), arguments.begin(), arguments.end());
  const std::string text = run_program(command).output;
  const auto after = [&](const std::string& words) {
    const std::size_t at = text.find(words);
    if (at == std::string::npos) throw Error::failed("prints no times: " + text, {lab.program});
    return std::atof(text.c_str() + at + words.size());
  };
  return {after("the first after "), after("the panel after "), after("median "), after("parameters: ")};
}

/// Says so where there is none.
bool has_display() {
  if (std::getenv("DISPLAY") != nullptr) return true;
  fmt::print("  skipped: there is no display; ./run performance has one\n");
  return false;
}

}  // namespace

void measure_snapshots(const Options& options, Report& report) {
  report.begin("A snapshot beside its floor",
               "A floor (`tests/bench/floor`) is the same picture written by hand in one program without the "
               "framework: OSMesa, libspng, the same files. From the start of the process to its end, "
               "512x512 with 4 samples a pixel, nothing warmed up but the disk's cache. A lab that draws one "
               "picture asks llvmpipe for shaders that are quick to compile (`gl::Shaders`), a floor leaves "
               "the driver as it is; *quick too* is a floor that asks for the same.");
  for (const LabProgram& lab : kFloors) {
    const std::string ours = options.work_file("ours.png"), theirs = options.work_file("floor.png");
    std::vector<Pair> memory;
    Pair last;
    const std::vector<Pair> times = interleaved(
        options.rounds,
        [&] {
          const Run run = run_process({options.program(lab.program), "--snapshot", ours});
          last.ours = run.mebibytes;
          return run.milliseconds;
        },
        [&] {
          const Run run = run_process({options.program(lab.floor), options.assets(), theirs});
          last.theirs = run.mebibytes;
          if (last.ours > 0) memory.push_back(last);
          return run.milliseconds;
        });
    check_same(ours, theirs);
    const std::string name = fmt::format("lab {}", lab.number);
    report.add(row_of(name + ", time", "lab", "floor", "ms", times, Target::at_most, 1.25));
    report.add(row_of(name + ", memory", "lab", "floor", "MiB", memory, Target::at_most, 1.3));
    report.add(row_of(
        name + ", the floor's shaders quick too", "lab", "floor", "ms",
        interleaved(
            options.rounds,
            [&] {
              return run_process({options.program(lab.program), "--snapshot", ours}).milliseconds;
            },
            [&] {
              return run_process({options.program(lab.floor), options.assets(), theirs}, kQuickToCompile)
                  .milliseconds;
            }),
        Target::at_most, 1.25));
    const Json stats = parse_json(run_program({options.program(lab.program), "--snapshot",
                                               options.work_file("stats.png"), "--stats", "-"})
                                      .output);
    report.add_stages(name, stats.at("milliseconds"));
  }
}

/// A picture more in a process that is under way: the difference of a run with many and one with one,
/// shared.
void measure_one_more(const Options& options, Report& report) {
  constexpr int more = 20;
  report.begin(
      "One more picture",
      fmt::format("The same picture once more from a process that has drawn it already (a lab's `--batch`, "
                  "which compresses it beside the next one's drawing; the floor in a loop): the time of {} "
                  "and of one, and the difference shared. Both have "
                  "optimised shaders.",
                  more + 1));
  for (const LabProgram& lab : kFloors) {
    const auto list = [&](int count) {
      Json entries = Json::array();
      for (int i = 0; i < count; ++i) entries.push_back({{"name", fmt::format("{}", i)}});
      const std::string file = options.work_file(fmt::format("warm_{}.json", count));
      write_file(file, to_text(entries));
      return file;
    };
    const std::string many = list(more + 1), one = list(1);
    const auto ours = [&](const std::string& file) {
      return run_process({options.program(lab.program), "--batch", file, "--out", options.work_file("warm")},
                         kQuickToDraw)
          .milliseconds;
    };
    const auto theirs = [&](int count) {
      return run_process({options.program(lab.floor), options.assets(), options.work_file("floor.png"),
                          fmt::format("{}", count)})
          .milliseconds;
    };
    report.add(row_of(fmt::format("lab {}, one more", lab.number), "lab", "floor", "ms",
                      interleaved(
                          options.rounds, [&] { return (ours(many) - ours(one)) / more; },
                          [&] { return (theirs(more + 1) - theirs(1)) / more; }),
                      Target::at_most, 1.15));
    check_same(options.work_file(fmt::format("warm/{}.png", more)), options.work_file("floor.png"));
  }
}

void measure_batches(const Options& options, Report& report) {
  constexpr int count = 36;
  report.begin("A batch beside a process each",
               "36 snapshots of 512x512 by one process (`--batch`), which optimises its shaders where each "
               "draws much, and by 36, which do not, one after the other.");
  for (const LabProgram& lab : kFloors) {
    Json turned = Json::array();
    std::vector<std::vector<std::string>> alone;
    for (int i = 0; i < count; ++i) {
      const std::string name = fmt::format("{}", i);
      turned.push_back({{"name", name}, {"set", {{"yaw", 10 * i}}}});
      alone.push_back({options.program(lab.program), "--yaw", fmt::format("{}", 10 * i), "--snapshot",
                       options.work_file("alone_" + name + ".png")});
    }
    add_batch(options, report, fmt::format("lab {}, a turning camera", lab.number), lab, turned, alone, 5);
  }
  // All methods and views: each is a program of its own that the driver compiles.
  {
    const LabProgram& lab = kFloors[1];
    Json all = Json::array();
    std::vector<std::vector<std::string>> alone;
    const Json parameters =
        parse_json(run_program({options.program(lab.program), "--list-parameters", "--json"}).output);
    std::vector<std::string> methods;
    for (const Json& parameter : parameters)
      if (parameter.at("name") == "method")
        for (const Json& choice : parameter.at("choices")) methods.push_back(choice.at("name"));
    const std::vector<std::string> views = {"color", "texcoord", "depth", "mask"};
    for (int i = 0; i < count; ++i) {
      const std::string method = methods[static_cast<std::size_t>(i) % methods.size()],
                        view = views[static_cast<std::size_t>(i) / methods.size() % views.size()],
                        name = fmt::format("{}", i);
      all.push_back({{"name", name}, {"view", view}, {"set", {{"method", method}, {"yaw", i}}}});
      alone.push_back({options.program(lab.program), "--method", method, "--yaw", name, "--view", view,
                       "--snapshot", options.work_file("alone_" + name + ".png")});
    }
    add_batch(options, report, fmt::format("lab {}, all methods, four views", lab.number), lab, all, alone,
              0);
  }
}

void measure_frames(const Options& options, Report& report) {
  report.begin(
      "The panel's share of a frame",
      "A window of 960x720 with its panel on a software renderer. What panel, statistics and parameters take "
      "of the main thread's processor, beside the whole frame: drawn, shown, answered by the X server.");
  if (!has_display()) return;
  for (const LabProgram& lab : kFloors) {
    std::vector<Pair> pairs;
    for (int i = 0; i < options.rounds; ++i) {
      const WindowTimes times = window_times(options, lab, 60);
      pairs.push_back({times.plumbing, times.frame});
    }
    report.add(row_of(fmt::format("lab {}", lab.number), "panel, statistics, parameters", "frame", "ms",
                      pairs, Target::at_most, 0.02));
  }
}

void measure_window_start(const Options& options, Report& report) {
  report.begin(
      "A window's first picture",
      "From the start of the process until the first picture is on the screen, and until the panel "
      "is, which comes with the next; beside the floor's snapshot, from the start of its process to "
      "its end. *Shaders kept*: both with the driver's cache of shaders, as users have them from the "
      "second time on. Without it the driver translates the panel's shader after the picture's. Both draw "
      "the plain look (`--view color`). With the best look, with which lab 5 opens, its picture comes 50 ms "
      "later than with the plain one (16 rounds, alone). The panel comes 55 to 59 ms after the picture where "
      "its "
      "shader is translated, and 13 to 14 where that is kept: so much the panels of labs 1 and 5 lack.");
  if (!has_display()) return;
  for (const LabProgram& lab : kFloors)
    for (const bool keeps : {false, true}) {
      const std::vector<std::string> environment =
          keeps ? options.kept_shaders() : std::vector<std::string>();
      const std::string what = keeps ? ", shaders kept" : "";
      std::vector<Pair> picture, panel;
      for (int i = keeps ? -1 : 0; i < options.rounds; ++i) {
        const WindowTimes ours = window_times(options, lab, 1, environment, {"--view", "color"});
        const double floor =
            run_process({options.program(lab.floor), options.assets(), options.work_file("floor.png")},
                        environment)
                .milliseconds;
        if (i < 0) continue;  // which fills the cache
        picture.push_back({ours.first, floor});
        panel.push_back({ours.panel, floor});
      }
      report.add(row_of(fmt::format("lab {}, the picture{}", lab.number, what), "window", "floor", "ms",
                        picture, Target::at_most, 1.4));
      report.add(row_of(fmt::format("lab {}, the panel{}", lab.number, what), "window", "floor", "ms", panel,
                        Target::at_most, 1.4));
    }
}

}  // namespace texel::bench
