// SPDX-License-Identifier: MIT
#include "material/mistake_samples.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/json.hpp"

namespace texel::material {
namespace {

using judge::Samples;
using judge::Values;

/// How many values tell one mistake from another: these tell apart all 123 that the nine labs' public cases
/// show (`./run expected` counts them).
constexpr std::size_t kDifferent = 20, kEqual = 10;

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
    for (const double value : of.at(index))
      sample.values.push_back(std::round(value * judge::kSampleDigits) / judge::kSampleDigits);
    samples.samples.push_back(std::move(sample));
  }
}

}  // namespace

Samples sampled(const course::Case& of, std::string_view reference_file, std::string_view wrong_file) {
  const Values reference = judge::parse_values(of, reference_file),
               wrong = judge::parse_values(of, wrong_file);
  Samples samples{{}, wrong.count, {}};
  if (wrong.count == 0) return {};
  std::vector<std::size_t> different, equal;
  for (std::size_t i = 0; i < wrong.count; ++i) {
    const bool is_equal = wrong.each == reference.each && i < reference.count &&
                          judge::are_same(wrong.at(i), reference.at(i), judge::tolerance(of));
    (is_equal ? equal : different).push_back(i);
  }
  if (different.empty() && wrong.count == reference.count) return {};
  spread(wrong, different, kDifferent, samples);
  spread(wrong, equal, kEqual, samples);
  return samples;
}

std::string to_json(const std::vector<judge::Mistake>& mistakes) {
  std::string text = "[\n";
  for (const judge::Mistake& mistake : mistakes) {
    Json one{{"name", mistake.name}, {"step", mistake.step}, {"says", mistake.says}};
    for (const auto& [name, samples] : mistake.cases) {
      Json& place = one["cases"][name];
      if (!samples.refused.empty()) {
        place["refused"] = samples.refused;
        continue;
      }
      place["count"] = samples.count;
      for (const Samples::Sample& sample : samples.samples) {
        Json values = {sample.index};
        for (const double value : sample.values) values.push_back(value);  // NaN becomes null
        place["samples"].push_back(values);
      }
    }
    text += to_text(one) + (&mistake == &mistakes.back() ? "\n" : ",\n");
  }
  return text + "]\n";
}

}  // namespace texel::material
