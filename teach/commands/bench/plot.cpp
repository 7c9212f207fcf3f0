// SPDX-License-Identifier: MIT
#include "plot.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/html.hpp"

namespace texel::commands {
namespace {

constexpr double kPanelWidth = 340, kPanelHeight = 286, kLeft = 52, kRight = 328, kTop = 48, kBottom = 246;
constexpr int kColumns = 3;
constexpr double kDot = 5.5;                     // its radius
constexpr double kCharacter = 6.3, kBold = 7.1;  // width of a label's character, at 11 units
constexpr double kAscent = 9, kDescent = 3;      // of a label
/// Apart also for those who do not see red from green (M. Okabe and K. Ito, "Color Universal Design", 2008).
constexpr std::array kColors = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                "#e69f00", "#56b4e9", "#7f6a00", "#777777"};
constexpr const char* kInk = "var(--ink, #1d1f23)";
constexpr const char* kQuiet = "var(--quiet, #5f646d)";

const char* color(std::size_t index) {
  return kColors[index % kColors.size()];
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
    const int step = std::max(1, static_cast<int>(std::ceil(decades / 6)));
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

struct Axes {
  Axis x, y;
};

/// Errors are compared from panel to panel, and have the same axis in all. Costs are compared within a panel.
Axes axes(const Plot& plot, const Plot::Panel& panel) {
  double x_least = INFINITY, x_most = 0, y_least = INFINITY, y_most = 0;
  for (const Plot::Point& point : panel.points) {
    x_least = std::min(x_least, point.x);
    x_most = std::max(x_most, point.x);
  }
  for (const Plot::Panel& each : plot.panels)
    for (const Plot::Point& point : each.points) {
      if (point.y > 0) y_least = std::min(y_least, point.y);
      y_most = std::max(y_most, point.y);
    }
  if (!(y_least <= y_most)) y_least = y_most = 1;
  return {Axis(x_least, x_most, kLeft, kRight), Axis(y_least, y_most, kBottom, kTop)};
}

struct Box {
  double left, top, right, bottom;

  [[nodiscard]] bool meets(const Box& other) const {
    return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
  }
};

struct Place {
  double x, y;
};

struct Label {
  double x, y;      ///< of the text's first character, on its base line
  double distance;  ///< from the dot
};

double label_width(const Plot::Point& point) {
  return (point.filled ? kBold : kCharacter) * static_cast<double>(point.label.size());
}

/// Puts each label as near to its dot as there is room: not on a dot, and not on another label. The front
/// comes first. A label without room is left out: hovering shows it.
std::vector<std::optional<Label>> labels(const std::vector<Plot::Point>& points,
                                         const std::vector<Place>& dots) {
  std::vector<Box> taken;
  for (const Place& dot : dots) taken.push_back({dot.x - kDot, dot.y - kDot, dot.x + kDot, dot.y + kDot});
  std::vector<std::size_t> order;
  for (const bool filled : {true, false})
    for (std::size_t i = 0; i < points.size(); ++i)
      if (points[i].filled == filled && !points[i].label.empty()) order.push_back(i);

  std::vector<std::optional<Label>> result(points.size());
  for (const std::size_t i : order) {
    const double width = label_width(points[i]);
    const auto find = [&]() -> std::optional<Label> {
      for (const double away : {9.0, 16.0, 26.0, 38.0, 52.0, 68.0, 86.0, 106.0, 128.0})
        // Right, left, the four diagonals, above, below.
        for (const auto& [u, v] : {std::pair(1.0, 0.0),
                                   {-1.0, 0.0},
                                   {0.7, -0.7},
                                   {0.7, 0.7},
                                   {-0.7, -0.7},
                                   {-0.7, 0.7},
                                   {0.0, -1.0},
                                   {0.0, 1.0}}) {
          const double x = dots[i].x + u * away - (u < 0 ? width : u == 0 ? width / 2 : 0);
          const double y = dots[i].y + v * (away + 3) + (kAscent - kDescent) / 2;
          const Box box{x, y - kAscent, x + width, y + kDescent};
          const bool inside = box.left > kLeft + 2 && box.right < kPanelWidth - 2 && box.top > kTop - 8 &&
                              box.bottom < kBottom;
          if (!inside || std::any_of(taken.begin(), taken.end(), [&](const Box& b) { return b.meets(box); }))
            continue;
          taken.push_back(box);
          return Label{x, y, away};
        }
      return {};
    };
    result[i] = find();
  }
  return result;
}

std::string text(double x, double y, const std::string& content, const std::string& attributes) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" {}>{}</text>\n", x, y, attributes,
                     html_escaped(content));
}

