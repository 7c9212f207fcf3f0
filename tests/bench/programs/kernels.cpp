// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "core/error.hpp"
#include "core/files.hpp"
#include "core/process.hpp"
#include "measures.hpp"

namespace texel::bench {
namespace {

/// How many times as fast as the other: small files are to be no slower. A heap of identical triangles has
/// none: it has three distinct vertices, so that the plain version's maps stay in the nearest cache, and
/// what is left is the same arithmetic.
double kernel_target(const std::string& stem) {
  if (stem == "tangents/heap") return 0;
  if (stem.starts_with("flip/")) return 5;
  return stem.starts_with("obj/") && !stem.ends_with("2m") ? 1 : 3;
}

}  // namespace

/// tests/bench/kernels: Google Benchmark takes the rounds in random order.
void measure_kernels(const Options& options, Report& report) {
  report.begin(
      "Kernels",
      "Google Benchmark, repetitions in random order. The plain versions of tangents and FLIP are in "
      "`tests/support`, and tests hold ours to their results; tinyobjloader is the packaged one.");
  const std::string out = options.work_file("kernels.json");
  run_process({options.program("kernels_bench"), fmt::format("--benchmark_repetitions={}", options.rounds),
               "--benchmark_enable_random_interleaving=true", "--benchmark_min_time=0.05",
               "--benchmark_out_format=json", "--benchmark_out=" + out});
  // name -> the figures of all repetitions, in milliseconds, and the number of triangles
  std::map<std::string, double> triangles;
  std::map<std::string, std::vector<double>> figures;
  const std::map<std::string, double> milliseconds = {{"ns", 1e-6}, {"us", 1e-3}, {"ms", 1}, {"s", 1e3}};
  const Json results = parse_json(read_file(out));
  for (const Json& one : results.at("benchmarks")) {
    if (one.at("run_type") != "iteration") continue;
    if (one.value("error_occurred", false))
      throw Error::failed(one.value("error_message", std::string("failed")), {one.at("run_name")});
    figures[one.at("run_name")].push_back(one.at("real_time").get<double>() *
                                          milliseconds.at(one.at("time_unit")));
    triangles[one.at("run_name")] = one.value("triangles", 0.0);
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
      report.add(row_of(fmt::format("{}: {} beside {}", stem, comparison.ours, comparison.theirs), "texel",
                        "the other", "ms", pairs, Target::at_least,
                        comparison.has_target ? kernel_target(stem) : 0));
    }
  const Json peak = parse_json(run_program({options.program("obj_peak")}).output);
  report.add(row_of("obj/quads_2m: memory beside the mapped file", "peak", "finished mesh", "meshes",
                    {{peak.at("meshes_beside_the_file").get<double>(), 1.0}}, Target::at_most, 2));

  report.begin(
      "More triangles",
      "What one triangle costs in a large mesh and in a small one, in nanoseconds: an OBJ file of 10 and of "
      "2 million triangles to its mesh, tangents of 4 million triangles and of 500 thousand. Caches hold "
      "less of the larger; a quadratic method would have the sizes' own ratio, 5 and 8.");
  for (const auto& [name, large] : figures) {
    const std::size_t at = name.find("/large/");
    if (at == std::string::npos) continue;
    const std::string small = std::string(name).replace(at, 7, "/small/");
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < std::min(large.size(), figures.at(small).size()); ++i)
      pairs.push_back(
          {1e6 * large[i] / triangles.at(name), 1e6 * figures.at(small)[i] / triangles.at(small)});
    report.add(row_of(name.substr(0, at).substr(name.find('/') + 1), "large", "small", "ns", pairs,
                      Target::at_most, 1.5));
  }
}

}  // namespace texel::bench
