// SPDX-License-Identifier: MIT
#include "bench/bench.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "app/settings.hpp"
#include "check/check.hpp"
#include "core/error.hpp"
#include "core/files.hpp"
#include "core/json.hpp"
#include "core/stopwatch.hpp"
#include "course/batch.hpp"
#include "gl/objects.hpp"

#if __has_include(<valgrind/callgrind.h>)
#include <valgrind/callgrind.h>
#else
#define CALLGRIND_START_INSTRUMENTATION
#define CALLGRIND_STOP_INSTRUMENTATION
#define CALLGRIND_DUMP_STATS
#endif

namespace texel::bench {
namespace {

/// Each combination of the values that vary; of a choice without values, all that it has. The first parameter
/// changes slowest.
std::vector<app::Settings> combinations(const BenchCase& one, params::Set& parameters) {
  std::vector<app::Settings> all(1);
  for (const auto& [name, listed] : one.variations) {
    std::vector<std::string> values = listed;
    if (values.empty())
      for (const params::Item& item : parameters.at(name).items) values.emplace_back(item.name);
    if (values.empty()) throw Error::usage(fmt::format("'{}' is not a choice: list its values", name));
    std::vector<app::Settings> longer;
    for (const app::Settings& variant : all)
      for (const std::string& value : values) {
        longer.push_back(variant);
        longer.back().push_back({name, value});
      }
    all = std::move(longer);
  }
  return all;
}

std::string joined(const app::Settings& values, bool names) {
  std::string text;
  for (const auto& [name, value] : values) text += (text.empty() ? "" : ", ") + (names ? name : value);
  return text;
}

/// What varies has no place in an entry of --batch, and all else of a case is one.
course::Case parse_entry(const Json& json) {
  return course::parse_batch(to_text(Json::array({json}))).front();
}

BenchCase parse_case(Json json) {
  const Json vary = json.at("vary");
  if (!vary.is_object() || vary.empty()) throw Error::usage("'vary' must be an object {parameter: [values]}");
  json["name"] = json.at("case"), json["size"] = json.value("size", "256x256");
  json.erase("case"), json.erase("vary");
  BenchCase one{parse_entry(json), {}};
  one.name = json["name"];
  for (const auto& [parameter, values] : vary.items()) {
    if (!values.is_array()) throw Error::usage(fmt::format("the values of '{}' must be a list", parameter));
    Variation variation{parameter, {}};
    for (const Json& value : values) {
      const Json entry = {{"name", parameter}, {"set", {{parameter, value}}}};
      variation.values.push_back(parse_entry(entry).settings.front().value);
    }
    one.variations.push_back(std::move(variation));
  }
  return one;
}

class Bench {
 public:
  Bench(app::Canvas& canvas, app::AnyLab& lab) : canvas_(canvas), lab_(lab), start_(lab.parameters()) {}

  /// What a frame of each combination of the case executes: under callgrind two dumps for each, in their
  /// order.
  void count(const BenchCase& c) {
    const auto draw = [&] {
      canvas_.draw(app::View::color, app::pixels(c.size), 1);
      glFinish();
    };
    for (const app::Settings& values : combinations(c, lab_.parameters())) {
      select(c, values);
      for (int frame = 0; frame < 2; ++frame) draw();  // then all is loaded
      for (int frame = 0; frame < 2; ++frame) {
        CALLGRIND_START_INSTRUMENTATION;
        draw();
        CALLGRIND_STOP_INSTRUMENTATION;
        CALLGRIND_DUMP_STATS;
      }
    }
  }

  /// One result for each combination of the case.
  std::vector<Json> run(const BenchCase& c, double seconds, bool errors) {
    const std::vector<app::Settings> variants = combinations(c, lab_.parameters());
    std::vector<Json> results;
    for (const app::Settings& values : variants) {
      select(c, values);
      Json& result = results.emplace_back(errors ? measured(c) : Json::object());
      result.update({{"case", c.name},
                     {"parameter", joined(values, true)},
                     {"method", joined(values, false)},
                     {"frame_ns", Json::array()}});
      if (const auto preparation = prepared()) result["prepare_of"] = preparation->element;
    }
    const Stopwatch stopwatch;
    constexpr std::size_t kFewest = 5, kMost = 50;
    for (std::size_t round = 0; seconds > 0 && round < kMost; ++round) {
      if (round >= kFewest && stopwatch.milliseconds() > 1000 * seconds) break;
      // Each round begins with another one: none is always the first.
      for (std::size_t i = 0; i < variants.size(); ++i) {
        const std::size_t next = (round + i) % variants.size();
        time(c, variants[next], results[next]);
      }
    }
    return results;
  }

