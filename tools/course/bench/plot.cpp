// SPDX-License-Identifier: MIT
#include "plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/html.hpp"

namespace texel::tools {
namespace {

constexpr double kLeft = 74, kTop = 16, kWidth = 520, kHeight = 350, kLegend = 622, kLine = 17, kWhole = 960;
/// Apart also for those who do not see red from green (M. Okabe and K. Ito, "Color Universal Design", 2008).
constexpr std::array kColours = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                 "#e69f00", "#56b4e9", "#7f6a00", "#777777"};

const char* colour(std::size_t series) {
  return kColours[series % kColours.size()];
}

/// A logarithmic axis over whole powers of ten, or over 1-2-5 steps where it is short.
class Axis {
 public:
  Axis(double least, double most, double from, double to) : from_(from), to_(to) {
    if (!(least > 0)) least = most = 1;
    least_ = std::log10(least) - 0.08 * (std::log10(most / least) + 0.6);
    most_ = std::log10(most) + 0.08 * (std::log10(most / least) + 0.6);
  }
  [[nodiscard]] double place(double value) const {
    return from_ + (to_ - from_) * (std::log10(value) - least_) / (most_ - least_);
  }
  [[nodiscard]] std::vector<double> ticks() const {
    const double decades = most_ - least_;
    std::vector<double> result;
    const int step = std::max(1, static_cast<int>(std::ceil(decades / 8)));
    std::vector<double> digits = {1};
    if (decades < 2.2) digits = {1, 2, 5};
    if (decades < 0.7) digits = {1, 1.5, 2, 3, 4, 5, 6, 8};
    for (int power = static_cast<int>(std::floor(least_)); power <= most_; ++power)
      for (const double digit : digits) {
        const double value = digit * std::pow(10, power);
        if (std::log10(value) < least_ || std::log10(value) > most_ || power % step != 0) continue;
        result.push_back(value);
      }
    return result;
  }

 private:
  double from_, to_, least_, most_;
};

std::string text(double x, double y, const std::string& content, const char* attributes = "") {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" {}>{}</text>\n", x, y, attributes,
                     html_escaped(content));
}

/// Dots of a series that would cover each other stand as one, with all their labels.
struct Dot {
  double x, y;
  std::string label, title;
  bool filled;

  [[nodiscard]] double half_width() const {
    return label.empty() ? 5 : std::max(8.5, 3.4 * static_cast<double>(label.size()) + 4);
  }
  [[nodiscard]] double half_height() const { return label.empty() ? 5 : 8.5; }
  [[nodiscard]] bool covers(const Dot& other) const {
    return filled == other.filled && std::abs(x - other.x) < half_width() + other.half_width() - 3 &&
           std::abs(y - other.y) < half_height() + other.half_height() - 3;
  }
};

std::vector<Dot> dots(const Plot::Series& series, const Axis& x_axis, const Axis& y_axis) {
  std::vector<Dot> result;
  for (const Plot::Point& point : series.points) {
    Dot dot{x_axis.place(point.x), point.y > 0 ? y_axis.place(point.y) : kTop + kHeight, point.label,
            point.title, point.filled};
    // Each that it covers is taken in, which makes it wider; it stays where the first one is.
    for (auto other = result.begin(); !dot.label.empty() && other != result.end();) {
      if (!dot.covers(*other)) {
        ++other;
        continue;
      }
      dot = {other->x, other->y, other->label + " " + dot.label, other->title + "\n\n" + dot.title,
             dot.filled};
      result.erase(other);
      other = result.begin();
    }
    result.push_back(std::move(dot));
  }
  return result;
}

std::string drawn(const Dot& dot, const char* colour) {
  const double half = dot.half_width(), high = dot.half_height();
  return fmt::format(
      "<g class=\"dot\" tabindex=\"0\"><title>{}</title><rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" "
      "height=\"{}\" rx=\"{}\" fill=\"{}\" stroke=\"{}\" stroke-width=\"1.6\"/>"
      "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\" font-size=\"11\" font-weight=\"600\" "
      "fill=\"{}\">{}</text></g>\n",
      html_escaped(dot.title), dot.x - half, dot.y - high, 2 * half, 2 * high, high,
      dot.filled ? colour : "var(--card, #fff)", colour, dot.x, dot.y + 3.9, dot.filled ? "#fff" : colour,
      html_escaped(dot.label));
}

}  // namespace