std::string grid(const Axes& axes) {
  std::string out;
  for (const double tick : axes.x.ticks()) {
    out += fmt::format("<path d=\"M{0:.1f} {1}V{2}\" stroke=\"var(--line, #dedbd3)\"/>\n", axes.x.place(tick),
                       kTop, kBottom);
    out += text(axes.x.place(tick), kBottom + 15, fmt::format("{:g}", tick),
                fmt::format("text-anchor=\"middle\" fill=\"{}\"", kQuiet));
  }
  for (const double tick : axes.y.ticks()) {
    out += fmt::format("<path d=\"M{1} {0:.1f}H{2}\" stroke=\"var(--line, #dedbd3)\"/>\n", axes.y.place(tick),
                       kLeft, kRight);
    out += text(kLeft - 6, axes.y.place(tick) + 4, fmt::format("{:g}", tick),
                fmt::format("text-anchor=\"end\" fill=\"{}\"", kQuiet));
  }
  return out;
}

std::string drawn(const Plot::Point& point, const Place& dot, const std::optional<Label>& label) {
  std::string out;
  if (label) {
    const double width = label_width(point);
    if (label->distance > 16)
      out += fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" stroke=\"{}\" opacity=\"0.6\"/>", dot.x,
                         dot.y, std::clamp(dot.x, label->x, label->x + width),
                         label->y - (kAscent - kDescent) / 2, color(point.color));
    out += text(
        label->x, label->y, point.label,
        fmt::format("fill=\"{}\" stroke=\"var(--card, #fff)\" stroke-width=\"3\" paint-order=\"stroke\"{}",
                    kInk, point.filled ? " font-weight=\"600\"" : ""));
  }
  return fmt::format(
      "<g class=\"dot\" tabindex=\"0\"{}><title>{}</title>{}<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" "
      "fill=\"{}\" stroke=\"{}\" stroke-width=\"1.6\"/></g>\n",
      point.pictures.empty() ? "" : fmt::format(" data-pictures=\"{}\"", fmt::join(point.pictures, " ")),
      html_escaped(point.title), out, dot.x, dot.y, kDot,
      point.filled ? color(point.color) : "var(--card, #fff)", color(point.color));
}

/// What stands in the panel's <svg>.
std::string content(const Plot& plot, const Plot::Panel& panel) {
  const Axes shown = axes(plot, panel);
  std::string out =
      text(8, 18, panel.name, fmt::format("font-size=\"12\" font-weight=\"600\" fill=\"{}\"", kInk));
  out +=
      text(8, 34, plot.y_label + (panel.is_hard ? ", a hard case" : ""), fmt::format("fill=\"{}\"", kQuiet));
  out += grid(shown);
  out += text(kRight, kBottom + 32, plot.x_label, fmt::format("text-anchor=\"end\" fill=\"{}\"", kQuiet));

  std::vector<Place> dots;
  for (const Plot::Point& point : panel.points)
    dots.push_back({shown.x.place(point.x), point.y > 0 ? shown.y.place(point.y) : kBottom});
  for (const Plot::Line& line : panel.lines) {
    std::string path;
    for (const std::size_t i : line.points)
      path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", dots[i].x, dots[i].y);
    if (line.points.size() > 1)
      out +=
          fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.6\" opacity=\"0.55\"/>\n",
                      path, line.color ? color(*line.color) : kQuiet);
  }
  const std::vector<std::optional<Label>> placed = labels(panel.points, dots);
  for (const bool filled : {false, true})  // the front in front
    for (std::size_t i = 0; i < dots.size(); ++i)
      if (panel.points[i].filled == filled) out += drawn(panel.points[i], dots[i], placed[i]);
  return out;
}

std::string element(double width, double height, const std::string& label, const std::string& inside) {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" "
      "role=\"group\" aria-label=\"{2}\" font-family=\"system-ui, 'Segoe UI', Roboto, 'DejaVu Sans', "
      "sans-serif\" font-size=\"11\">\n<rect width=\"{0}\" height=\"{1}\" fill=\"var(--card, "
      "#fff)\"/>\n{3}</svg>\n",
      width, height, html_escaped(label), inside);
}

}  // namespace

std::vector<std::string> panel_svgs(const Plot& plot) {
  std::vector<std::string> all;
  for (const Plot::Panel& panel : plot.panels)
    all.push_back(element(kPanelWidth, kPanelHeight,
                          fmt::format("{}: {} against {}", panel.name, plot.y_label, plot.x_label),
                          content(plot, panel)));
  return all;
}

std::string svg(const Plot& plot) {
  const int count = static_cast<int>(plot.panels.size());
  std::string inside;
  for (int i = 0; i < count; ++i)
    inside +=
        fmt::format("<g transform=\"translate({} {})\">\n{}</g>\n", kPanelWidth * (i % kColumns),
                    kPanelHeight * (i / kColumns), content(plot, plot.panels[static_cast<std::size_t>(i)]));
  return element(kPanelWidth * std::min(count, kColumns), kPanelHeight * ((count + kColumns - 1) / kColumns),
                 fmt::format("{} against {}", plot.y_label, plot.x_label), inside);
}

}  // namespace texel::commands
