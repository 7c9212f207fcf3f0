// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <sstream>

#include "app/assets.hpp"
#include "commands.hpp"
#include "core/files.hpp"
#include "core/stopwatch.hpp"
#include "course/course_commands.hpp"
#include "course/mutants/results.hpp"
#include "course/mutants/suite.hpp"
#include "course/mutants/tree.hpp"

namespace texel::tools {
namespace {

namespace fs = std::filesystem;

/// The limit of the whole course, in per cent.
constexpr double kWanted = 90;

/// The names after --only; a file's name stands for what is in it, one a line.
std::vector<std::string> chosen_names(const std::vector<std::string>& only) {
  std::vector<std::string> names;
  for (const std::string& word : only) {
    if (!fs::is_regular_file(word)) {
      names.push_back(word);
      continue;
    }
    std::istringstream lines(read_file(word));
    for (std::string name; lines >> name;) names.push_back(name);
  }
  return names;
}

/// The mutants that are asked for, in the catalogue's order.
std::vector<course::Mutant> chosen(const std::vector<course::Mutant>& mutants,
                                   const std::vector<std::string>& only) {
  if (only.empty()) return mutants;
  const std::vector<std::string> names = chosen_names(only);
  std::vector<std::string> known;
  for (const course::Mutant& mutant : mutants) known.push_back(mutant.name);
  for (const std::string& name : names) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    const std::string near = nearest(name, known);
    throw Error::usage(
        fmt::format("there is no mutant '{}'", name),
        near.empty() ? "the catalogue is tests/mutants" : fmt::format("did you mean '{}'?", near));
  }
  std::vector<course::Mutant> result;
  std::copy_if(mutants.begin(), mutants.end(), std::back_inserter(result), [&](const course::Mutant& mutant) {
    return std::find(names.begin(), names.end(), mutant.name) != names.end();
  });
  return result;
}

void say(const std::string& line) {
  fmt::print("{}\n", line);
  std::fflush(stdout);  // a log shows each as it ends
}

/// Makes one mutant and asks the tests.
MutantResult try_mutant(const Tree& tree, const Suite& suite, const course::Mutant& mutant) {
  const Stopwatch stopwatch;
  MutantResult result;
  result.mutant = mutant;
  try {
    const AppliedMutant applied(tree, mutant);
    const Verdict verdict = suite.judge(mutant.file, mutant.name);
    result.fate = !verdict.builds ? Fate::broken : verdict.caught_by.empty() ? Fate::survived : Fate::caught;
    result.by = verdict.builds ? verdict.caught_by : "it does not compile";
  } catch (const Error& error) {
    result.by = error.what();
  }
  result.seconds = stopwatch.milliseconds() / 1000;
  return result;
}

std::string outcome(const MutantResult& result) {
  switch (result.fate) {
    case Fate::caught:
      return "caught by " + result.by;
    case Fate::survived:
      return result.mutant.survives.empty() ? "SURVIVED" : "survived, as the catalogue expects";
    case Fate::broken:
      break;
  }
  return "BROKEN: " + result.by;
}

/// Where the results of earlier calls stand, with those of this one in place of what they were.
class Record {
 public:
  Record(fs::path store, fs::path report, const std::vector<course::Mutant>& catalogue)
      : store_(std::move(store)), report_(std::move(report)), results_(read_report(store_, catalogue)) {}

  void add(const MutantResult& result) {
    const auto known = std::find_if(results_.begin(), results_.end(), [&](const MutantResult& other) {
      return other.mutant.name == result.mutant.name;
    });
    if (known == results_.end())
      results_.push_back(result);
    else
      *known = result;
    write();
  }
  void write() const {
    write_report(store_, results_);
    if (!report_.empty()) write_report(report_, results_);
  }

 private:
  fs::path store_, report_;
  std::vector<MutantResult> results_;
};

void say_survivors(const std::vector<MutantResult>& results) {
  for (const MutantResult& result : results)
    if (result.fate == Fate::survived)
      say(fmt::format(
          "survived: {} ({}): {}", result.mutant.name, result.mutant.file,
          result.mutant.survives.empty() ? "the catalogue gives no reason" : result.mutant.survives));
}

}  // namespace

Exit mutants(const MutantsOptions& options) {
  if (!options.report.empty() && options.report.extension() != ".md" && options.report.extension() != ".json")
    throw Error::usage(fmt::format("--report cannot write '{}'", options.report.string()),
                       "end the name in .md or .json");
  const fs::path root = options.root.empty() ? app::Assets().shader_root().parent_path() : options.root;
  const fs::path work = options.work.empty() ? root / "build/mutants" : options.work;
  const std::vector<course::Mutant> catalogue =
      course::read_catalogue(options.catalogue.empty() ? root / "tests/mutants" : options.catalogue);
  const std::vector<course::Mutant> mutants = chosen(catalogue, options.only);

  const Tree tree(root, fs::absolute(work) / "tree");
  say(fmt::format("copying the tree into {} and building it", tree.folder().string()));
  const bool is_changed = tree.update();
  Suite suite(tree.folder(), fs::absolute(work) / "logs");
  suite.prepare();
  say("running the tests once without a mutant");
  suite.measure(is_changed);

  Record record(fs::absolute(work) / "results.json", options.report, catalogue);
  std::vector<MutantResult> results;
  const Stopwatch stopwatch;
  for (const course::Mutant& mutant : mutants) {
    results.push_back(try_mutant(tree, suite, mutant));
    record.add(results.back());
    const double each = stopwatch.milliseconds() / 1000 / static_cast<double>(results.size());
    const std::size_t left = mutants.size() - results.size();
    say(fmt::format("{:3}/{} {:<32} {} ({}; {} left)", results.size(), mutants.size(), mutant.name,
                    outcome(results.back()), duration_text(results.back().seconds),
                    duration_text(each * static_cast<double>(left))));
  }
  const Score total = score(results);
  say_survivors(results);
  say(fmt::format("{}; {} survive for a reason; {} took {}", total.text(), total.explained, mutants.size(),
                  duration_text(stopwatch.milliseconds() / 1000)));
  if (total.broken > 0)
    throw Error::failed(fmt::format("{} mutants do not apply or do not compile", total.broken), {},
                        "correct the catalogue in tests/mutants");
  return total.percent() >= kWanted ? Exit::holds : Exit::differs;
}

}  // namespace texel::tools
