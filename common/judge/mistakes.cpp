// SPDX-License-Identifier: MIT
#include "judge/mistakes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "difference.hpp"
#include "image/load.hpp"
#include "mesh/ply.hpp"

namespace texel::judge {
namespace {

using course::Case;

/// The part of its samples that a mistake's picture must have: edges may lie a pixel beside.
constexpr double kPart = 0.9;

template <class Picture>
Values values_of(const Picture& picture) {
  Values values{static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height), 3, {}};
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x)
      for (int c = 0; c < 3; ++c) values.all.push_back(picture.at(x, y, std::min(c, picture.channels - 1)));
  return values;
}

Values values_of(const mesh::Mesh& mesh) {
  Values values{mesh.vertex_count(), 0, {}};
  for (std::size_t i = 0; i < mesh.vertex_count(); ++i)
    mesh::for_each_attribute(mesh, [&](const auto& vectors) {
      for (int c = 0; !vectors.empty() && c < vectors[i].length(); ++c) values.all.push_back(vectors[i][c]);
    });
  values.each = values.count > 0 ? values.all.size() / values.count : 0;
  return values;
}

/// A failed case, its picture read once for all mistakes that it is held against.
struct Read {
  const Case* of;
  std::string refused;
  Values values;
};

/// Which part of the samples the picture has; 0 for what is no picture of that size. What it refused is the
/// same or is not.
double share_of_samples(const Samples& samples, const Read& failed) {
  if (!samples.refused.empty() || !failed.refused.empty()) {
    const bool has_line = samples.refused.find(':') != std::string::npos;  // a file alone tells no cause
    return has_line && samples.refused == failed.refused ? 1 : 0;
  }
  const Values& values = failed.values;
  if (values.count == 0 || values.count != samples.count) return 0;
  std::size_t same = 0;
  for (const Samples::Sample& sample : samples.samples)
    if (sample.index < values.count && sample.values.size() == values.each &&
        are_same(sample.values, values.at(sample.index), tolerance(*failed.of)))
      ++same;
  return static_cast<double>(same) / static_cast<double>(samples.samples.size());
}

/// The mistake of the step that has most of what its cases show, all of them failed ones; of those that show
/// in `all` failed cases, or in some. What it says, by the name of each case that it shows in.
std::map<std::string, Seen> best_of(const std::vector<Mistake>& mistakes, const std::string& step,
                                    const std::vector<Read>& read, bool all) {
  std::map<std::string, Seen> best;
  double most = 0;
  for (const Mistake& mistake : mistakes) {
    if (mistake.step != step || mistake.cases.empty()) continue;
    double sum = 0;
    std::map<std::string, Seen> own;
    for (const Read& one : read) {
      const auto samples = mistake.cases.find(one.of->name);
      const double part = samples == mistake.cases.end() ? 0 : share_of_samples(samples->second, one);
      sum += part;
      if (part >= kPart) own[one.of->name] = {mistake.name, mistake.says};
    }
    // A mistake that would have spoilt other cases too is another one.
    const double fit = sum / static_cast<double>(mistake.cases.size());
    if (fit < kPart || own.empty() || (all && own.size() < read.size())) continue;
    if (own.size() > best.size() || (own.size() == best.size() && fit > most)) best = own, most = fit;
  }
  return best;
}

/// The sentence of the simplest of these differences; of two that are as simple both, of more none.
Seen said(const std::vector<Difference>& from, bool has_numbers, int below) {
  if (from.empty() || from.front().cost >= below) return {};
  const auto alike = std::ranges::count(from, from.front().cost, &Difference::cost);
  if (alike > 2) return {};
  return {{}, words(from[0], has_numbers) + (alike == 2 ? " Or: " + words(from[1], has_numbers) : "")};
}

}  // namespace

Values parse_values(const Case& of, std::string_view bytes) {
  if (bytes.empty()) return {};
  try {
    if (of.is_mesh()) return values_of(mesh::parse_ply(bytes, of.file));
    const auto [width, height] = of.size;
    if (of.view == course::View::color) return values_of(image::parse_png(bytes, of.file, width, height));
    const image::ImageF picture = image::parse_pfm(bytes, of.file);
    return picture.width == width && picture.height == height ? values_of(picture) : Values();
  } catch (const Error&) {
    return {};
  }
}

double tolerance(const Case& of) {
  const double limit =
      unit_of(of.view) == course::Unit::degrees ? of.limit * std::numbers::pi / 180 : of.limit;
  return std::max(limit, 2 / kSampleDigits);
}

bool are_same(std::span<const double> a, std::span<const double> b, double most) {
  for (std::size_t i = 0; i < a.size(); ++i)
    if (std::isfinite(a[i]) != std::isfinite(b[i]) || (std::isfinite(a[i]) && std::abs(a[i] - b[i]) > most))
      return false;
  return true;
}

std::map<std::string, Seen> explain(const std::vector<Mistake>& mistakes, const course::Lab& lab,
                                    const std::string& step, const std::map<std::string, Failed>& failed) {
  std::vector<Read> read;
  for (const Case& of : lab.cases)
    if (const auto one = failed.find(of.name); one != failed.end())
      read.push_back({&of, one->second.refused, parse_values(of, one->second.picture)});
  std::map<std::string, Seen> seen = best_of(mistakes, step, read, true);
  if (!seen.empty()) return seen;
  std::map<std::string, std::vector<Difference>> own, shared;
  for (const Read& one : read) own[one.of->name] = differences(*one.of, failed.at(one.of->name));
  const auto has = [](const std::vector<Difference>& list, const Difference& one) {
    return std::ranges::count(list, one.changes, &Difference::changes) > 0;
  };
  shared = own;
  for (auto& [name, list] : shared)
    std::erase_if(list, [&](const Difference& one) {
      return !std::all_of(own.begin(), own.end(), [&](const auto& other) { return has(other.second, one); });
    });
  // What holds in one case and not in all says so.
  const auto put = [&](const std::string& name, Seen one, bool is_of_all) {
    if (!is_of_all) one.says = fmt::format("In the case {}: {}", name, one.says);
    seen[name] = std::move(one);
  };
  const auto say = [&](const std::map<std::string, std::vector<Difference>>& lists, int below) {
    for (const auto& [name, list] : lists)
      if (const Seen one = said(list, !failed.at(name).is_secret, below);
          !one.says.empty() && !seen.contains(name))
        put(name, one, has(shared[name], list.front()));
  };
  say(shared, kPlain);
  if (!seen.empty()) return seen;
  // Two mistakes in one step: each case by itself. The catalogue names causes: only where each picture has
  // one or is explained by its values, and not where nothing is drawn, as by many mistakes.
  std::map<std::string, Seen> causes;
  std::vector<Read> left = read;
  while (!left.empty()) {
    std::map<std::string, Seen> known = best_of(mistakes, step, left, false);
    if (known.empty()) break;
    causes.merge(known);
    std::erase_if(left, [&](const Read& one) { return causes.contains(one.of->name); });
  }
  const bool are_causes = left.empty() && std::ranges::none_of(causes, [&](const auto& one) {
                            return std::ranges::count(own[one.first], Way::nothing, &Difference::way) > 0;
                          });
  if (are_causes)
    for (const auto& [name, one] : causes) put(name, one, false);
  for (const int below : {kPlain, kVague, kLast}) say(shared, below), say(own, below);
  if (seen.empty()) say(shared, kAnyCost), say(own, kAnyCost);
  return seen;
}

}  // namespace texel::judge
