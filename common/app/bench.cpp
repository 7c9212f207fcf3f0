// SPDX-License-Identifier: MIT
#include "bench.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "command_line.hpp"
#include "core/error.hpp"
#include "core/files.hpp"
#include "core/stopwatch.hpp"
#include "gl/frame_timer.hpp"

namespace texel::app {
namespace {

using Json = nlohmann::ordered_json;

/// The values of one parameter that varies: those of the list, or all of a choice.
std::vector<std::string> values_of(const Json& list, const std::string& name, params::Set& parameters) {
  if (!list.is_array()) throw Error::usage(fmt::format("the values of '{}' must be a list", name));
  std::vector<std::string> values;
  for (const Json& value : list) {
    values.push_back(as_text(value));
    check_setting(parameters, name, values.back());
  }
  if (values.empty())
    for (const params::Item& item : parameters.at(name).items) values.emplace_back(item.name);
  if (values.empty()) throw Error::usage(fmt::format("'{}' is not a choice: list its values", name));
  return values;
}

/// Every combination; the first parameter changes slowest.
std::vector<Settings> combinations(const Json& vary, params::Set& parameters) {
  if (!vary.is_object() || vary.empty()) throw Error::usage("'vary' must be an object {parameter: [values]}");
  std::vector<Settings> all(1);
  for (const auto& [name, list] : vary.items()) {
    std::vector<Settings> longer;
    for (const Settings& variant : all)
      for (const std::string& value : values_of(list, name, parameters)) {
        longer.push_back(variant);
        longer.back().emplace_back(name, value);
      }
    all = std::move(longer);
  }
  return all;
}

BenchCase parse_case(const Json& json, params::Set& parameters) {
  for (const auto& [key, value] : json.items())
    if (key != "case" && key != "size" && key != "set" && key != "vary")
      throw Error::usage(fmt::format("there is no key '{}'", key), "the keys are case, size, set and vary");
  return {json.at("case").get<std::string>(), parse_size(json.value("size", std::string("256x256"))),
          read_settings(json, "set", parameters), combinations(json.at("vary"), parameters)};
}

std::vector<BenchCase> parse_cases(const Json& json, params::Set& parameters) {
  std::vector<BenchCase> cases;
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

/// What was measured of a combination.
struct Measured {
  const Settings& values;
  Json result = Json::object();
  std::vector<double> frame_ns, prepare_ns;
};

class Bench {
 public:
  Bench(Canvas& canvas, AnyLab& lab)
      : canvas_(canvas), lab_(lab), start_(lab.parameters()), timer_(canvas.context().renderer()) {}

  Json run(const BenchCase& c, double seconds) {
    std::vector<Measured> all;
    for (const Settings& values : c.variants) measure(c, all.emplace_back(Measured{values, {}, {}, {}}));
    const Stopwatch stopwatch;
    constexpr std::size_t kFewest = 5, kMost = 50;
    for (std::size_t round = 0; seconds > 0 && round < kMost; ++round) {
      if (round >= kFewest && stopwatch.milliseconds() > 1000 * seconds) break;
      // Each round begins with another one: none is always the first.
      for (std::size_t i = 0; i < all.size(); ++i) time(c, all[(round + i) % all.size()]);
    }
    Json results = Json::array();
    for (Measured& one : all) {
      one.result["frame_ns"] = one.frame_ns;
      if (!one.prepare_ns.empty()) one.result["prepare_ns"] = one.prepare_ns;
      results.push_back(std::move(one.result));
    }
    return results;
  }

 private:
  void select(const BenchCase& c, const Settings& values) {
    start_.set(c.set);
    for (const auto& [name, value] : values) lab_.parameters().at(name).set(value);
  }

  void measure(const BenchCase& c, Measured& one) {
    select(c, one.values);
    const gl::Record record = canvas_.record(View::error, c.size, 1);
    const ErrorFigures& figures = *canvas_.error_figures();
    const Measure measure = *lab_.measure();
    long long bytes = 0;
    for (const auto& use : record.attributes) bytes += use.bytes;
    for (const auto& use : record.textures) bytes += use.bytes;
    one.result = {{"lab", lab_.info().folder()},
                  {"case", c.name},
                  {"parameter", joined(one.values, true)},
                  {"method", joined(one.values, false)},
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
      one.result["prepare_of"] = preparation->element;
  }

  void time(const BenchCase& c, Measured& one) {
    select(c, one.values);
    canvas_.draw(View::color, c.size, 1);  // loads what was dropped since the last round
    timer_.start();
    canvas_.draw(View::color, c.size, 1);
    one.frame_ns.push_back(timer_.stop());
    if (const auto preparation = lab_.preparation(canvas_.assets())) {
      const Stopwatch stopwatch;
      preparation->work();
      one.prepare_ns.push_back(stopwatch.milliseconds() * 1e6 / static_cast<double>(preparation->elements));
    }
  }

  Canvas& canvas_;
  AnyLab& lab_;
  StartValues start_;
  gl::FrameTimer timer_;
};

}  // namespace

BenchPlan read_bench(AnyLab& lab, const std::filesystem::path& file) {
  try {
    const Json json = Json::parse(read_file(file));
    return {json.value("seconds", 2.0), parse_cases(json, lab.parameters())};
  } catch (const Json::exception& error) {
    throw Error::usage(fmt::format("{}: {}", file.string(), error.what()));
  } catch (const Error& error) {
    if (error.exit_code() == Exit::failed) throw;
    throw Error::usage(fmt::format("{}: {}", file.string(), error.what()));
  }
}

std::string run_bench(Canvas& canvas, AnyLab& lab, const BenchPlan& plan) {
  Bench bench(canvas, lab);
  Json output = {{"renderer", canvas.context().name()}, {"results", Json::array()}};
  std::size_t number = 0;
  for (const BenchCase& c : plan.cases) {
    fmt::print(stderr, "  case {} of {}: {}, {} methods\n", ++number, plan.cases.size(), c.name,
               c.variants.size());
    for (Json& result : bench.run(c, plan.seconds)) output["results"].push_back(std::move(result));
  }
  return output.dump(2) + "\n";
}

}  // namespace texel::app