std::string svg(const Plot& plot) {
  double x_least = INFINITY, x_most = 0, y_least = INFINITY, y_most = 0;
  for (const Plot::Series& series : plot.series)
    for (const Plot::Point& point : series.points) {
      x_least = std::min(x_least, point.x);
      x_most = std::max(x_most, point.x);
      if (point.y > 0) y_least = std::min(y_least, point.y);
      y_most = std::max(y_most, point.y);
    }
  if (!(y_least <= y_most)) y_least = y_most = 1;
  const Axis x_axis(x_least, x_most, kLeft, kLeft + kWidth), y_axis(y_least, y_most, kTop + kHeight, kTop);

  const double legend_height =
      kLine * static_cast<double>(plot.series.size() + plot.legend.size() + 2) + kTop;
  const double height = std::max(kTop + kHeight + 52, legend_height);
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {3} {0:.0f}\" width=\"{3}\" "
      "height=\"{0:.0f}\" "
      "role=\"img\" aria-label=\"{1} against {2}\" font-family=\"system-ui, 'Segoe UI', Roboto, 'DejaVu "
      "Sans', "
      "sans-serif\" font-size=\"12.5\">\n<rect width=\"{3}\" height=\"{0:.0f}\" fill=\"var(--card, "
      "#fff)\"/>\n",
      height, html_escaped(plot.y_label), html_escaped(plot.x_label), kWhole);
  for (const double tick : x_axis.ticks()) {
    out += fmt::format("<path d=\"M{0:.1f} {1}V{2}\" stroke=\"var(--line, #dedbd3)\"/>\n", x_axis.place(tick),
                       kTop, kTop + kHeight);
    out += text(x_axis.place(tick), kTop + kHeight + 18, fmt::format("{:g}", tick),
                "text-anchor=\"middle\" fill=\"var(--quiet, #5f646d)\"");
  }
  for (const double tick : y_axis.ticks()) {
    out += fmt::format("<path d=\"M{1} {0:.1f}H{2}\" stroke=\"var(--line, #dedbd3)\"/>\n", y_axis.place(tick),
                       kLeft, kLeft + kWidth);
    out += text(kLeft - 8, y_axis.place(tick) + 4, fmt::format("{:g}", tick),
                "text-anchor=\"end\" fill=\"var(--quiet, #5f646d)\"");
  }
  out += text(kLeft + kWidth / 2, kTop + kHeight + 40, plot.x_label,
              "text-anchor=\"middle\" fill=\"var(--ink, #1d1f23)\"");
  out += fmt::format(
      "<text transform=\"translate(16 {:.1f}) rotate(-90)\" text-anchor=\"middle\" fill=\"var(--ink, "
      "#1d1f23)\">{}</text>\n",
      kTop + kHeight / 2, html_escaped(plot.y_label));

  double y = kTop + 12;
  std::string hollow, filled;  // the front in front
  for (std::size_t i = 0; i < plot.series.size(); ++i) {
    const Plot::Series& series = plot.series[i];
    const std::vector<Dot> found = dots(series, x_axis, y_axis);
    std::vector<Dot> front = found;
    std::erase_if(front, [](const Dot& dot) { return !dot.filled; });
    std::sort(front.begin(), front.end(), [](const Dot& a, const Dot& b) { return a.x < b.x; });
    std::string path;
    for (const Dot& dot : front)
      path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", dot.x, dot.y);
    if (series.line && front.size() > 1)
      out +=
          fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.6\" opacity=\"0.55\"/>\n",
                      path, colour(i));
    for (const Dot& dot : found) (dot.filled ? filled : hollow) += drawn(dot, colour(i));
    out += fmt::format("<rect x=\"{}\" y=\"{:.1f}\" width=\"11\" height=\"11\" rx=\"5.5\" fill=\"{}\"/>\n",
                       kLegend, y - 10, colour(i));
    out += text(kLegend + 18, y, series.name, "fill=\"var(--ink, #1d1f23)\"");
    y += kLine;
  }
  y += kLine * 0.6;
  for (const std::string& entry : plot.legend) {
    out += text(kLegend, y, entry, "fill=\"var(--quiet, #5f646d)\"");
    y += kLine;
  }
  return out + hollow + filled + "</svg>\n";
}

}  // namespace texel::tools
