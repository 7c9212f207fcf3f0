// SPDX-License-Identifier: MIT
#include "results.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>

#include "app/measure.hpp"
#include "core/error.hpp"
#include "core/files.hpp"
#include "core/json.hpp"

namespace texel::commands {
namespace {

using Times = std::vector<double>;

/// Nearest rank.
double quantile(Times values, double q) {
  const auto rank = static_cast<std::ptrdiff_t>(std::lround(q * static_cast<double>(values.size() - 1)));
  std::nth_element(values.begin(), values.begin() + rank, values.end());
  return values[static_cast<std::size_t>(rank)];
}

double median(const Times& values) {
  return quantile(values, 0.5);
}

/// The figures that both the labs' output and our own report have.
BenchResult read_errors(const Json& json) {
  BenchResult result;
  json.at("lab").get_to(result.lab);
  json.at("parameter").get_to(result.parameter);
  json.at("method").get_to(result.method);
  json.at("case").get_to(result.case_name);
  json.at("truth").get_to(result.truth);
  json.at("unit").get_to(result.unit);
  json.at("mean").get_to(result.mean);
  json.at("rms").get_to(result.rms);
  json.at("p99").get_to(result.p99);
  json.at("max").get_to(result.max);
  json.at("pixels").get_to(result.pixels);
  json.at("non_finite").get_to(result.non_finite);
  json.at("bytes").get_to(result.bytes);
  return result;
}

/// Marks those that no other one beats. Costs count as equal within what they differ from round to round, at
/// least 3 %, errors within 2 %: so close to each other, neither is the better one.
void mark_front(std::vector<BenchResult*> results) {
  constexpr double kLeastSpread = 0.03, kSameError = 0.02;
  const auto beats = [](const BenchResult& a, const BenchResult& b) {
    if (a.truth != b.truth || a.non_finite > 0) return false;
    const double same_cost = std::max({kLeastSpread, a.cost->spread, b.cost->spread});
    const bool cheaper = a.cost->ratio < b.cost->ratio * (1 - same_cost);
    const bool dearer = a.cost->ratio > b.cost->ratio * (1 + same_cost);
    const bool better = a.error() < (1 - kSameError) * b.error();
    const bool worse = a.error() > (1 + kSameError) * b.error();
    return (cheaper && !worse) || (better && !dearer);
  };
  for (BenchResult* result : results)
    result->pareto = result->cost && result->non_finite == 0 &&
                     std::none_of(results.begin(), results.end(),
                                  [&](const BenchResult* other) { return beats(*other, *result); });
}

/// The results of one case, from the raw times of the lab.
void add_costs(std::vector<BenchResult*> results, const std::vector<Json>& raw) {
  std::vector<Times> frames;
  for (const Json& json : raw) frames.push_back(json.at("frame_ns").get<Times>());
  if (frames.front().empty()) return;
  for (const Times& times : frames)
    if (times.size() != frames.front().size())
      throw Error::failed(fmt::format("case '{}' has not the same number of rounds for each method",
                                      results.front()->case_name));
  const auto cheapest = std::min_element(
      frames.begin(), frames.end(), [](const Times& a, const Times& b) { return median(a) < median(b); });
  for (std::size_t i = 0; i < results.size(); ++i) {
    Times ratios;
    for (std::size_t round = 0; round < cheapest->size(); ++round)
      ratios.push_back(frames[i].at(round) / (*cheapest)[round]);
    BenchResult::Cost cost;
    cost.ns = median(frames[i]);
    cost.ratio = median(ratios);
    cost.spread = (quantile(ratios, 0.75) - quantile(ratios, 0.25)) / (2 * cost.ratio);
    if (raw[i].contains("prepare_ns")) {
      cost.prepare_ns = median(raw[i].at("prepare_ns").get<Times>());
      raw[i].at("prepare_of").get_to(cost.prepare_of);
    }
    results[i]->cost = cost;
  }
}

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> parts;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t comma = std::min(text.find(", ", at), text.size());
    parts.push_back(text.substr(at, comma - at));
    at = comma + 2;
  }
  return parts;
}

std::optional<double> as_number(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

Json parse_file(const std::filesystem::path& file) {
  try {
    return parse_json(read_file(file));
  } catch (const Json::exception& error) {
    throw Error::failed(error.what(), {file.string()});
  }
}

}  // namespace

std::vector<std::string> BenchResult::parameters() const {
  return split(parameter);
}

std::vector<std::string> BenchResult::values() const {
  return split(method);
}

double BenchResult::error() const {
  return app::ranks_by_rms(unit) ? rms : mean;
}

const char* BenchResult::error_name() const {
  return app::ranks_by_rms(unit) ? "rms" : "mean";
}

