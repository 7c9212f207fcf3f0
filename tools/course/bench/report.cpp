// SPDX-License-Identifier: MIT
#include "report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "bench/embedded.hpp"
#include "core/html.hpp"

namespace texel::tools {
namespace {

using Row = std::vector<std::string>;

/// The rows of one case.
struct Section {
  std::string name;
  const course::BenchCase* bench = nullptr;  ///< null for all cases together
  std::vector<const BenchResult*> results;
};

std::vector<Section> sections(const LabResults& lab) {
  std::vector<Section> all;
  for (const BenchResult& result : lab.results) {
    const std::string name =
        result.case_name == kAllCases ? fmt::format("{}: {}", kAllCases, result.truth) : result.case_name;
    if (all.empty() || all.back().name != name) {
      const auto bench = std::find_if(lab.lab.bench.begin(), lab.lab.bench.end(),
                                      [&](const course::BenchCase& b) { return b.name == result.case_name; });
      all.push_back({name, bench == lab.lab.bench.end() ? nullptr : &*bench, {}});
    }
    all.back().results.push_back(&result);
  }
  return all;
}

std::string figure(double value) {
  return fmt::format("{:.3g}", value);
}

std::string bytes_text(long long bytes) {
  return bytes < 10'000'000 ? fmt::format("{:.1f} kB", static_cast<double>(bytes) / 1e3)
                            : fmt::format("{:.1f} MB", static_cast<double>(bytes) / 1e6);
}

bool has_preparation(const Section& section) {
  return std::any_of(section.results.begin(), section.results.end(),
                     [](const BenchResult* r) { return r->cost && r->cost->prepare_ns; });
}

Row head(const Section& section) {
  Row row = {"",     section.results.front()->parameter, "mean", "rms", "P99", "max", "not finite", "frame",
             "ratio"};
  if (has_preparation(section)) row.emplace_back("prepared");
  row.emplace_back("memory");
  return row;
}

Row cells(const Section& section, const BenchResult& r) {
  Row row = {r.pareto ? "●" : "",
             r.method,
             figure(r.mean),
             figure(r.rms),
             figure(r.p99),
             figure(r.max),
             fmt::format("{}", r.non_finite)};
  if (r.cost) {
    row.push_back(fmt::format("{:.2f} ms", r.cost->ns / 1e6));
    row.push_back(fmt::format("{:.2f} ± {:.2f}", r.cost->ratio, r.cost->ratio * r.cost->spread));
  } else {
    row.insert(row.end(), 2, "");
  }
  if (has_preparation(section))
    row.push_back(r.cost && r.cost->prepare_ns
                      ? fmt::format("{:.3g} ns a {}", *r.cost->prepare_ns, r.cost->prepare_of)
                      : "");
  row.push_back(bytes_text(r.bytes));
  return row;
}

/// "jittered torus, in degrees against the exact relief as a baked map (hard)"
std::string title(const Section& section) {
  const BenchResult& first = *section.results.front();
  if (section.bench == nullptr) return fmt::format("{}, in {}", section.name, first.unit);
  return fmt::format("{}, in {} against {}{}", section.name, first.unit, first.truth,
                     section.bench->hard ? " (hard)" : "");
}

std::vector<std::string> slope_lines(const LabResults& lab, const Section& section) {
  std::vector<std::string> lines;
  if (section.bench == nullptr) return lines;
  std::string number;
  std::vector<std::string> parts;
  for (const Slope& slope : slopes(*section.bench, lab.results)) {
    number = slope.number;
    parts.push_back(fmt::format("{}{:+.2f}", slope.series.empty() ? "" : slope.series + " ", slope.exponent));
  }
  if (!parts.empty())
    lines.push_back(fmt::format("{} error ~ {} ^ exponent, fitted: {}.",
                                section.results.front()->error_name(), number, fmt::join(parts, ", ")));
  return lines;
}

std::size_t width(const std::string& text) {  // of UTF-8: continuation bytes take no column
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

std::string hover(const BenchResult& r) {
  std::string text = fmt::format("{}\n{}\nmean {} P99 {} max {} {}", r.method, r.case_name, figure(r.mean),
                                 figure(r.p99), figure(r.max), r.unit);
  if (r.non_finite > 0) text += fmt::format("\n{} pixels not finite", r.non_finite);
  if (r.cost)
    text += fmt::format("\n{:.2f} ms a frame, {:.2f} times the cheapest", r.cost->ns / 1e6, r.cost->ratio);
  if (r.pareto) text += "\non the Pareto front";
  return text;
}

/// "mean error, degrees"
std::string error_label(const BenchResult& result) {
  return fmt::format("{} error, {}", result.error_name(), result.unit);
}

/// Error against the number that varies; one line for each combination of the others.
Plot number_plot(const Section& section, int number) {
  const auto at = static_cast<std::size_t>(number);
  Plot plot;
  plot.x_label = section.bench->variations[at].parameter + " (" + section.name + ")";
  plot.y_label = error_label(*section.results.front());
  for (const BenchResult* result : section.results) {
    std::vector<std::string> values = result->values();
    const double x = std::stod(values[at]);
    values.erase(values.begin() + number);
    const std::string name =
        values.empty() ? section.bench->variations[at].parameter : fmt::format("{}", fmt::join(values, ", "));
    auto series = std::find_if(plot.series.begin(), plot.series.end(),
                               [&](const Plot::Series& s) { return s.name == name; });
    if (series == plot.series.end()) series = plot.series.insert(plot.series.end(), {name, {}, true});
    if (x > 0) series->points.push_back({x, result->error(), "", hover(*result), true});
  }
  return plot;
}

void add_to_cost_plots(std::vector<std::pair<std::string, Plot>>& found, const Section& section) {
  const BenchResult& first = *section.results.front();
  const std::string key = first.parameter + "\n" + first.unit;
  auto plot = std::find_if(found.begin(), found.end(), [&](const auto& p) { return p.first == key; });
  if (plot == found.end()) {
    Plot made;
    made.x_label = "milliseconds a frame";
    made.y_label = error_label(first);
    made.legend = {"filled: on the Pareto front", ""};
    plot = found.insert(found.end(), {key, std::move(made)});
  }
  std::vector<std::string>& legend = plot->second.legend;
  Plot::Series series{section.name, {}, true};
  for (const BenchResult* result : section.results) {
    if (!result->cost) continue;
    std::size_t number = 0;  // of the method among the plot's
    for (std::size_t i = 2; i < legend.size(); ++i)
      if (legend[i].substr(legend[i].find(' ') + 1) == result->method) number = i - 1;
    if (number == 0) {
      number = legend.size() - 1;
      legend.push_back(fmt::format("{} {}", number, result->method));
    }
    series.points.push_back(
        {result->cost->ns / 1e6, result->error(), fmt::format("{}", number), hover(*result), result->pareto});
  }
  if (!series.points.empty()) plot->second.series.push_back(std::move(series));
}

/// Text with its `words` as code.
std::string with_code(const std::string& text) {
  std::string out;
  bool code = false;
  for (const char c : html_escaped(text)) {
    if (c != '`')
      out += c;
    else
      out += (code = !code) ? "<code>" : "</code>";
  }
  return out;
}

std::string html_table(const LabResults& lab, const Section& section) {
  std::string out =
      fmt::format("<h3>{}</h3>\n<div class=\"scroll\"><table><thead><tr>", html_escaped(title(section)));
  for (const std::string& cell : head(section)) out += fmt::format("<th>{}</th>", html_escaped(cell));
  out += "</tr></thead><tbody>\n";
  for (const BenchResult* result : section.results) {
    out += result->pareto ? "<tr class=\"front\">" : "<tr>";
    for (const std::string& cell : cells(section, *result))
      out += fmt::format("<td>{}</td>", html_escaped(cell));
    out += "</tr>\n";
  }
  out += "</tbody></table></div>\n";
  for (const std::string& line : slope_lines(lab, section))
    out += fmt::format("<p>{}</p>\n", html_escaped(line));
  if (section.bench != nullptr) out += fmt::format("<p>{}</p>\n", with_code(section.bench->teaches));
  return out;
}

std::string markdown_row(const Row& row) {
  return fmt::format("| {} |\n", fmt::join(row, " | "));
}

/// What the sources say, and what measuring it gave.
std::string claims(const std::vector<LabResults>& labs) {
  std::string out = "\n## What the sources say, tested\n\n" + markdown_row({"lab", "says", "found", "see"}) +
                    markdown_row({"---", "---", "---", "---"});
  for (const LabResults& lab : labs)
    for (const course::Claim& claim : lab.lab.claims)
      out += markdown_row({fmt::format("{}", lab.lab.number),
                           fmt::format("{} ([{}](student.md#the-sources))", claim.says, claim.source),
                           claim.found, fmt::format("`{}`", claim.see)});
  return out;
}

}  // namespace

std::vector<LabResults> by_lab(const std::vector<course::Lab>& labs, const BenchReport& report) {
  std::vector<LabResults> all;
  for (const course::Lab& lab : labs) {
    LabResults found{lab, {}};
    for (const course::BenchCase& bench : lab.bench)
      for (const BenchResult& result : report.results)
        if (result.lab == lab.folder && result.case_name == bench.name) found.results.push_back(result);
    for (BenchResult& sum : over_all_cases(lab, found.results)) found.results.push_back(std::move(sum));
    if (!found.results.empty()) all.push_back(std::move(found));
  }
  return all;
}

std::string terminal_table(const LabResults& lab) {
  std::string out = fmt::format("\nLab {}: {}\n", lab.lab.number, lab.lab.title);
  for (const Section& section : sections(lab)) {
    std::vector<Row> rows = {head(section)};
    for (const BenchResult* result : section.results) rows.push_back(cells(section, *result));
    std::vector<std::size_t> widths(rows.front().size());
    for (const Row& row : rows)
      for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width(row[i]));
    out += fmt::format("\n  {}\n", title(section));
    for (const Row& row : rows) {
      std::string line = "  ";
      for (std::size_t i = 0; i < row.size(); ++i) {
        const std::string space(widths[i] - width(row[i]), ' ');
        line += i < 2 ? row[i] + space + "  " : space + row[i] + "  ";
      }
      out += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
    }
    for (const std::string& line : slope_lines(lab, section)) out += "  " + line + "\n";
  }
  return out;
}

std::vector<Plot> plots(const LabResults& lab) {
  std::vector<std::pair<std::string, Plot>> cost_plots;
  std::vector<Plot> number_plots;
  for (const Section& section : sections(lab)) {
    if (section.bench == nullptr) continue;
    if (const int number = number_of(*section.bench); number >= 0)
      number_plots.push_back(number_plot(section, number));
    else
      add_to_cost_plots(cost_plots, section);
  }
  std::vector<Plot> all;
  for (auto& [key, plot] : cost_plots)
    if (!plot.series.empty()) all.push_back(std::move(plot));
  all.insert(all.end(), number_plots.begin(), number_plots.end());
  return all;
}

std::string plot_file(const course::Lab& lab, std::size_t index) {
  return fmt::format("{}-{}.svg", lab.folder, index + 1);
}

std::string bench_page(const std::vector<LabResults>& labs, const std::string& renderer) {
  std::string out = fmt::format(
      "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
      "content=\"width=device-width, initial-scale=1\"><title>Speed against error</title>\n<style>\n{}{}"
      "</style></head><body>\n<div class=\"masthead\"><h1>Speed against error</h1><p>Every method of every "
      "lab "
      "on its easy and hard cases: how far it is from the exact answer, and what a frame costs. Further left "
      "is "
      "cheaper, further down is closer to the truth. No method is both cheaper and closer than a filled dot. "
      "Measured on {}.</p>"
      "</div>\n<nav><ol>\n",
      kPageStyle, kBenchStyle, html_escaped(renderer));
  for (const LabResults& lab : labs)
    out += fmt::format("<li><a href=\"#{0}\"><b>{1}</b> {2}</a></li>\n", lab.lab.folder, lab.lab.number,
                       html_escaped(lab.lab.title));
  out += "</ol></nav>\n<main>\n";
  for (const LabResults& lab : labs) {
    out +=
        fmt::format("<section class=\"bench\" id=\"{}\"><h2>{} {}</h2>\n<p class=\"choice\">{}</p>\n",
                    lab.lab.folder, lab.lab.number, html_escaped(lab.lab.title), with_code(lab.lab.choice));
    for (const Plot& plot : plots(lab)) out += "<div class=\"scroll plot\">" + svg(plot) + "</div>\n";
    for (const Section& section : sections(lab)) out += html_table(lab, section);
    out += "</section>\n";
  }
  return out + "</main>\n<script>\n" + kBenchScript + "</script></body></html>\n";
}

std::string bench_markdown(const std::vector<LabResults>& labs, const std::string& renderer,
                           const std::string& folder) {
  std::string out = fmt::format(
      "# Speed against error\n\n"
      "Every method of every lab on its easy and hard cases: how far it is from the exact answer in double "
      "precision,\nand what a frame costs, as `./run accuracy` measured on {}.\n"
      "`./run bench` measures on your machine and writes `out/bench/index.html`: point at a dot there to see "
      "more.\n\n"
      "A filled dot, ● in the tables, is on the Pareto front: no other method of the case is cheaper and as "
      "close, or closer and as cheap.\nColours are ranked by the rms of their error, everything else by the "
      "mean.\n"
      "`frame` is the median of interleaved rounds. `ratio` is that time over the time of the case's "
      "cheapest method, ± half the "
      "distance of its quartiles.\nCosts within that distance (at least 3 %) and errors within 2 % count as "
      "equal. "
      "`memory` holds vertices, indices and textures.\n",
      renderer);
  out += claims(labs);
  for (const LabResults& lab : labs) {
    out += fmt::format("\n## {} {}\n\n{}\n", lab.lab.number, lab.lab.title, lab.lab.choice);
    const std::vector<Plot> drawn = plots(lab);
    for (std::size_t i = 0; i < drawn.size(); ++i)
      out += fmt::format("\n![{}, by {}]({}/{})\n", drawn[i].y_label, drawn[i].x_label, folder,
                         plot_file(lab.lab, i));
    for (const Section& section : sections(lab)) {
      out += fmt::format("\n### {}\n\n", title(section));
      const Row top = head(section);
      Row rule(top.size(), "--:");
      rule[0] = rule[1] = "---";
      out += markdown_row(top) + markdown_row(rule);
      for (const BenchResult* result : section.results) out += markdown_row(cells(section, *result));
      for (const std::string& line : slope_lines(lab, section)) out += "\n" + line + "\n";
      if (section.bench != nullptr) out += "\n" + section.bench->teaches + "\n";
    }
  }
  return out;
}

}  // namespace texel::tools