 private:
  /// Nothing when the lab's methods differ only in the frame.
  std::optional<app::Preparation> prepared() {
    std::optional<app::Preparation> own = lab_.preparation(canvas_.assets());
    return own || lab_.answer() == nullptr ? own : lab_.answer()->preparation(canvas_.assets());
  }

  void select(const BenchCase& c, const app::Settings& values) {
    start_.set(c.settings);
    for (const auto& [name, value] : values) lab_.parameters().at(name).set(value);
  }

  /// The error of what is selected, and the bytes that it reads.
  Json measured(const BenchCase& c) {
    const gl::Record record = canvas_.record(app::View::error, app::pixels(c.size), 1);
    const app::ErrorFigures& figures = *canvas_.error_figures();
    if (figures.pixels == 0) throw Error::failed(fmt::format("case '{}': {}", c.name, figures.reason));
    long long bytes = record.index_bytes;
    for (const auto& use : record.attributes) bytes += use.bytes;
    for (const auto& use : record.textures) bytes += use.bytes;
    Json result = parse_json(lab_.answer()->report(lab_, figures));
    result["bytes"] = bytes;
    return result;
  }

  void time(const BenchCase& c, const app::Settings& values, Json& result) {
    select(c, values);
    result["frame_ns"].push_back(frame_nanoseconds(canvas_, app::pixels(c.size)));
    if (const auto preparation = prepared()) {
      const Stopwatch stopwatch;
      preparation->work();
      result["prepare_ns"].push_back(stopwatch.milliseconds() * 1e6 /
                                     static_cast<double>(preparation->elements));
    }
  }

  app::Canvas& canvas_;
  app::AnyLab& lab_;
  app::KeptValues start_;
};

}  // namespace

double frame_nanoseconds(app::Canvas& canvas, glm::ivec2 size) {
  canvas.draw(app::View::color, size, 1);
  glFinish();
  if (check::is_software(canvas.context().renderer())) {
    const Stopwatch stopwatch;
    canvas.draw(app::View::color, size, 1);
    glFinish();
    return stopwatch.milliseconds() * 1e6;
  }
  const gl::Query query;
  glBeginQuery(GL_TIME_ELAPSED, query.id());
  canvas.draw(app::View::color, size, 1);
  glEndQuery(GL_TIME_ELAPSED);
  GLuint64 nanoseconds = 0;
  glGetQueryObjectui64v(query.id(), GL_QUERY_RESULT, &nanoseconds);
  return static_cast<double>(nanoseconds);
}

BenchList parse_bench(const std::string& list) {
  BenchList result;
  std::size_t number = 0;  // of the case that is read; 0 for the list
  try {
    const Json json = parse_json(list);
    result.seconds = json.value("seconds", result.seconds);
    result.errors = json.value("errors", true);
    result.counts = json.value("counts", false);
    for (const Json& one : json.at("cases")) ++number, result.cases.push_back(parse_case(one));
  } catch (const std::exception& error) {
    throw Error::usage(number == 0 ? error.what() : fmt::format("case {}: {}", number, error.what()));
  }
  return result;
}

BenchList read_bench(app::AnyLab& lab, const std::filesystem::path& file) {
  const std::string text = read_file(file);
  try {
    BenchList list = parse_bench(text);
    for (const BenchCase& one : list.cases) try {
        app::check_settings(lab.parameters(), one.settings);
        for (const app::Settings& values : combinations(one, lab.parameters()))
          app::check_settings(lab.parameters(), values);
      } catch (const Error& error) {
        throw Error::usage(fmt::format("case '{}': {}", one.name, error.what()));
      }
    return list;
  } catch (const Error& error) {
    throw Error::usage(fmt::format("{}: {}", file.string(), error.what()));
  }
}

std::string run_bench(app::Canvas& canvas, app::AnyLab& lab, const BenchList& list) {
  Bench bench(canvas, lab);
  Json output = {{"renderer", canvas.context().name()}, {"results", Json::array()}};
  std::size_t number = 0;
  for (const BenchCase& c : list.cases) {
    if (list.counts) {
      bench.count(c);
      continue;
    }
    fmt::print(stderr, "  case {} of {}: {}\n", ++number, list.cases.size(), c.name);
    for (Json& result : bench.run(c, list.seconds, list.errors))
      output["results"].push_back(std::move(result));
  }
  return to_text(output, 2) + "\n";
}

}  // namespace texel::bench
