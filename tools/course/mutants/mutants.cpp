// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <deque>
#include <sstream>

#include "app/assets.hpp"
#include "commands.hpp"
#include "core/files.hpp"
#include "core/stopwatch.hpp"
#include "core/terminal.hpp"
#include "course/course_commands.hpp"
#include "course/mutants/results.hpp"
#include "course/mutants/suite.hpp"
#include "course/mutants/tree.hpp"

namespace texel::tools {
namespace {

namespace fs = std::filesystem;

/// The limit of the whole course, in per cent.
constexpr double kWanted = 95;

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
                                   const MutantsOptions& options) {
  const std::vector<std::string> names = chosen_names(options.only);
  std::vector<std::string> known;
  for (const course::Mutant& mutant : mutants) known.push_back(mutant.name);
  for (const std::string& name : names) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    const std::string near = nearest(name, known);
    throw Error::usage(
        fmt::format("there is no mutant '{}'", name),
        near.empty() ? "the catalogue is tests/mutants" : fmt::format("did you mean '{}'?", near));
  }
  std::vector<course::Mutant> wrong;
  std::size_t place = 0;
  for (const course::Mutant& mutant : mutants)
    if (!mutant.is_right &&
        (names.empty() ? place++ % options.every == 0
                       : std::find(names.begin(), names.end(), mutant.name) != names.end()))
      wrong.push_back(mutant);
  return wrong;
}

void say(const std::string& line) {
  fmt::print("{}\n", line);
  flush_output();  // a log shows each as it ends
}

/// Makes mutants together and asks the tests. Returns what became of each.
std::vector<MutantResult> try_mutants(const Tree& tree, const std::string& state, const Suite& suite,
                                      const std::vector<course::Mutant>& mutants) {
  const Stopwatch stopwatch;
  MutantResult result;
  result.tree = state;
  try {
    std::deque<AppliedMutant> applied;
    std::vector<std::string> files;
    for (const course::Mutant& mutant : mutants) {
      applied.emplace_back(tree, mutant);
      files.push_back(mutant.file);
    }
    const Verdict verdict = suite.judge(files, mutants.front().name);
    result.fate = !verdict.builds ? Fate::broken : verdict.caught_by.empty() ? Fate::survived : Fate::caught;
    result.by = verdict.caught_by;
    if (!verdict.builds) result.by = {"it does not compile"};
  } catch (const Error& error) {
    result.by = {error.what()};
  }
  result.seconds = stopwatch.milliseconds() / 1000 / static_cast<double>(mutants.size());
  std::vector<MutantResult> results(mutants.size(), result);
  for (std::size_t i = 0; i < mutants.size(); ++i) results[i].mutant = mutants[i];
  return results;
}

std::string outcome(const MutantResult& result) {
  const std::string by = fmt::format("{}", fmt::join(result.by, "; "));
  switch (result.fate) {
    case Fate::caught:
      return "caught by " + by;
    case Fate::survived:
      return result.mutant.survives.empty() ? "SURVIVED" : "survived, as the catalogue expects";
    case Fate::broken:
      break;
  }
  return "BROKEN: " + by;
}

/// Where the results of earlier calls stand, with those of this one in place of what they were.
class Record {
 public:
  Record(fs::path store, fs::path report, const std::vector<course::Mutant>& catalogue)
      : store_(std::move(store)), report_(std::move(report)), catalogue_(catalogue) {}

  /// Takes up what earlier calls found.
  void read() { results_ = read_report(store_, catalogue_); }

  /// What is known of a mutant in a tree of this state, or null.
  [[nodiscard]] const MutantResult* find(const std::string& name, const std::string& state) const {
    const auto found = std::find_if(results_.begin(), results_.end(), [&](const MutantResult& result) {
      return result.mutant.name == name && result.tree == state;
    });
    return found == results_.end() ? nullptr : &*found;
  }

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
    const auto wrong = static_cast<std::size_t>(
        std::count_if(catalogue_.begin(), catalogue_.end(), [](const auto& one) { return !one.is_right; }));
    write_report(store_, results_, wrong);
    if (!report_.empty()) write_report(report_, results_, wrong);
  }

 private:
  fs::path store_, report_;
  const std::vector<course::Mutant>& catalogue_;
  std::vector<MutantResult> results_;
};

