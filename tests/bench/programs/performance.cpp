// SPDX-License-Identifier: MIT
// Measures what docs/performance.md says, and writes it. No figure fails: the program ends with an error only
// where a result is missing or wrong.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "core/files.hpp"
#include "core/process.hpp"
#include "core/scratch_folder.hpp"
#include "image/difference.hpp"
#include "image/load.hpp"
#include "rounds.hpp"

namespace {

using namespace texel;
using namespace texel::bench;
namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct Options {
  fs::path bin = TEXEL_BIN, root = TEXEL_SOURCE, work;
  int rounds = 11;
  std::string only, json, markdown;
};

struct LabProgram {
  int number;
  std::string program, floor;
};
const LabProgram kFloors[] = {{1, "lab01_texture_quad", "floor_lab01"},
                              {5, "lab05_normal_map", "floor_lab05"},
                              {9, "lab09_bump", "floor_lab09"}};

/// The report as it grows.
struct Report {
  struct Section {
    std::string title, text;
    std::vector<Row> rows;
  };
  std::vector<Section> sections;

  void begin(const std::string& title, const std::string& text) {
    fmt::print("\n{}\n", title);
    sections.push_back({title, text, {}});
  }
  void add(const Row& row) {
    fmt::print("  {:<44} {:8.2f} ({:.2f} to {:.2f})  {}{}\n", row.what, row.ratio.median, row.ratio.lower,
               row.ratio.upper, row.target, row.reached ? "" : "  MISSED");
    std::fflush(stdout);
    sections.back().rows.push_back(row);
  }
};

class Bench {
 public:
  explicit Bench(const Options& options) : options_(options) {}

  void run() {
    // With the driver's cache of compiled shaders the second start would be another one than the first.
    ::setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
    const std::pair<const char*, void (Bench::*)()> parts[] = {
        {"snapshots", &Bench::snapshots}, {"warm", &Bench::warm},     {"batch", &Bench::batch},
        {"kernels", &Bench::kernels},     {"frames", &Bench::frames}, {"start", &Bench::start}};
    for (const auto& [name, measure] : parts)
      if (options_.only.empty() || options_.only == name) (this->*measure)();
    if (!options_.json.empty()) write_file(options_.json, as_json());
    if (!options_.markdown.empty()) write_file(options_.markdown, as_markdown());
  }

 private:
  [[nodiscard]] std::string program(const std::string& name) const { return (options_.bin / name).string(); }
  [[nodiscard]] std::string assets() const { return (options_.root / "assets").string(); }
  [[nodiscard]] std::string work(const std::string& name) const { return (options_.work / name).string(); }

  void check_same(const std::string& a, const std::string& b) const {
    if (image::compare(image::load8(a, 3), image::load8(b, 3)).max > 0)
      throw Error::failed("draws another picture than " + a, {b}, "what is not the same cannot be compared");
  }

  void snapshots() {
    report_.begin(
        "A snapshot beside its floor",
        "A floor (`tests/bench/floor`) is the same picture written by hand in one program without the "
        "framework: OSMesa, libspng, the same files. From the start of the process to its end, 512x512 "
        "with 4 samples a pixel, nothing warmed up but the disk's cache.");
    for (const LabProgram& lab : kFloors) {
      const std::string ours = work("ours.png"), theirs = work("floor.png");
      std::vector<Pair> memory;
      Pair last;
      const std::vector<Pair> times = interleaved(
          options_.rounds,
          [&] {
            const Run run = run_process({program(lab.program), "--snapshot", ours});
            last.ours = run.mebibytes;
            return run.milliseconds;
          },
          [&] {
            const Run run = run_process({program(lab.floor), assets(), theirs});
            last.theirs = run.mebibytes;
            if (last.ours > 0) memory.push_back(last);
            return run.milliseconds;
          });
      check_same(ours, theirs);
      const std::string name = fmt::format("lab {}", lab.number);
      report_.add(row_of(name + ", time", "lab", "floor", "ms", times, Target::at_most, 1.25));
      report_.add(row_of(name + ", memory", "lab", "floor", "MiB", memory, Target::at_most, 1.3));
      const Json stats = Json::parse(
          run_program({program(lab.program), "--snapshot", work("stats.png"), "--stats", "-"}).output);
      stages_.emplace_back(name, stats.at("milliseconds"));
    }
  }