BenchReport read_lab_output(const std::filesystem::path& file, const course::Lab& lab) {
  const Json json = parse_file(file);
  try {
    BenchReport report{json.at("renderer").get<std::string>(), {}};
    for (const Json& raw : json.at("results")) report.results.push_back(read_errors(raw));
    for (std::size_t first = 0, end = 0; first < report.results.size(); first = end) {
      std::vector<BenchResult*> results;
      std::vector<Json> raw;
      for (; end < report.results.size() && report.results[end].case_name == report.results[first].case_name;
           ++end) {
        results.push_back(&report.results[end]);
        raw.push_back(json.at("results").at(end));
      }
      add_costs(results, raw);
      const auto bench = std::find_if(lab.bench.begin(), lab.bench.end(), [&](const course::BenchCase& b) {
        return b.name == results.front()->case_name;
      });
      const int number = bench == lab.bench.end() ? -1 : number_of(*bench);
      std::map<std::string, std::vector<BenchResult*>> rivals;  // by the number's value
      for (BenchResult* result : results)
        rivals[number < 0 ? "" : result->values()[static_cast<std::size_t>(number)]].push_back(result);
      for (const auto& [value, group] : rivals) mark_front(group);
    }
    return report;
  } catch (const Json::exception& error) {
    throw Error::failed(error.what(), {file.string()});
  }
}

std::vector<BenchResult> over_all_cases(const course::Lab& lab, const std::vector<BenchResult>& results) {
  // By truth and parameter, in the order of the first case.
  std::vector<std::pair<std::string, std::vector<const BenchResult*>>> groups;
  for (const course::BenchCase& bench : lab.bench) {
    if (number_of(bench) >= 0) continue;
    for (const BenchResult& result : results) {
      if (result.lab != lab.folder || result.case_name != bench.name || !result.cost) continue;
      const std::string key = result.truth + "\n" + result.parameter;
      auto group = std::find_if(groups.begin(), groups.end(), [&](const auto& g) { return g.first == key; });
      if (group == groups.end()) group = groups.insert(groups.end(), {key, {}});
      group->second.push_back(&result);
    }
  }
  std::vector<BenchResult> sums;
  for (const auto& [key, members] : groups) {
    std::map<std::string, int> cases;
    for (const BenchResult* member : members) ++cases[member->case_name];
    if (cases.size() < 2) continue;
    std::vector<BenchResult> group;
    for (const BenchResult* first : members) {
      std::vector<const BenchResult*> same;
      for (const BenchResult* other : members)
        if (other->method == first->method) same.push_back(other);
      if (same.size() != cases.size() || same.front() != first) continue;
      BenchResult sum = *first;
      sum.case_name = kAllCases;
      sum.mean = sum.rms = sum.p99 = sum.max = 0;
      sum.pixels = sum.non_finite = sum.bytes = 0;
      sum.cost = BenchResult::Cost{};
      const auto count = static_cast<double>(same.size());
      double log_ratio = 0;
      for (const BenchResult* one : same) {
        sum.mean += one->mean / count;
        sum.rms += one->rms * one->rms / count;
        sum.p99 = std::max(sum.p99, one->p99);
        sum.max = std::max(sum.max, one->max);
        sum.pixels += one->pixels;
        sum.non_finite += one->non_finite;
        sum.bytes = std::max(sum.bytes, one->bytes);
        sum.cost->ns += one->cost->ns / count;
        sum.cost->spread = std::max(sum.cost->spread, one->cost->spread);
        log_ratio += std::log(one->cost->ratio) / count;
      }
      sum.rms = std::sqrt(sum.rms);
      sum.cost->ratio = std::exp(log_ratio);
      group.push_back(std::move(sum));
    }
    // The cheapest over all cases is the measure of the others.
    double least = group.empty() ? 1 : group.front().cost->ratio;
    for (const BenchResult& sum : group) least = std::min(least, sum.cost->ratio);
    std::vector<BenchResult*> pointers;
    for (BenchResult& sum : group) {
      sum.cost->ratio /= least;
      pointers.push_back(&sum);
    }
    mark_front(pointers);
    sums.insert(sums.end(), group.begin(), group.end());
  }
  return sums;
}

int number_of(const course::BenchCase& bench) {
  for (std::size_t i = 0; i < bench.variations.size(); ++i) {
    const std::vector<std::string>& values = bench.variations[i].values;
    if (values.size() >= 3 && std::all_of(values.begin(), values.end(), as_number))
      return static_cast<int>(i);
  }
  return -1;
}