void say_survivors(const std::vector<MutantResult>& results) {
  for (const MutantResult& result : results)
    if (result.fate == Fate::survived && !result.mutant.is_right)
      say(fmt::format(
          "survived: {} ({}): {}", result.mutant.name, result.mutant.file,
          result.mutant.survives.empty() ? "the catalogue gives no reason" : result.mutant.survives));
}

/// Says which mutants were caught although no test can notice them: the catalogue's reason is wrong, or the
/// test notices more than behaviour. Returns whether there is one.
bool say_impossible(const std::vector<MutantResult>& results) {
  bool any = false;
  for (const MutantResult& result : results) {
    if (result.fate != Fate::caught || result.mutant.survives.empty()) continue;
    any = true;
    say(fmt::format("caught by {}: {} ({}), of which the catalogue says: {}", fmt::join(result.by, "; "),
                    result.mutant.name, result.mutant.file, result.mutant.survives));
  }
  return any;
}

/// Makes all changes that change nothing, together, unless that was done in this tree. Throws Error (exit 3)
/// when tests notice them: those would notice anything.
void check_unchanged(const Tree& tree, const std::string& state, const Suite& suite,
                     const std::vector<course::Mutant>& catalogue, Record& record) {
  std::vector<course::Mutant> unchanged;
  bool is_known = true;
  for (const course::Mutant& mutant : catalogue) {
    if (!mutant.is_right) continue;
    unchanged.push_back(mutant);
    const MutantResult* known = record.find(mutant.name, state);
    is_known &= known != nullptr && known->fate == Fate::survived;
  }
  if (is_known) return;
  say(fmt::format("making {} changes that change nothing", unchanged.size()));
  std::string names;
  for (const MutantResult& result : try_mutants(tree, state, suite, unchanged)) {
    record.add(result);
    names += (names.empty() ? "" : ", ") + result.mutant.name;
  }
  const MutantResult* first = record.find(unchanged.front().name, state);
  if (first->fate == Fate::survived) return;
  throw Error::failed(
      fmt::format("what changes nothing ({}) is noticed: {}", names, fmt::join(first->by, "; ")), {},
      "tests of sources, build or documents need the label tree (TREE in tests/CMakeLists.txt)");
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
  const std::vector<course::Mutant> mutants = chosen(catalogue, options);

  const Tree tree(root, fs::absolute(work) / "tree");
  say(fmt::format("copying the tree into {} and building it", tree.folder().string()));
  tree.update();
  const std::string state = tree.state();
  Suite suite(tree.folder(), fs::absolute(work) / "logs");
  suite.prepare();
  say("running the tests once without a mutant");
  suite.measure(state);

  Record record(fs::absolute(work) / "results.json", options.report, catalogue);
  const bool is_whole = options.only.empty() && options.every == 1;
  if (options.resume || !is_whole) record.read();
  check_unchanged(tree, state, suite, catalogue, record);
  std::vector<MutantResult> results;
  const Stopwatch stopwatch;
  std::size_t made = 0;
  for (const course::Mutant& mutant : mutants) {
    const MutantResult* known = options.resume ? record.find(mutant.name, state) : nullptr;
    const bool is_known = known != nullptr && known->fate != Fate::broken;
    results.push_back(is_known ? *known : try_mutants(tree, state, suite, {mutant}).front());
    made += is_known ? 0 : 1;
    record.add(results.back());
    const double each = stopwatch.milliseconds() / 1000 / static_cast<double>(std::max<std::size_t>(made, 1));
    const std::size_t left = mutants.size() - results.size();
    say(fmt::format("{:3}/{} {:<32} {} ({}; {} left)", results.size(), mutants.size(), mutant.name,
                    outcome(results.back()), is_known ? "known" : duration_text(results.back().seconds),
                    duration_text(each * static_cast<double>(left))));
  }
  const Score total = score(results);
  say_survivors(results);
  const bool is_impossible = say_impossible(results);
  say(fmt::format("{}; {} survive for a reason; {} took {}", total.text(), total.explained, made,
                  duration_text(stopwatch.milliseconds() / 1000)));
  if (total.broken > 0)
    throw Error::failed(fmt::format("{} mutants do not apply or do not compile", total.broken), {},
                        "correct the catalogue in tests/mutants");
  return total.percent() >= kWanted && !is_impossible ? Exit::holds : Exit::differs;
}

}  // namespace texel::tools