  /// A picture more in a process that is under way: the difference of a run with many and one with one,
  /// shared.
  void warm() {
    constexpr int more = 20;
    report_.begin(
        "One more picture",
        fmt::format("The same picture once more from a process that has drawn it already (a lab's `--batch`; "
                    "the floor in a loop): the time of {} and of one, and the difference shared.",
                    more + 1));
    for (const LabProgram& lab : kFloors) {
      const auto list = [&](int count) {
        Json entries = Json::array();
        for (int i = 0; i < count; ++i) entries.push_back({{"name", fmt::format("{}", i)}});
        const std::string file = work(fmt::format("warm_{}.json", count));
        write_file(file, entries.dump());
        return file;
      };
      const std::string many = list(more + 1), one = list(1);
      const auto ours = [&](const std::string& file) {
        return run_process({program(lab.program), "--batch", file, "--out", work("warm")}).milliseconds;
      };
      const auto theirs = [&](int count) {
        return run_process({program(lab.floor), assets(), work("floor.png"), fmt::format("{}", count)})
            .milliseconds;
      };
      report_.add(row_of(fmt::format("lab {}, one more", lab.number), "lab", "floor", "ms",
                         interleaved(
                             options_.rounds, [&] { return (ours(many) - ours(one)) / more; },
                             [&] { return (theirs(more + 1) - theirs(1)) / more; }),
                         Target::at_most, 1.15));
      check_same(work(fmt::format("warm/{}.png", more)), work("floor.png"));
    }
  }

  void batch() {
    constexpr int count = 36;
    report_.begin("A batch beside a process each",
                  "36 snapshots of 512x512 by one process (`--batch`) and by 36, one after the other.");
    for (const LabProgram& lab : kFloors) {
      Json turned = Json::array();
      std::vector<std::vector<std::string>> alone;
      for (int i = 0; i < count; ++i) {
        const std::string name = fmt::format("{}", i);
        turned.push_back({{"name", name}, {"set", {{"yaw", 10 * i}}}});
        alone.push_back({program(lab.program), "--yaw", fmt::format("{}", 10 * i), "--snapshot",
                         work("alone_" + name + ".png")});
      }
      add_batch(fmt::format("lab {}, a turning camera", lab.number), lab, turned, alone, 5);
    }
    // All methods and views: each is a program of its own that the driver compiles.
    {
      const LabProgram& lab = kFloors[1];
      Json all = Json::array();
      std::vector<std::vector<std::string>> alone;
      const Json parameters =
          Json::parse(run_program({program(lab.program), "--list-parameters", "--json"}).output);
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
        alone.push_back({program(lab.program), "--method", method, "--yaw", name, "--view", view,
                         "--snapshot", work("alone_" + name + ".png")});
      }
      add_batch(fmt::format("lab {}, all methods, four views", lab.number), lab, all, alone, 0);
    }
  }

  /// Each takes a minute.
  [[nodiscard]] int batch_rounds() const { return std::max(1, options_.rounds / 4); }

  void add_batch(const std::string& what, const LabProgram& lab, const Json& list,
                 const std::vector<std::vector<std::string>>& alone, double target) {
    const std::string file = work("list.json");
    write_file(file, list.dump());
    const std::vector<Pair> pairs = interleaved(
        batch_rounds(),
        [&] {
          return run_process({program(lab.program), "--batch", file, "--out", work("batch")}).milliseconds;
        },
        [&] {
          double sum = 0;
          for (const std::vector<std::string>& command : alone) sum += run_process(command).milliseconds;
          return sum;
        });
    for (std::size_t i = 0; i < alone.size(); ++i)
      check_same(work(fmt::format("alone_{}.png", i)), work(fmt::format("batch/{}.png", i)));
    report_.add(row_of(what, "one process", "36 processes", "ms", pairs, Target::at_least, target));
  }

