// SPDX-License-Identifier: MIT
#include "judge/mistakes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "core/error.hpp"
#include "image/load.hpp"
#include "mesh/ply.hpp"

namespace texel::judge {
namespace {

using course::Case;

/// How many values tell one mistake from another: these tell apart all 123 that the nine labs' public cases
/// show (`./run expected` counts them).
constexpr std::size_t kDifferent = 20, kEqual = 10;
/// The part of its samples that a mistake's picture must have: edges may lie a pixel beside.
constexpr double kPart = 0.9;
/// Digits that are kept: float32 has seven, the limits need four.
constexpr double kDigits = 1e5;

/// The values of all pixels or vertices of a file.
struct Values {
  std::size_t count = 0, each = 0;
  std::vector<double> all;

  [[nodiscard]] std::span<const double> at(std::size_t index) const {
    return std::span(all).subspan(index * each, each);
  }
};

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
  for (std::size_t i = 0; i < mesh.vertex_count(); ++i) {
    const auto add = [&](const auto& vectors) {
      if (!vectors.empty())
        for (int c = 0; c < vectors[i].length(); ++c) values.all.push_back(vectors[i][c]);
    };
    add(mesh.positions), add(mesh.normals), add(mesh.texcoords), add(mesh.tangents);
  }
  values.each = values.count > 0 ? values.all.size() / values.count : 0;
  return values;
}

/// Of bytes that may be anything; nothing when they are no picture of the case.
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

/// How far two values of the case may be apart: its limit, of directions as the length of the chord.
double tolerance(const Case& of) {
  const double limit =
      unit_of(of.view) == course::Unit::degrees ? of.limit * std::numbers::pi / 180 : of.limit;
  return std::max(limit, 2 / kDigits);
}

bool are_same(std::span<const double> a, std::span<const double> b, double most) {
  for (std::size_t i = 0; i < a.size(); ++i)
    if (std::isfinite(a[i]) != std::isfinite(b[i]) || (std::isfinite(a[i]) && std::abs(a[i] - b[i]) > most))
      return false;
  return true;
}

/// So many of the indices: one of each of as many equal parts, and not always its middle, since then samples
/// of a picture could lie below each other in one column.
void spread(const Values& of, const std::vector<std::size_t>& indices, std::size_t count, Samples& samples) {
  count = std::min(count, indices.size());
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t begin = i * indices.size() / count, end = (i + 1) * indices.size() / count;
    const double within = std::fmod(static_cast<double>(i) * std::numbers::phi, 1);
    const std::size_t index =
        indices[begin + static_cast<std::size_t>(within * static_cast<double>(end - begin))];
    Samples::Sample sample{index, {}};
    for (const double value : of.at(index)) sample.values.push_back(std::round(value * kDigits) / kDigits);
    samples.samples.push_back(std::move(sample));
  }
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
  if (!samples.refused.empty() || !failed.refused.empty()) return samples.refused == failed.refused ? 1 : 0;
  const Values& values = failed.values;
  if (values.count == 0 || values.count != samples.count) return 0;
  std::size_t same = 0;
  for (const Samples::Sample& sample : samples.samples)
    if (sample.index < values.count && sample.values.size() == values.each &&
        are_same(sample.values, values.at(sample.index), tolerance(*failed.of)))
      ++same;
  return static_cast<double>(same) / static_cast<double>(samples.samples.size());
}

}  // namespace

Samples sampled(const Case& of, std::string_view reference_file, std::string_view wrong_file) {
  const Values reference = parse_values(of, reference_file), wrong = parse_values(of, wrong_file);
  Samples samples{{}, wrong.count, {}};
  if (wrong.count == 0) return {};
  std::vector<std::size_t> different, equal;
  for (std::size_t i = 0; i < wrong.count; ++i) {
    const bool is_equal = wrong.each == reference.each && i < reference.count &&
                          are_same(wrong.at(i), reference.at(i), tolerance(of));
    (is_equal ? equal : different).push_back(i);
  }
  if (different.empty() && wrong.count == reference.count) return {};
  spread(wrong, different, kDifferent, samples);
  spread(wrong, equal, kEqual, samples);
  return samples;
}

const Mistake* recognize(const std::vector<Mistake>& mistakes, const LabPlan& plan, const std::string& step,
                         const std::map<std::string, Failed>& failed) {
  std::vector<Read> read;
  for (const Case& of : plan.cases)
    if (const auto one = failed.find(of.name); one != failed.end())
      read.push_back({&of, one->second.refused, parse_values(of, one->second.picture)});
  const Mistake* best = nullptr;
  double most = 0;
  for (const Mistake& mistake : mistakes) {
    if (mistake.step != step) continue;
    double least = 1, sum = 0;
    for (const Read& one : read) {
      const auto samples = mistake.cases.find(one.of->name);
      const double part = samples == mistake.cases.end() ? 0 : share_of_samples(samples->second, one);
      least = std::min(least, part);
      sum += part;
    }
    // A mistake that would have spoilt other cases too is another one.
    const double fit = mistake.cases.empty() ? 0 : sum / static_cast<double>(mistake.cases.size());
    if (least >= kPart && fit >= kPart && fit > most) {
      best = &mistake;
      most = fit;
    }
  }
  return best;
}

}  // namespace texel::judge
