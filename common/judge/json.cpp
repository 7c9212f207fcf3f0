// SPDX-License-Identifier: MIT
// The JSON of results and of known mistakes.
#include <fmt/format.h>

#include <cmath>

#include "core/error.hpp"
#include "core/json.hpp"
#include "course/batch.hpp"
#include "judge/mistakes.hpp"
#include "judge/results.hpp"

namespace texel::judge {

// How nlohmann's library writes a case, a step and a lab, and lists of them.

static void to_json(Json& json, const CaseResult& result) {
  json = {{"name", result.name},
          {"status", name_of(result.status)},
          {"view", name_of(result.view)},
          {"set", course::to_json(result.settings)},
          {"error", result.error},  // NaN becomes null
          {"unit", name_of(result.unit())},
          {"limit", result.limit},
          {"message", result.message},
          {"command", result.command},
          {"picture", result.picture},
          {"expected", result.reference}};
}

static void to_json(Json& json, const StepResult& step) {
  const CaseResult* telling = clearest_case(step);
  json = {{"id", step.id},
          {"status", name_of(step.status)},
          {"error", telling != nullptr ? Json(telling->error) : Json()},
          {"unit", telling != nullptr ? name_of(telling->unit()) : ""},
          {"limit", telling != nullptr ? telling->limit : 0},
          {"message", step.message},
          {"title", step.title},
          {"points", step.points},
          {"file", step.file},
          {"line", step.line},
          {"looks_like", step.mistake},
          {"looks_like_says", step.mistake_says},
          {"spoilt_by", step.spoilt_by},
          {"saved", step.saved},
          {"was_right", step.was_right},
          {"hints", step.hints},
          {"cases", step.cases}};
}

static void to_json(Json& json, const LabResult& lab) {
  json = {{"lab", lab.lab.folder}, {"title", lab.lab.title}, {"steps", lab.steps}};
}

namespace {

/// A number; JSON has none that are not finite.
double number(const Json& value) {
  return value.is_null() ? std::nan("") : value.get<double>();
}

CaseResult parse_case(const Json& json) {
  CaseResult one;
  one.name = json.at("name"), one.message = json.at("message"), one.command = json.at("command");
  one.status = status_called(json.at("status"));
  const auto view = course::find_view(json.at("view").get<std::string>());
  if (!view) throw Error::failed(fmt::format("there is no view {}", to_text(json.at("view"))));
  one.view = *view;
  one.settings = course::settings_from(json.at("set"));
  one.error = number(json.at("error"));
  one.limit = json.at("limit");
  one.picture = json.at("picture"), one.reference = json.at("expected");
  return one;
}

StepResult parse_step(const Json& json) {
  StepResult step;
  step.id = json.at("id"), step.title = json.at("title"), step.points = json.at("points");
  step.status = status_called(json.at("status")), step.message = json.at("message");
  step.mistake = json.at("looks_like"), step.mistake_says = json.at("looks_like_says");
  step.file = json.at("file"), step.line = json.at("line"), step.hints = json.at("hints");
  step.spoilt_by = json.at("spoilt_by");
  step.saved = json.at("saved"), step.was_right = json.at("was_right");
  for (const Json& one : json.at("cases")) step.cases.push_back(parse_case(one));
  return step;
}

}  // namespace

std::string to_json(const LabResult& lab) {
  return to_text(lab, 1);
}

std::string to_json(const std::vector<LabResult>& labs) {
  return to_text(labs, 1);
}

std::vector<StepResult> parse_steps(const std::string& json) {
  std::vector<StepResult> steps;
  try {
    const Json parsed = parse_json(json);
    for (const Json& lab : parsed.is_array() ? parsed : Json::array({parsed}))
      for (const Json& one : lab.at("steps")) steps.push_back(parse_step(one));
  } catch (const Json::exception& error) {
    throw Error::failed(fmt::format("the check did not print its JSON: {}", error.what()));
  }
  return steps;
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