  /// tests/bench/kernels: Google Benchmark takes the rounds in random order.
  void kernels() {
    report_.begin(
        "Kernels",
        "Google Benchmark, repetitions in random order. The plain versions of tangents and FLIP "
        "are in `tests/support`, and tests hold ours to their results; tinyobjloader is the packaged one.");
    const std::string out = work("kernels.json");
    run_process({program("kernels_bench"), fmt::format("--benchmark_repetitions={}", options_.rounds),
                 "--benchmark_enable_random_interleaving=true", "--benchmark_min_time=0.05",
                 "--benchmark_out_format=json", "--benchmark_out=" + out});
    // name -> the figures of all repetitions, in milliseconds
    std::map<std::string, std::vector<double>> figures;
    const std::map<std::string, double> milliseconds = {{"ns", 1e-6}, {"us", 1e-3}, {"ms", 1}, {"s", 1e3}};
    const Json results = Json::parse(read_file(out));
    for (const Json& one : results.at("benchmarks")) {
      if (one.at("run_type") != "iteration") continue;
      if (one.value("error_occurred", false))
        throw Error::failed(one.value("error_message", std::string("failed")), {one.at("run_name")});
      figures[one.at("run_name")].push_back(one.at("real_time").get<double>() *
                                            milliseconds.at(one.at("time_unit")));
    }
    struct Comparison {
      const char *ours, *theirs;
      bool has_target;
    };
    constexpr Comparison comparisons[] = {{"texel", "tinyobjloader", true},
                                          {"texel_mesh", "tinyobjloader", false},
                                          {"texel", "plain", true},
                                          {"texel", "plain_square", false}};
    for (const auto& [name, ours] : figures)
      for (const Comparison& comparison : comparisons) {
        const std::string part = fmt::format("/{}/", comparison.ours);
        const std::size_t at = name.find(part);
        if (at == std::string::npos) continue;
        const std::string stem = name.substr(0, at);
        const auto theirs =
            figures.find(fmt::format("{}/{}/{}", stem, comparison.theirs, name.substr(at + part.size())));
        if (theirs == figures.end()) continue;
        std::vector<Pair> pairs;
        for (std::size_t i = 0; i < std::min(ours.size(), theirs->second.size()); ++i)
          pairs.push_back({ours[i], theirs->second[i]});
        report_.add(row_of(fmt::format("{}: {} beside {}", stem, comparison.ours, comparison.theirs), "texel",
                           "the other", "ms", pairs, Target::at_least,
                           comparison.has_target ? kernel_target(stem) : 0));
      }
    const Json peak = Json::parse(run_program({program("obj_peak")}).output);
    report_.add(row_of("obj/quads_2m: memory beside the mapped file", "peak", "finished mesh", "meshes",
                       {{peak.at("meshes_beside_the_file").get<double>(), 1.0}}, Target::at_most, 2));
  }

  /// How many times as fast as the other: small files are to be no slower. A heap of identical triangles has none:
  /// it has three distinct vertices, so that the plain version's maps stay in the nearest cache, and what is left
  /// is the same arithmetic.
  static double kernel_target(const std::string& stem) {
    if (stem == "tangents/heap") return 0;
    if (stem.starts_with("flip/")) return 5;
    return stem.starts_with("obj/") && !stem.ends_with("2m") && !stem.ends_with("10m") ? 1 : 3;
  }

  struct WindowTimes {
    double first, frame, plumbing;  ///< milliseconds
  };
  [[nodiscard]] WindowTimes window_times(const LabProgram& lab, int frames) const {
    const std::string text =
        run_program({program(lab.program), "--frames", fmt::format("{}", frames), "--context", "window"})
            .output;
    const auto after = [&](const std::string& words) {
      const std::size_t at = text.find(words);
      if (at == std::string::npos) throw Error::failed("prints no times: " + text, {lab.program});
      return std::atof(text.c_str() + at + words.size());
    };
    return {after("the first after "), after("median "), after("parameters: ")};
  }

  void frames() {
    report_.begin(
        "The panel's share of a frame",
        "A window of 960x720 with its panel on a software renderer. What panel, statistics and parameters "
        "take "
        "of the main thread's processor, beside the whole frame: drawn, shown, answered by the X server.");
    if (!has_display()) return;
    for (const LabProgram& lab : kFloors) {
      std::vector<Pair> pairs;
      for (int i = 0; i < options_.rounds; ++i) {
        const WindowTimes times = window_times(lab, 60);
        pairs.push_back({times.plumbing, times.frame});
      }
      report_.add(row_of(fmt::format("lab {}", lab.number), "panel, statistics, parameters", "frame", "ms",
                         pairs, Target::at_most, 0.02));
    }
  }

  void start() {
    report_.begin(
        "A window's first picture",
        "From the start of the process until the first picture and the panel are on the screen; beside "
        "the floor's snapshot, from the start of its process to its end.");
    if (!has_display()) return;
    for (const LabProgram& lab : kFloors)
      report_.add(
          row_of(fmt::format("lab {}", lab.number), "window", "floor", "ms",
                 interleaved(
                     options_.rounds, [&] { return window_times(lab, 1).first; },
                     [&] {
                       return run_process({program(lab.floor), assets(), work("floor.png")}).milliseconds;
                     }),
                 Target::at_most, 1.5));
  }