std::vector<Slope> slopes(const course::BenchCase& bench, const std::vector<BenchResult>& results) {
  const int number = number_of(bench);
  if (number < 0) return {};
  std::vector<std::pair<std::string, std::vector<std::pair<double, double>>>> series;
  for (const BenchResult& result : results) {
    if (result.case_name != bench.name || result.error() <= 0) continue;
    std::vector<std::string> values = result.values();
    const double x = *as_number(values[static_cast<std::size_t>(number)]);
    values.erase(values.begin() + number);
    const std::string name = fmt::format("{}", fmt::join(values, ", "));
    auto found = std::find_if(series.begin(), series.end(), [&](const auto& s) { return s.first == name; });
    if (found == series.end()) found = series.insert(series.end(), {name, {}});
    if (x > 0) found->second.emplace_back(std::log(x), std::log(result.error()));
  }
  std::vector<Slope> lines;
  for (const auto& [name, points] : series) {
    if (points.size() < 3) continue;
    double x = 0, y = 0, xx = 0, xy = 0;
    for (const auto& [px, py] : points) x += px, y += py, xx += px * px, xy += px * py;
    const auto count = static_cast<double>(points.size());
    lines.push_back({name, bench.variations[static_cast<std::size_t>(number)].parameter,
                     (count * xy - x * y) / (count * xx - x * x)});
  }
  return lines;
}

std::string to_json(const BenchReport& report) {
  Json json = {{"renderer", report.renderer}, {"results", Json::array()}};
  for (const BenchResult& r : report.results) {
    const auto cost = [&](double value) { return r.cost ? Json(value) : Json(); };
    const BenchResult::Cost c = r.cost.value_or(BenchResult::Cost{});
    Json result = {{"lab", r.lab},
                   {"parameter", r.parameter},
                   {"method", r.method},
                   {"case", r.case_name},
                   {"truth", r.truth},
                   {"unit", r.unit},
                   {"mean", r.mean},
                   {"rms", r.rms},
                   {"p99", r.p99},
                   {"max", r.max},
                   {"pixels", r.pixels},
                   {"non_finite", r.non_finite},
                   {"cost_ns", cost(c.ns)},
                   {"cost_ratio", cost(c.ratio)},
                   {"cost_spread", cost(c.spread)},
                   {"bytes", r.bytes},
                   {"pareto", r.cost ? Json(r.pareto) : Json()}};
    if (c.prepare_ns) {
      result["prepare_ns"] = *c.prepare_ns;
      result["prepare_of"] = c.prepare_of;
    }
    json["results"].push_back(std::move(result));
  }
  return to_text(json, 1) + "\n";
}

BenchReport read_report_json(const std::filesystem::path& file) {
  const Json json = parse_file(file);
  try {
    BenchReport report{json.at("renderer").get<std::string>(), {}};
    for (const Json& j : json.at("results")) {
      BenchResult result = read_errors(j);
      if (!j.at("cost_ns").is_null()) {
        result.cost = {j.at("cost_ns"), j.at("cost_ratio"), j.at("cost_spread"), {}, {}};
        if (j.contains("prepare_ns")) {
          result.cost->prepare_ns = j.at("prepare_ns").get<double>();
          result.cost->prepare_of = j.at("prepare_of");
        }
        result.pareto = j.at("pareto");
      }
      report.results.push_back(std::move(result));
    }
    return report;
  } catch (const Json::exception& error) {
    throw Error::failed(error.what(), {file.string()}, "write the file with texel bench --json");
  }
}

std::vector<std::string> differences(const BenchReport& then, const BenchReport& now,
                                     const std::vector<course::Lab>& labs) {
  constexpr double kPart = 0.05, kUnits = 1e-5;  // float32 rounds directions to a few 1e-6 degrees
  std::vector<std::string> lines;
  const auto is_drivers = [&](const BenchResult& result) {
    return std::any_of(labs.begin(), labs.end(), [&](const course::Lab& lab) {
      return lab.folder == result.lab &&
             std::count(lab.driver_methods.begin(), lab.driver_methods.end(), result.method) > 0;
    });
  };
  for (const BenchResult& result : now.results) {
    if (now.renderer != then.renderer && is_drivers(result)) continue;
    const std::string name = fmt::format("lab {}, {}, {}", result.lab, result.case_name, result.method);
    const auto old = std::find_if(then.results.begin(), then.results.end(), [&](const BenchResult& r) {
      return r.lab == result.lab && r.case_name == result.case_name && r.method == result.method;
    });
    if (old == then.results.end()) {
      lines.push_back(name + ": is missing in the report");
    } else if (const double apart = std::abs(result.error() - old->error());
               apart > kUnits && apart > kPart * old->error()) {
      lines.push_back(fmt::format("{}: {} error {:.4g}, not {:.4g} {}", name, result.error_name(),
                                  result.error(), old->error(), result.unit));
    } else if ((result.non_finite > 0) != (old->non_finite > 0)) {
      lines.push_back(
          fmt::format("{}: {} pixels are not finite, not {}", name, result.non_finite, old->non_finite));
    }
  }
  return lines;
}

}  // namespace texel::commands
