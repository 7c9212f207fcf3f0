// SPDX-License-Identifier: MIT
#include "rounds.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/stopwatch.hpp"

namespace texel::bench {

Run run_process(const std::vector<std::string>& command, const std::vector<std::string>& environment) {
  const auto pointers = [](const std::vector<std::string>& texts) {
    std::vector<char*> all;
    for (const std::string& text : texts) all.push_back(const_cast<char*>(text.c_str()));
    return all;
  };
  std::vector<char*> arguments = pointers(command), variables = pointers(environment);
  arguments.push_back(nullptr);
  for (char** variable = environ; *variable != nullptr; ++variable) variables.push_back(*variable);
  variables.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  const Stopwatch stopwatch;
  pid_t process = 0;
  const int error =
      ::posix_spawnp(&process, arguments[0], &actions, nullptr, arguments.data(), variables.data());
  ::posix_spawn_file_actions_destroy(&actions);
  if (error != 0) throw Error::failed("cannot be started", {command.front()}, "./run performance builds it");
  int status = 0;
  rusage usage{};
  ::wait4(process, &status, 0, &usage);
  const double milliseconds = stopwatch.milliseconds();
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
    throw Error::failed(fmt::format("failed: {}", fmt::join(command, " ")));
  return {milliseconds, static_cast<double>(usage.ru_maxrss) / 1024};
}

Spread spread_of(std::vector<double> figures) {
  std::sort(figures.begin(), figures.end());
  const auto at = [&](double q) {  // between two figures as far as q lies between them
    const double place = q * static_cast<double>(figures.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, figures.size() - 1);
    return std::lerp(figures[below], figures[above], place - static_cast<double>(below));
  };
  return {at(0.5), at(0.25), at(0.75)};
}

std::vector<Pair> interleaved(int rounds, const std::function<double()>& ours,
                              const std::function<double()>& theirs) {
  theirs();
  ours();
  std::vector<Pair> pairs;
  for (int i = 0; i < rounds; ++i) {
    // Who comes second finds the caches as the first left them: they change places.
    Pair pair;
    if (i % 2 == 0) pair.ours = ours();
    pair.theirs = theirs();
    if (i % 2 != 0) pair.ours = ours();
    pairs.push_back(pair);
  }
  return pairs;
}

Row row_of(const std::string& what, const std::string& ours_is, const std::string& theirs_is,
           const std::string& unit, const std::vector<Pair>& pairs, Target kind, double target,
           const std::string& why) {
  std::vector<double> ours, theirs, ratios;
  for (const Pair& pair : pairs) {
    ours.push_back(pair.ours);
    theirs.push_back(pair.theirs);
    ratios.push_back(kind == Target::at_most ? pair.ours / pair.theirs : pair.theirs / pair.ours);
  }
  Row row{what, ours_is, theirs_is, unit, spread_of(ours), spread_of(theirs), spread_of(ratios),
          "",   true,    why};
  if (target <= 0) return row;
  row.target = fmt::format("{} {}", kind == Target::at_most ? "at most" : "at least", target);
  row.reached = kind == Target::at_most ? row.ratio.median <= target : row.ratio.median >= target;
  return row;
}

}  // namespace texel::bench