  /// Says so where there is none.
  [[nodiscard]] static bool has_display() {
    if (std::getenv("DISPLAY") != nullptr) return true;
    fmt::print("  skipped: there is no display; ./run performance has one\n");
    return false;
  }

  [[nodiscard]] std::string as_json() const {
    Json json;
    const auto spread = [](const Spread& s) {
      return Json{{"median", s.median}, {"lower", s.lower}, {"upper", s.upper}};
    };
    for (const Report::Section& section : report_.sections)
      for (const Row& row : section.rows)
        json["results"].push_back({{"section", section.title},
                                   {"what", row.what},
                                   {"unit", row.unit},
                                   {row.ours_is, spread(row.ours)},
                                   {row.theirs_is, spread(row.theirs)},
                                   {"ratio", spread(row.ratio)},
                                   {"target", row.target},
                                   {"reached", row.reached}});
    for (const auto& [name, stages] : stages_) json["stages"][name] = stages;
    return json.dump(2) + "\n";
  }

  [[nodiscard]] std::string as_markdown() const {
    std::string text = fmt::format(
        "# How fast\n\n"
        "Made by `./run performance`, which takes about a quarter of an hour. All figures are of one "
        "machine, "
        "taken in turn with what they stand beside in {} rounds (a batch in {}); the ratio is the median of "
        "the "
        "rounds, with the quarters below and above it. The driver's cache of compiled shaders is off "
        "(`MESA_SHADER_CACHE_DISABLE=true`). Speed against *error* is in [accuracy.md](accuracy.md).\n",
        options_.rounds, batch_rounds());
    for (const Report::Section& section : report_.sections) {
      if (section.rows.empty()) continue;
      text += fmt::format("\n## {}\n{}\n\n", section.title, section.text);
      text += fmt::format("| | {} | {} | ratio | target |\n|---|---|---|---|---|\n", section.rows[0].ours_is,
                          section.rows[0].theirs_is);
      for (const Row& row : section.rows)
        text +=
            fmt::format("| {} | {:.4g} {} | {:.4g} {} | **{:.3g}** ({:.3g} to {:.3g}) | {}{} |\n", row.what,
                        row.ours.median, row.unit, row.theirs.median, row.unit, row.ratio.median,
                        row.ratio.lower, row.ratio.upper, row.target, row.reached ? "" : ", **missed**");
    }
    if (!stages_.empty()) text += stage_table();
    return text;
  }

  /// Where each millisecond of a snapshot goes, as --stats says it.
  [[nodiscard]] std::string stage_table() const {
    std::string head = "| stage |", rule = "|---|", body;
    std::vector<std::string> names;
    for (const auto& [lab, stages] : stages_) {
      head += fmt::format(" {} |", lab);
      rule += "---|";
      for (const auto& [name, time] : stages.items())
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
    for (const std::string& name : names) {
      body += fmt::format("| {} |", name);
      for (const auto& [lab, stages] : stages_) body += fmt::format(" {:.1f} |", stages.value(name, 0.0));
      body += "\n";
    }
    return "\n## Where a snapshot's milliseconds go\n`labNN --snapshot FILE --stats -`, once. `start` is the "
           "program's own "
           "loading, `loader` the renderer's, `first_draw` mostly the driver's translation of the shaders "
           "into "
           "machine code: `draw` is the same picture once more, when all is there, and not part of "
           "`total`.\n\n" +
           head + "\n" + rule + "\n" + body;
  }

  Options options_;
  Report report_;
  std::vector<std::pair<std::string, Json>> stages_;
};

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app("Measure the course's programs beside others");
  app.add_option("--rounds", options.rounds, "Rounds of each pair [11]")->check(CLI::Range(1, 1000));
  app.add_option("--only", options.only, "One part alone")
      ->check(CLI::IsMember({"snapshots", "warm", "batch", "kernels", "frames", "start"}));
  app.add_option("--json", options.json, "Write all figures into this file");
  app.add_option("--markdown", options.markdown, "Write the report into this file");
  CLI11_PARSE(app, argc, argv);
  try {
    const ScratchFolder folder;
    options.work = folder.path();
    Bench(options).run();
  } catch (const std::exception& error) {
    fmt::print(stderr, "performance: {}\n", error.what());
    return 3;
  }
  return 0;
}
