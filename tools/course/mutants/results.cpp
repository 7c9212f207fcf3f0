// SPDX-License-Identifier: MIT
#include "course/mutants/results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "core/files.hpp"

namespace texel::tools {
namespace {

using Json = nlohmann::ordered_json;

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
                                 {"seconds", result.seconds},
                                 {"what", mutant.what},
                                 {"replaced_by", mutant.by}});
  }
  return report.dump(2) + "\n";
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
    if (result.fate == fate)
      rows += fmt::format("| {} | {} | {} | {} |\n", result.mutant.name, result.mutant.file,
                          cell(result.mutant.says),
                          cell(fate == Fate::survived ? result.mutant.survives : result.by));
  if (rows.empty()) return {};
  return fmt::format("\n## {}\n\n| mutant | file | what it does wrong | {} |\n|---|---|---|---|\n{}", title,
                     column, rows);
}

std::string markdown(const std::vector<MutantResult>& results) {
  const Score total = score(results);
  return fmt::format("# Mutants\n\n{}; {} survive for a reason.\n", total.text(), total.explained) +
         table(results, Fate::broken, "Broken", "why") +
         table(results, Fate::survived, "Survivors", "why that is right") +
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

Score score(const std::vector<MutantResult>& results) {
  Score total;
  for (const MutantResult& result : results) {
    ++total.all;
    if (result.fate == Fate::caught) ++total.caught;
    if (result.fate == Fate::broken) ++total.broken;
    if (result.fate == Fate::survived && !result.mutant.survives.empty()) ++total.explained;
  }
  return total;
}

std::vector<MutantResult> read_report(const std::filesystem::path& file,
                                      const std::vector<course::Mutant>& mutants) {
  if (!std::filesystem::exists(file)) return {};
  std::vector<MutantResult> results;
  try {
    const Json report = Json::parse(read_file(file));
    for (const Json& entry : report.at("results")) {
      const auto text = [&entry](const char* key) { return entry.at(key).get<std::string>(); };
      const auto mutant = std::find_if(mutants.begin(), mutants.end(), [&](const course::Mutant& m) {
        return m.name == text("name") && m.file == text("file") && m.what == text("what") &&
               m.by == text("replaced_by");
      });
      const auto fate = std::find(kFates.begin(), kFates.end(), text("fate"));
      if (mutant == mutants.end() || fate == kFates.end()) continue;
      results.push_back(
          {*mutant, static_cast<Fate>(fate - kFates.begin()), entry.at("by"), entry.at("seconds")});
    }
  } catch (const Json::exception&) {
    throw Error::failed("is not a report of mutants", {file.string()}, "remove the file");
  }
  return results;
}

void write_report(const std::filesystem::path& file, const std::vector<MutantResult>& results) {
  write_file(file, file.extension() == ".json" ? json_text(results) : markdown(results));
}

}  // namespace texel::tools
