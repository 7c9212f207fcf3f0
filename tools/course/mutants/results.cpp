// SPDX-License-Identifier: MIT
#include "course/mutants/results.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

#include "core/error.hpp"
#include "core/files.hpp"
#include "core/json.hpp"

namespace texel::tools {
namespace {

constexpr std::array<const char*, 3> kFates = {"caught", "survived", "broken"};

std::string json_text(const std::vector<MutantResult>& results) {
  const Score total = score(results);
  Json report = {{"mutants", total.all},   {"caught", total.caught},     {"explained", total.explained},
                 {"broken", total.broken}, {"percent", total.percent()}, {"results", Json::array()}};
  for (const MutantResult& result : results) {
    const course::Mutant& mutant = result.mutant;
    report["results"].push_back({{"name", mutant.name},
                                 {"file", mutant.file},
                                 {"step", mutant.step},
                                 {"says", mutant.says},
                                 {"fate", kFates[static_cast<std::size_t>(result.fate)]},
                                 {"by", result.by},
                                 {"survives", mutant.survives},
                                 {"changes_nothing", mutant.is_right},
                                 {"seconds", result.seconds},
                                 {"tree", result.tree},
                                 {"what", mutant.what},
                                 {"replaced_by", mutant.by}});
  }
  return to_text(report, 2) + "\n";
}

/// A text in a cell of a table.
std::string cell(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  for (std::size_t at = text.find('|'); at != std::string::npos; at = text.find('|', at + 2))
    text.replace(at, 1, "\\|");
  return text;
}

/// The results of one fate as a table with a title, or nothing.
std::string table(const std::vector<MutantResult>& results, Fate fate, const char* title,
                  const char* column) {
  std::string rows;
  for (const MutantResult& result : results)
    if (result.fate == fate && !result.mutant.is_right)
      rows += fmt::format("| {} | {} | {} | {} |\n", result.mutant.name, result.mutant.file,
                          cell(result.mutant.says),
                          cell(fate == Fate::survived ? result.mutant.survives
                                                      : fmt::format("{}", fmt::join(result.by, "; "))));
  if (rows.empty()) return {};
  return fmt::format("\n## {}\n\n| mutant | file | what it does wrong | {} |\n|---|---|---|---|\n{}", title,
                     column, rows);
}

std::string by_folder(const std::vector<MutantResult>& results) {
  std::map<std::string, Score> folders;
  for (const MutantResult& result : results)
    if (!result.mutant.is_right)
      folders[std::filesystem::path(result.mutant.file).parent_path().string()].add(result);
  std::string rows;
  for (const auto& [folder, score] : folders)
    rows += fmt::format("| {} | {} | {} | {} |\n", folder, score.all - score.broken, score.caught,
                        score.explained);
  return "\n## By folder\n\n| folder | mutants | caught | survive for a reason |\n|---|---|---|---|\n" + rows;
}

/// The tests without which mutants would have passed those that ran with them.
std::string by_test(const std::vector<MutantResult>& results) {
  std::map<std::string, std::pair<int, int>> tests;  // caught, and alone
  for (const MutantResult& result : results)
    if (result.fate == Fate::caught)
      for (const std::string& test : result.by) {
        ++tests[test].first;
        if (result.by.size() == 1) ++tests[test].second;
      }
  std::string rows;
  for (const auto& [test, count] : tests)
    if (count.second > 0) rows += fmt::format("| {} | {} | {} |\n", cell(test), count.second, count.first);
  if (rows.empty()) return {};
  return "\n## Tests that caught what no test beside them did\n\n| test | alone | in all "
         "|\n|---|---|---|\n" +
         rows;
}

/// What changes nothing: which tests would fail for any edit.
std::string unchanged(const std::vector<MutantResult>& results) {
  std::string lines;
  for (const MutantResult& result : results)
    if (result.mutant.is_right)
      lines += fmt::format(
          "- {} ({}): {}\n", result.mutant.name, result.mutant.file,
          result.is_false_alarm() ? fmt::format("CAUGHT by {}", fmt::join(result.by, "; ")) : "survived");
  return lines.empty() ? "" : "\n## Changes that change nothing\n\n" + lines;
}

std::string markdown(const std::vector<MutantResult>& results, std::size_t catalogue) {
  const Score total = score(results);
  std::set<std::string> trees;
  for (const MutantResult& result : results) trees.insert(result.tree);
  return "# Mutants\n\nWritten by `./run mutants`, which [CONTRIBUTING.md](../CONTRIBUTING.md#mutants) "
         "explains.\n\n" +
         fmt::format("{}; {} survive for a reason. {} {}\n", total.text(), total.explained,
                     total.all < catalogue
                         ? fmt::format("This is a sample: the catalogue has {} mutants.", catalogue)
                         : "These are all mutants of the catalogue.",
                     trees.size() > 1 ? "Not all are of one state of the tree." : "All are of one tree.") +
         by_folder(results) + unchanged(results) + table(results, Fate::broken, "Broken", "why") +
         table(results, Fate::survived, "Survivors", "why that is right") + by_test(results) +
         table(results, Fate::caught, "Caught", "by");
}

}  // namespace

double Score::percent() const {
  const std::size_t sound = all - broken;
  return sound == 0 ? 0 : 100.0 * static_cast<double>(caught) / static_cast<double>(sound);
}

std::string Score::text() const {
  // Rounded down: it never says 90 % if the limit of 90 % is missed.
  return fmt::format("{} of {} caught ({} %)", caught, all - broken, static_cast<int>(percent()));
}

void Score::add(const MutantResult& result) {
  if (result.mutant.is_right && result.fate != Fate::broken) return;
  ++all;
  if (result.fate == Fate::caught) ++caught;
  if (result.fate == Fate::broken) ++broken;
  if (result.fate == Fate::survived && !result.mutant.survives.empty()) ++explained;
}

Score score(const std::vector<MutantResult>& results) {
  Score total;
  for (const MutantResult& result : results) total.add(result);
  return total;
}

std::vector<MutantResult> read_report(const std::filesystem::path& file,
                                      const std::vector<course::Mutant>& mutants) {
  if (!std::filesystem::exists(file)) return {};
  std::vector<MutantResult> results;
  try {
    const Json report = parse_json(read_file(file));
    for (const Json& entry : report.at("results")) {
      const auto text = [&entry](const char* key) { return entry.at(key).get<std::string>(); };
      const auto mutant = std::find_if(mutants.begin(), mutants.end(), [&](const course::Mutant& m) {
        return m.name == text("name") && m.file == text("file") && m.what == text("what") &&
               m.by == text("replaced_by");
      });
      const auto fate = std::find(kFates.begin(), kFates.end(), text("fate"));
      if (mutant == mutants.end() || fate == kFates.end()) continue;
      results.push_back({*mutant, static_cast<Fate>(fate - kFates.begin()), entry.at("by"),
                         entry.at("seconds"), entry.at("tree")});
    }
  } catch (const Json::exception&) {
    throw Error::failed("is not a report of mutants", {file.string()}, "remove the file");
  }
  return results;
}

void write_report(const std::filesystem::path& file, const std::vector<MutantResult>& results,
                  std::size_t catalogue) {
  write_file(file, file.extension() == ".json" ? json_text(results) : markdown(results, catalogue));
}

}  // namespace texel::tools
