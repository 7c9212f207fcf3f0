// SPDX-License-Identifier: MIT
#include "report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "bench/embedded.hpp"
#include "core/html.hpp"

namespace texel::commands {
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

Row head(const LabResults& lab, const Section& section) {
  Row row = {"",     section.results.front()->parameter, "mean", "rms", "P99", "max", "not finite", "frame",
             "ratio"};
  if (!lab.by_gpu.empty()) row.emplace_back("ratio, GPU");
  if (has_preparation(section)) row.emplace_back("prepared");
  row.emplace_back("memory");
  return row;
}

std::string ratio(const BenchResult& r) {
  return r.cost ? fmt::format("{:.2f} ± {:.2f}", r.cost->ratio, r.cost->ratio * r.cost->spread) : "";
}

/// The same method in the same case, or null.
const BenchResult* gpu_result(const LabResults& lab, const BenchResult& r) {
  const auto same = std::find_if(lab.by_gpu.begin(), lab.by_gpu.end(), [&](const BenchResult& other) {
    return other.case_name == r.case_name && other.truth == r.truth && other.method == r.method;
  });
  return same == lab.by_gpu.end() ? nullptr : &*same;
}

/// Over the cases that both renderers measured.
struct GpuFigures {
  int rows = 0, alike = 0;
  double least_ms = HUGE_VAL, most_ms = 0;
};

GpuFigures gpu_figures(const std::vector<LabResults>& labs) {
  GpuFigures all;
  for (const LabResults& lab : labs)
    for (const BenchResult& own : lab.results) {
      const BenchResult* other = own.case_name == kAllCases ? nullptr : gpu_result(lab, own);
      if (other == nullptr || !other->cost) continue;
      ++all.rows;
      if (std::abs(other->error() - own.error()) <= 0.1 * own.error()) ++all.alike;
      all.least_ms = std::min(all.least_ms, other->cost->ns / 1e6);
      all.most_ms = std::max(all.most_ms, other->cost->ns / 1e6);
    }
  return all;
}

Row cells(const LabResults& lab, const Section& section, const BenchResult& r) {
  Row row = {r.pareto ? "●" : "",
             r.method,
             figure(r.mean),
             figure(r.rms),
             figure(r.p99),
             figure(r.max),
             fmt::format("{}", r.non_finite)};
  row.push_back(r.cost ? fmt::format("{:.2f} ms", r.cost->ns / 1e6) : "");
  row.push_back(ratio(r));
  if (!lab.by_gpu.empty()) {
    const BenchResult* other = gpu_result(lab, r);
    row.push_back(other == nullptr ? "" : ratio(*other));
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

/// The files of a result's pictures, as the page names them.
std::vector<std::string> pictures(const Section& section, const BenchResult& result) {
  std::vector<std::string> files;
  for (const course::Case& picture : pictures_of(*section.bench, result))
    files.push_back(fmt::format("{}/{}/{}", kPictures, result.lab, picture.file));
  return files;
}

/// Error against the number that varies; one line for each combination of the others.
Plot number_plot(const Section& section, int number) {
  const auto at = static_cast<std::size_t>(number);
  Plot plot;
  plot.x_label = section.bench->variations[at].parameter;
  plot.y_label = error_label(*section.results.front());
  Plot::Panel& panel = plot.panels.emplace_back();
  panel.name = section.name;
  std::vector<std::string> names;  // of the lines
  for (const BenchResult* result : section.results) {
    std::vector<std::string> values = result->values();
    const double x = std::stod(values[at]);
    if (!(x > 0)) continue;
    values.erase(values.begin() + number);
    const std::string name = fmt::format("{}", fmt::join(values, ", "));
    const auto line = static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
    if (line == names.size()) {
      names.push_back(name);
      panel.lines.push_back({{}, line});
    }
    panel.lines[line].points.push_back(panel.points.size());
    panel.points.push_back({x, result->error(), line, true, "", hover(*result), pictures(section, *result)});
  }
  for (std::size_t line = 0; line < names.size(); ++line)  // at its last dot
    panel.points[panel.lines[line].points.back()].label = names[line];
  return plot;
}

/// Cases over the same parameters, with errors in the same unit, share a plot and its axes.
struct CostPlot {
  std::string parameter, unit;
  std::vector<std::string> methods;  ///< in the order of their colours
  Plot plot;
};

void add_to_cost_plots(std::vector<CostPlot>& found, const Section& section) {
  const BenchResult& first = *section.results.front();
  auto same = std::find_if(found.begin(), found.end(), [&](const CostPlot& p) {
    return p.parameter == first.parameter && p.unit == first.unit;
  });
  if (same == found.end())
    same = found.insert(same,
                        {first.parameter, first.unit, {}, {"milliseconds a frame", error_label(first), {}}});
  Plot::Panel panel{section.name, {}, {{}}, section.bench->hard};
  for (const BenchResult* result : section.results) {
    if (!result->cost) continue;
    std::vector<std::string>& methods = same->methods;
    const auto known = std::find(methods.begin(), methods.end(), result->method);
    const auto number = static_cast<std::size_t>(known - methods.begin());
    if (known == methods.end()) methods.push_back(result->method);
    if (result->pareto) panel.lines[0].points.push_back(panel.points.size());
    panel.points.push_back({result->cost->ns / 1e6, result->error(), number, result->pareto, result->method,
                            hover(*result), pictures(section, *result)});
  }
  std::sort(panel.lines[0].points.begin(), panel.lines[0].points.end(),
            [&](std::size_t a, std::size_t b) { return panel.points[a].x < panel.points[b].x; });
  if (!panel.points.empty()) same->plot.panels.push_back(std::move(panel));
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
  for (const std::string& cell : head(lab, section)) out += fmt::format("<th>{}</th>", html_escaped(cell));
  out += "</tr></thead><tbody>\n";
  for (const BenchResult* result : section.results) {
    out += result->pareto ? "<tr class=\"front\">" : "<tr>";
    for (const std::string& cell : cells(lab, section, *result))
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

/// A report's results of a lab's cases, and over all of them.
std::vector<BenchResult> results_of(const course::Lab& lab, const BenchReport& report) {
  std::vector<BenchResult> found;
  for (const course::BenchCase& bench : lab.bench)
    for (const BenchResult& result : report.results)
      if (result.lab == lab.folder && result.case_name == bench.name) found.push_back(result);
  for (BenchResult& sum : over_all_cases(lab, found)) found.push_back(std::move(sum));
  return found;
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

std::vector<LabResults> by_lab(const std::vector<course::Lab>& labs, const BenchReport& report,
                               const BenchReport& by_gpu) {
  std::vector<LabResults> all;
  for (const course::Lab& lab : labs) {
    LabResults found{lab, results_of(lab, report), results_of(lab, by_gpu)};
    if (!found.results.empty()) all.push_back(std::move(found));
  }
  return all;
}

std::string terminal_table(const LabResults& lab) {
  std::string out = fmt::format("\nLab {}: {}\n", lab.lab.number, lab.lab.title);
  for (const Section& section : sections(lab)) {
    std::vector<Row> rows = {head(lab, section)};
    for (const BenchResult* result : section.results) rows.push_back(cells(lab, section, *result));
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
  std::vector<CostPlot> cost_plots;
  std::vector<Plot> number_plots;
  for (const Section& section : sections(lab)) {
    if (section.bench == nullptr) continue;
    if (const int number = number_of(*section.bench); number >= 0)
      number_plots.push_back(number_plot(section, number));
    else
      add_to_cost_plots(cost_plots, section);
  }
  std::vector<Plot> all;
  for (CostPlot& cost : cost_plots)
    if (!cost.plot.panels.empty()) all.push_back(std::move(cost.plot));
  all.insert(all.end(), number_plots.begin(), number_plots.end());
  return all;
}

std::vector<course::Case> pictures_of(const course::BenchCase& bench, const BenchResult& result) {
  constexpr int kSide = 200;
  std::string name;
  for (const char c : bench.name + "-" + result.method) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
    name += plain ? c : c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : '-';
  }
  course::Case one = bench;
  const int longer = std::max(bench.size.width, bench.size.height);
  one.size = {std::max(1, bench.size.width * kSide / longer),
              std::max(1, bench.size.height * kSide / longer)};
  const std::vector<std::string> parameters = result.parameters(), values = result.values();
  for (std::size_t i = 0; i < parameters.size(); ++i) one.settings.push_back({parameters[i], values[i]});

  std::vector<course::Case> all;
  for (const course::View view : {course::View::color, course::View::error}) {
    one.view = view;
    one.file = fmt::format("{}-{}.png", name, name_of(view));
    all.push_back(one);
  }
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
      "cheaper, further down is closer to the truth. A filled dot is on the Pareto front: no method is both "
      "cheaper and closer. Point at a dot to see its picture, and where its error is. "
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
    out += "<div class=\"plots\">\n";
    for (const Plot& plot : plots(lab))
      for (const std::string& panel : panel_svgs(plot)) out += panel;
    out += "</div>\n";
    for (const Section& section : sections(lab)) out += html_table(lab, section);
    out += "</section>\n";
  }
  return out + "</main>\n<script>\n" + kBenchScript + "</script></body></html>\n";
}

std::string bench_markdown(const std::vector<LabResults>& labs, const std::string& renderer,
                           const std::string& gpu, const std::string& folder) {
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
  if (const GpuFigures card = gpu_figures(labs); card.rows > 0)
    out += fmt::format(
        "`ratio, GPU` is the ratio by a graphics card, {}, by its own clock.\n"
        "A frame takes it {:.2f} to {:.2f} ms, a good part of which is the same for all methods. "
        "In {} of {} rows its error is within 10 % of the one here.\n",
        gpu, card.least_ms, card.most_ms, card.alike, card.rows);
  out += claims(labs);
  for (const LabResults& lab : labs) {
    out += fmt::format("\n## {} {}\n\n{}\n", lab.lab.number, lab.lab.title, lab.lab.choice);
    const std::vector<Plot> drawn = plots(lab);
    for (std::size_t i = 0; i < drawn.size(); ++i)
      out += fmt::format("\n![{}, by {}]({}/{})\n", drawn[i].y_label, drawn[i].x_label, folder,
                         plot_file(lab.lab, i));
    for (const Section& section : sections(lab)) {
      out += fmt::format("\n### {}\n\n", title(section));
      const Row top = head(lab, section);
      Row rule(top.size(), "--:");
      rule[0] = rule[1] = "---";
      out += markdown_row(top) + markdown_row(rule);
      for (const BenchResult* result : section.results) out += markdown_row(cells(lab, section, *result));
      for (const std::string& line : slope_lines(lab, section)) out += "\n" + line + "\n";
      if (section.bench != nullptr) out += "\n" + section.bench->teaches + "\n";
    }
  }
  return out;
}

}  // namespace texel::commands
