// SPDX-License-Identifier: MIT
#include "renderers/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <set>

#include "core/error.hpp"
#include "core/files.hpp"
#include "core/json.hpp"

namespace texel::commands {
namespace {

Json list_of(const std::vector<RendererReport::Row>& rows) {
  Json all = Json::array();
  for (const RendererReport::Row& row : rows) {
    Json one{{"lab", row.lab}, {"case", row.name}, {"unit", row.unit}, {"by", Json::object()}};
    for (const auto& [group, value] : row.by) one["by"][group] = value;  // infinity becomes null
    if (row.least > 0) one["least"] = row.least;
    all.push_back(std::move(one));
  }
  return all;
}

std::vector<RendererReport::Row> rows_of(const Json& list) {
  std::vector<RendererReport::Row> rows;
  for (const Json& one : list) {
    RendererReport::Row row{one.at("lab"), one.at("case"), one.at("unit"), {}, one.value("least", 0.0)};
    for (const auto& [group, value] : one.at("by").items())
      row.by[group] = value.is_null() ? std::numeric_limits<double>::infinity() : value.get<double>();
    rows.push_back(std::move(row));
  }
  return rows;
}

/// A table with a column for each group; `first` and `last` are the cells around them.
template <class First, class Last>
std::string group_table(const std::vector<RendererReport::Row>& rows, const std::string& head,
                        const std::string& tail, First first, Last last) {
  std::set<std::string> groups;
  for (const RendererReport::Row& row : rows)
    for (const auto& [group, value] : row.by) groups.insert(group);
  std::string top = head, rule;
  for (const std::string& group : groups) top += fmt::format(" {} |", group);
  top += tail;
  for (const char c : top)
    if (c == '|') rule += rule.empty() ? "|" : " --- |";
  std::string out = top + "\n" + rule + "\n";
  for (const RendererReport::Row& row : rows) {
    out += first(row);
    for (const std::string& group : groups)
      out += row.by.contains(group) ? fmt::format(" {:.2g} |", row.by.at(group)) : " |";
    out += last(row) + "\n";
  }
  return out;
}

constexpr const char* kIntroduction = R"(
No two drivers draw the same. The table has each graded case's limit and its spread: the largest distance of each renderer's
picture from the expected one, after one pixel of a thousand is left out. A limit is at least three times the spread.
Hidden cases are drawn with three seeds and compared with those of llvmpipe in Mesa 22.
A graphics card rounds a vertex's place in the window to 1/256 of a pixel, and all that it interpolates moves with it. So a
difference counts as none that a move by 1/64 of a pixel explains: 1/64 of what the pixel differs from one of those around it.
`check` and `grade` use these limits and draw in software: the solution has all points by each of these renderers. Pages in a
browser draw with the machine's graphics card. They judge the public cases of steps in shaders, and the column `hardware` has
these.

`./run renderers` draws and measures. A machine has one version of Mesa only. To join several machines, copy the folders in
their `out/renderers` into one, and let `./run renderers --judge-only` measure there.
llvmpipe draws with vectors of 128 and 256 bits and with the instructions of older processors (SSE2, SSE4.1, AVX). Its 1/sqrt is the
processor's approximation: it is also drawn with an exact one, and with one that is off by as much as Intel specifies.
)";

const std::string kFiltersHead = R"(
### Lab 1's filters by driver, rms error in 8-bit steps

The anisotropic filter is the driver's, and Mesa changed it between 22 and 25 and again before 26.
`supersampled` is the lab's own: it is the same in all versions of Mesa, and nearly the same on a graphics card.

)";

const std::string kTestsHead = R"(
### Tests that hold a limit, by the share of it that is used

Each row is an assertion in a test that draws. 0.2 means: the value was at most a fifth of its limit.
The room is (1 - smallest share) / (largest share - smallest share). It is at least 3.

)";

std::string room_of(const RendererReport::Row& row, double limit) {
  return row.most() > row.least ? fmt::format("{:.2g}", row.room(limit)) : "";
}

/// In a cell of a table.
std::string as_code(const std::string& text) {
  std::string code;
  for (const char c : text) code += c == '|' ? "\\|" : std::string(1, c);
  return "`" + code + "`";
}

