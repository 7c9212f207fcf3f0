// SPDX-License-Identifier: MIT
#include "app/reports.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>

#include "core/json.hpp"

namespace texel::app {
namespace {

using Type = params::Parameter::Type;

/// A parameter's default as JSON's own type.
Json initial(const params::Parameter& p) {
  if (p.type == Type::toggle) return p.initial() == "on";
  if (p.type == Type::integer || p.type == Type::number) return parse_json(p.initial());
  return p.initial();
}

}  // namespace

long long peak_resident_bytes() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<long long>(usage.ru_maxrss) * 1024;
}

std::string to_json(const Statistics& statistics) {
  const gl::Record& record = statistics.record;
  Json json;
  json["lab"] = statistics.lab;
  json["vertices"] = record.vertices;
  json["triangles"] = record.triangles;
  json["draw_calls"] = record.draw_calls;
  json["attributes"] = Json::array();
  for (const auto& use : record.attributes)
    json["attributes"].push_back({{"name", use.name}, {"bytes", use.bytes}});
  json["index_bytes"] = record.index_bytes;
  json["textures"] = Json::array();
  for (const auto& use : record.textures)
    json["textures"].push_back({{"name", use.name},
                                {"width", use.width},
                                {"height", use.height},
                                {"format", use.format},
                                {"bytes", use.bytes}});
  json["milliseconds"] = Json::object();
  for (const auto& [stage, time] : statistics.milliseconds) json["milliseconds"][stage] = time;
  json["peak_bytes"] = statistics.peak_bytes;
  json["notes"] = statistics.notes.facts;
  json["warnings"] = statistics.notes.warnings;
  for (const std::string& warning : record.warnings) json["warnings"].push_back(warning);
  json["renderer"] = statistics.renderer;
  json["version"] = statistics.version;
  json["drawn_by"] = statistics.drawn_by;
  return to_text(json, 2) + "\n";
}

std::string frame_times_as_text(std::vector<double> milliseconds, glm::ivec2 size) {
  std::sort(milliseconds.begin(), milliseconds.end());
  const auto quantile = [&](double q) {
    return milliseconds[static_cast<std::size_t>(q * static_cast<double>(milliseconds.size() - 1))];
  };
  return fmt::format("{} frames of {}x{}: median {:.2f} ms, 5 % {:.2f} ms, 95 % {:.2f} ms, most {:.2f} ms\n",
                     milliseconds.size(), size.x, size.y, quantile(0.5), quantile(0.05), quantile(0.95),
                     milliseconds.back());
}

std::string to_json(AnyLab& lab, const ErrorFigures& figures) {
  const Measure measure = *lab.measure();
  Json json;
  json["lab"] = lab.info().folder();
  json["parameters"] = lab.parameters().key();
  json["view"] = name_of(measure.view);
  json["truth"] = measure.truth;
  json["unit"] = name_of(measure.unit);
  json["mean"] = figures.mean;
  json["rms"] = figures.rms;
  json["p99"] = figures.p99;
  json["max"] = figures.max;
  json["pixels"] = figures.pixels;
  json["truth_pixels"] = figures.truth_pixels;
  json["non_finite"] = figures.non_finite;
  if (const char* reason = why_nothing(figures)) json["reason"] = reason;
  return to_text(json, 2) + "\n";
}

std::string shaders_as_text(const gl::ProgramCache& programs, const params::Set& parameters, View view) {
  const auto origin = [&](const std::string& uniform) {
    const params::Parameter* p = parameters.find(uniform);
    // Choices and toggles are constants.
    if (p == nullptr || p->type == Type::choice || p->type == Type::toggle)
      return std::string("set in the lab's draw()");
    return fmt::format("--{}: {}{}", p->flag(), p->help, p->unit == "degrees" ? " (here in radians)" : "");
  };
  std::string text;
  for (const gl::Program* program : programs.programs()) {
    if (program->name().starts_with("app/")) continue;  // shows data views
    for (const gl::ShaderSource* source : {&program->vertex(), &program->fragment()})
      text += source->readable(constants(parameters, view), origin) + "\n";
  }
  return text;
}

std::string parameters_as_text(const params::Set& parameters) {
  std::string text;
  for (const params::Parameter& p : parameters) {
    text += fmt::format("--{} ({}, default {}", p.flag(), p.type_name(), p.initial());
    if (p.type == Type::integer || p.type == Type::number)
      text += fmt::format(", {} to {}{}{}", p.least, p.most, p.unit.empty() ? "" : " ", p.unit);
    text += fmt::format(")\n    {}\n", p.help);
    for (const params::Item& item : p.items) text += fmt::format("      {:<20} {}\n", item.name, item.help);
  }
  return text;
}

std::string parameters_as_json(const params::Set& parameters) {
  Json list = Json::array();
  for (const params::Parameter& p : parameters) {
    const bool ranged = p.type == Type::integer || p.type == Type::number;
    Json json;
    json["name"] = p.name;
    json["type"] = p.type_name();
    json["default"] = initial(p);
    json["min"] = ranged ? Json(p.least) : Json();
    json["max"] = ranged ? Json(p.most) : Json();
    json["choices"] = Json::array();
    for (const params::Item& item : p.items)
      json["choices"].push_back({{"name", item.name}, {"help", item.help}});
    json["unit"] = p.unit;
    json["help"] = p.help;
    list.push_back(std::move(json));
  }
  return to_text(list, 2) + "\n";
}

}  // namespace texel::app
