// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>

#include "core/error.hpp"
#include "core/json.hpp"
#include "judge/mistakes.hpp"

namespace texel::judge {
namespace {

/// A number; JSON has none that are not finite.
double number(const Json& value) {
  return value.is_null() ? std::nan("") : value.get<double>();
}

}  // namespace

std::string to_json(const std::vector<Mistake>& mistakes) {
  std::string text = "[\n";
  for (const Mistake& mistake : mistakes) {
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

std::vector<Mistake> parse_mistakes(const std::string& text, const std::string& file) {
  std::vector<Mistake> mistakes;
  try {
    for (const Json& one : parse_json(text)) {
      Mistake mistake{one.at("name"), one.at("step"), one.at("says"), {}};
      for (const auto& [name, place] : one.at("cases").items()) {
        Samples samples{place.value("refused", std::string()), 0, {}};
        samples.count = samples.refused.empty() ? place.at("count").get<std::size_t>() : 0;
        for (const Json& row : samples.refused.empty() ? place.at("samples") : Json::array()) {
          Samples::Sample sample{row.at(0), {}};
          for (std::size_t i = 1; i < row.size(); ++i) sample.values.push_back(number(row[i]));
          samples.samples.push_back(std::move(sample));
        }
        mistake.cases[name] = std::move(samples);
      }
      mistakes.push_back(std::move(mistake));
    }
  } catch (const Json::exception& error) {
    throw Error::failed(fmt::format("is not a list of mistakes: {}", error.what()), {file},
                        "copy the file from the course again");
  }
  return mistakes;
}

}  // namespace texel::judge