/// "SSE4.1" of "mesa22_llvmpipe_sse41".
std::string way_of(const std::string& renderer) {
  static const std::map<std::string, std::string> kWays = {{"egl", "EGL"},
                                                           {"osmesa", "OSMesa"},
                                                           {"128", "128 bits"},
                                                           {"256", "256 bits"},
                                                           {"sse2", "SSE2"},
                                                           {"sse41", "SSE4.1"},
                                                           {"avx", "AVX"},
                                                           {"rsqrt_exact", "exact 1/sqrt"},
                                                           {"rsqrt_high", "1/sqrt too large"},
                                                           {"rsqrt_low", "1/sqrt too small"}};
  const std::string way = renderer.substr(renderer.find('_', renderer.find('_') + 1) + 1);
  const auto known = kWays.find(way);
  return known == kWays.end() ? way : known->second;
}

}  // namespace

std::string group_of(const std::string& renderer) {
  const std::size_t first = renderer.find('_'), second = renderer.find('_', first + 1);
  return renderer.substr(first + 1, second - first - 1) + ", " + renderer.substr(0, first);
}

double RendererReport::Row::most() const {
  double most = 0;
  for (const auto& [group, value] : by) most = std::max(most, value);
  return most;
}

double RendererReport::Row::room(double limit) const {
  if (most() <= least) return std::numeric_limits<double>::infinity();  // they do not differ
  return (limit - least) / (most() - least);
}

std::string to_json(const RendererReport& report) {
  Json json{{"drawn_by", report.drawn_by},
            {"cases", list_of(report.cases)},
            {"tests", list_of(report.tests)},
            {"filters", list_of(report.filters)}};
  std::string text = "{\n";
  for (const auto& [key, value] : json.items()) {
    text += fmt::format(" \"{}\": {}\n", key, value.is_array() ? "[" : to_text(value) + ",");
    if (!value.is_array()) continue;
    for (std::size_t i = 0; i < value.size(); ++i)
      text += "  " + to_text(value[i]) + (i + 1 < value.size() ? ",\n" : "\n");
    text += key == "filters" ? " ]\n" : " ],\n";
  }
  return text + "}\n";
}

RendererReport read_renderers(const std::filesystem::path& file) {
  try {
    const Json json = parse_json(read_file(file));
    return {json.at("drawn_by"), rows_of(json.at("cases")), rows_of(json.at("tests")),
            rows_of(json.at("filters"))};
  } catch (const Json::exception& error) {
    throw Error::failed(fmt::format("is no report on renderers: {}", error.what()), {file.string()});
  }
}

std::string renderers_markdown(const RendererReport& report, const std::vector<course::Lab>& labs) {
  std::string out =
      fmt::format("\n{}\n{}\n| renderer | with |\n| --- | --- |\n", kRenderersTitle, kIntroduction);
  std::map<std::string, std::string> ways;
  for (const auto& [renderer, says] : report.drawn_by) {
    std::string& all = ways[says];
    all += (all.empty() ? "" : ", ") + way_of(renderer);
  }
  for (const auto& [says, all] : ways) out += fmt::format("| {} | {} |\n", says, all);
  const auto limit_of = [&](const RendererReport::Row& row) {
    for (const course::Lab& lab : labs)
      for (const course::GradedCase& one : lab.cases)
        if (lab.number == row.lab && one.name == row.name) return one.limit;
    return 0.0;
  };
  out += "\n" + group_table(
                    report.cases, "| lab | case | unit |", " limit | limit / spread |",
                    [](const RendererReport::Row& row) {
                      return fmt::format("| {} | {} | {} |", row.lab, row.name, row.unit);
                    },
                    [&](const RendererReport::Row& row) {
                      return fmt::format(" {:g} | {} |", limit_of(row), room_of(row, limit_of(row)));
                    });
  out +=
      kTestsHead + group_table(
                       report.tests, "| test | holds |", " room |",
                       [](const RendererReport::Row& row) {
                         return fmt::format("| {} | {} |", row.name, as_code(row.unit));
                       },
                       [](const RendererReport::Row& row) { return fmt::format(" {} |", room_of(row, 1)); });
  out += kFiltersHead + group_table(
                            report.filters, "| case |", "",
                            [](const RendererReport::Row& row) { return fmt::format("| {} |", row.name); },
                            [](const RendererReport::Row&) { return std::string(); });
  return out;
}

}  // namespace texel::commands
