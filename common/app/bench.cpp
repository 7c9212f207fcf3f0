// SPDX-License-Identifier: MIT
#include "bench.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "command_line.hpp"
#include "core/error.hpp"
#include "core/files.hpp"
#include "core/stopwatch.hpp"
#include "gl/frame_timer.hpp"
#include "settings.hpp"

namespace texel::app {
namespace {

using Json = nlohmann::ordered_json;

/// One combination of the values that vary.
struct Variant {
  Settings values;
  Json result = Json::object();
  std::vector<double> frame_ns, prepare_ns;
};

struct Case {
  std::string name;
  glm::ivec2 size;
  Settings set;
  std::vector<Variant> variants;
};

/// The values of one parameter that varies: those of the list, or all of a choice.
std::vector<std::string> values_of(const Json& list, const std::string& name, params::Set& parameters) {
  if (!list.is_array()) throw Error::usage(fmt::format("what '{}' varies over is a list", name));
  std::vector<std::string> values;
  for (const Json& value : list) {
    values.push_back(as_text(value));
    check_setting(parameters, name, values.back());
  }
  if (values.empty())
    for (const params::Item& item : parameters.at(name).items) values.emplace_back(item.name);
  if (values.empty()) throw Error::usage(fmt::format("'{}' is no choice: list its values", name));
  return values;
}

/// Every combination; the first parameter changes slowest.
std::vector<Variant> combinations(const Json& vary, params::Set& parameters) {
  if (!vary.is_object() || vary.empty()) throw Error::usage("'vary' is an object {parameter: [values]}");
  std::vector<Variant> all(1);
  for (const auto& [name, list] : vary.items()) {
    std::vector<Variant> longer;
    for (const Variant& variant : all)
      for (const std::string& value : values_of(list, name, parameters)) {
        longer.push_back(variant);
        longer.back().values.emplace_back(name, value);
      }
    all = std::move(longer);
  }
  return all;
}

Case parse_case(const Json& json, params::Set& parameters) {
  for (const auto& [key, value] : json.items())
    if (key != "case" && key != "size" && key != "set" && key != "vary")
      throw Error::usage(fmt::format("there is no key '{}'", key), "the keys are case, size, set and vary");
  return {json.at("case").get<std::string>(), parse_size(json.value("size", std::string("256x256"))),
          read_settings(json, "set", parameters), combinations(json.at("vary"), parameters)};
}

std::vector<Case> parse_cases(const Json& json, params::Set& parameters) {
  std::vector<Case> cases;
  for (const Json& item : json.at("cases")) try {
      cases.push_back(parse_case(item, parameters));
    } catch (const Error& error) {
      throw Error::usage(fmt::format("case {}: {}", cases.size() + 1, error.what()));
    }
  return cases;
}

std::string joined(const Settings& values, bool names) {
  std::string text;
  for (const auto& [name, value] : values) text += (text.empty() ? "" : ", ") + (names ? name : value);
  return text;
}

class Bench {
 public:
  Bench(Canvas& canvas, AnyLab& lab)
      : canvas_(canvas), lab_(lab), start_(lab.parameters()), timer_(canvas.context().renderer()) {}

  Json run(Case& c, double seconds) {
    for (Variant& variant : c.variants) measure(c, variant);
    const Stopwatch stopwatch;
    constexpr std::size_t kFewest = 5, kMost = 50;
    for (std::size_t round = 0; seconds > 0 && round < kMost; ++round) {
      if (round >= kFewest && stopwatch.milliseconds() > 1000 * seconds) break;
      // Each round begins with another one, so that none is always the first.
      for (std::size_t i = 0; i < c.variants.size(); ++i)
        time(c, c.variants[(round + i) % c.variants.size()]);
    }
    Json results = Json::array();
    for (Variant& variant : c.variants) {
      variant.result["frame_ns"] = variant.frame_ns;
      if (!variant.prepare_ns.empty()) variant.result["prepare_ns"] = variant.prepare_ns;
      results.push_back(std::move(variant.result));
    }
    return results;
  }

 private:
  void select(const Case& c, const Variant& variant) {
    start_.set(c.set);
    for (const auto& [name, value] : variant.values) lab_.parameters().at(name).set(value);
  }

  void measure(const Case& c, Variant& variant) {
    select(c, variant);
    const gl::Record record = canvas_.record(View::error, c.size, 1);
    const ErrorFigures& figures = *canvas_.error_figures();
    const Measure measure = *lab_.measure();
    long long bytes = 0;
    for (const auto& use : record.attributes) bytes += use.bytes;
    for (const auto& use : record.textures) bytes += use.bytes;
    variant.result = {{"lab", lab_.info().folder()},
                      {"case", c.name},
                      {"parameter", joined(variant.values, true)},
                      {"method", joined(variant.values, false)},
                      {"truth", measure.truth},
                      {"unit", name_of(measure.unit)},
                      {"mean", figures.mean},
                      {"rms", figures.rms},
                      {"p99", figures.p99},
                      {"max", figures.max},
                      {"pixels", figures.pixels},
                      {"non_finite", figures.non_finite},
                      {"bytes", bytes}};
    if (const auto preparation = lab_.preparation(canvas_.assets()))
      variant.result["prepare_of"] = preparation->element;
  }

  void time(const Case& c, Variant& variant) {
    select(c, variant);
    canvas_.draw(View::color, c.size, 1);  // loads what was dropped since the last round
    timer_.start();
    canvas_.draw(View::color, c.size, 1);
    variant.frame_ns.push_back(timer_.stop());
    if (const auto preparation = lab_.preparation(canvas_.assets())) {
      const Stopwatch stopwatch;
      preparation->work();
      variant.prepare_ns.push_back(stopwatch.milliseconds() * 1e6 /
                                   static_cast<double>(preparation->elements));
    }
  }

  Canvas& canvas_;
  AnyLab& lab_;
  StartValues start_;
  gl::FrameTimer timer_;
};

}  // namespace

std::string run_bench(Canvas& canvas, AnyLab& lab, const std::filesystem::path& file) {
  std::vector<Case> cases;
  double seconds = 0;
  try {
    const Json json = Json::parse(read_file(file));
    seconds = json.value("seconds", 2.0);
    cases = parse_cases(json, lab.parameters());
  } catch (const Json::exception& error) {
    throw Error::usage(fmt::format("{}: {}", file.string(), error.what()));
  } catch (const Error& error) {
    if (error.exit_code() == Exit::failed) throw;
    throw Error::usage(fmt::format("{}: {}", file.string(), error.what()));
  }
  Bench bench(canvas, lab);
  Json output = {{"renderer", canvas.context().renderer()}, {"results", Json::array()}};
  for (std::size_t i = 0; i < cases.size(); ++i) {
    fmt::print(stderr, "  case {} of {}: {}, {} methods\n", i + 1, cases.size(), cases[i].name,
               cases[i].variants.size());
    for (Json& result : bench.run(cases[i], seconds)) output["results"].push_back(std::move(result));
  }
  return output.dump(2) + "\n";
}

}  // namespace texel::app
