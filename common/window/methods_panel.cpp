// SPDX-License-Identifier: MIT
// The plot of the methods: error against cost, each point with its name.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "panel.hpp"
#include "theme.hpp"

namespace texel::window {
namespace {

/// A logarithmic axis from one place on the screen to another.
class Axis {
 public:
  Axis(double least, double most, float from, float to) : from_(from), to_(to) {
    constexpr double kBeyond = 0.2, kShortest = 0.6;  // powers of ten
    const double missing = std::max(kShortest - std::log10(most / least), 0.0);
    least_ = std::log10(least) - kBeyond - missing / 2, most_ = std::log10(most) + kBeyond + missing / 2;
  }
  [[nodiscard]] float at(double value) const {
    return from_ + (to_ - from_) * static_cast<float>((std::log10(value) - least_) / (most_ - least_));
  }
  /// 1, 2 and 5 times the powers of ten; on a long axis the powers alone.
  [[nodiscard]] std::vector<double> ticks() const {
    std::vector<double> values;
    for (int power = static_cast<int>(std::floor(least_)); power <= most_; ++power)
      for (const double factor : {1.0, 2.0, 5.0}) {
        const double value = factor * std::pow(10.0, power), place = std::log10(value);
        if (place < least_ || place > most_ || (factor != 1 && most_ - least_ > 2)) continue;
        values.push_back(value);
      }
    return values;
  }

 private:
  double least_, most_;
  float from_, to_;
};

struct Rectangle {
  ImVec2 from, to;
  [[nodiscard]] bool meets(const Rectangle& o) const {
    return from.x < o.to.x && o.from.x < to.x && from.y < o.to.y && o.from.y < to.y;
  }
  [[nodiscard]] bool holds(const Rectangle& o) const {
    return o.from.x >= from.x && o.to.x <= to.x && o.from.y >= from.y && o.to.y <= to.y;
  }
  [[nodiscard]] bool holds(ImVec2 p) const {
    return p.x >= from.x && p.x < to.x && p.y >= from.y && p.y < to.y;
  }
};

/// A method on the screen.
struct Dot {
  const MethodPlot::Point* point;
  ImVec2 at;
  Rectangle label{};
};

Rectangle around(ImVec2 at, float reach) {
  return {{at.x - reach, at.y - reach}, {at.x + reach, at.y + reach}};
}

/// Beside its dot, or as near as it finds room between the other dots and names.
void place_labels(std::vector<Dot>& dots, const Rectangle& area, float reach) {
  const float line = ImGui::GetTextLineHeight();
  std::vector<Rectangle> taken;
  for (const Dot& dot : dots) taken.push_back(around(dot.at, reach));
  const auto fits = [&](const Rectangle& label) {
    return area.holds(label) &&
           std::ranges::none_of(taken, [&](const Rectangle& other) { return other.meets(label); });
  };
  for (Dot& dot : dots) {
    const float width = ImGui::CalcTextSize(dot.point->method.c_str()).x;
    const auto beside = [&](bool is_right, float down) {
      const float left = is_right ? dot.at.x + 1.5F * reach : dot.at.x - 1.5F * reach - width;
      const float top = dot.at.y - line / 2 + down;
      return Rectangle{{left, top}, {left + width, top + line}};
    };
    dot.label = beside(true, 0);
    bool is_placed = false;
    for (int step = 0; step < 24 && !is_placed; ++step)
      for (const float sign : {1.0F, -1.0F})
        for (const bool is_right : {true, false})
          if (const Rectangle label = beside(is_right, sign * line * 0.5F * static_cast<float>(step));
              !is_placed && fits(label)) {
            dot.label = label;
            is_placed = true;
          }
    taken.push_back(dot.label);
  }
}

void grid(const Axis& x, const Axis& y, const Rectangle& area) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 text = ImGui::GetColorU32(theme().dim), line = ImGui::GetColorU32(ImGuiCol_FrameBg);
  const float height = ImGui::GetTextLineHeight();
  float last = -1e9F;
  for (const double tick : x.ticks()) {
    const float at = x.at(tick);
    list.AddLine({at, area.from.y}, {at, area.to.y}, line);
    const std::string label = fmt::format("{:g}", tick);
    const float width = ImGui::CalcTextSize(label.c_str()).x;
    if (at - width / 2 < last || at + width / 2 > area.to.x) continue;
    list.AddText({at - width / 2, area.to.y + height * 0.1F}, text, label.c_str());
    last = at + width / 2 + height * 0.4F;
  }
  last = 1e9F;
  for (const double tick : y.ticks()) {
    const float at = y.at(tick);
    list.AddLine({area.from.x, at}, {area.to.x, at}, line);
    if (at + height / 2 > last) continue;
    const std::string label = fmt::format("{:g}", tick);
    list.AddText({area.from.x - height * 0.4F - ImGui::CalcTextSize(label.c_str()).x, at - height / 2}, text,
                 label.c_str());
    last = at - height / 2;
  }
}

double error_of(const MethodPlot::Point& point, const app::Measure& measure) {
  return app::ranks_by_rms(name_of(measure.unit)) ? point.error.rms : point.error.mean;
}

void describe(const MethodPlot::Point& point, const char* unit) {
  const app::ErrorFigures& e = point.error;
  std::string text = fmt::format("{}\nerror: rms {:.3g}, mean {:.3g}, P99 {:.3g} {}\ncost: {:.3g} ms a frame",
                                 point.method, e.rms, e.mean, e.p99, unit, point.milliseconds);
  if (e.coverage() < 1) text.append(fmt::format("\ncovers {:.1f} % of the truth", 100 * e.coverage()));
  if (e.non_finite > 0) text.append(fmt::format("\n{} pixels are not finite", e.non_finite));
  ImGui::SetTooltip("%s", text.c_str());
}

/// Draws it in the room that is left; returns the method that was clicked, or "".
std::string plot(const MethodPlot& methods, const std::string& present, float scale) {
  const app::Measure& measure = *methods.measure();
  const float em = ImGui::GetFontSize(), reach = 4 * scale;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 size(ImGui::GetContentRegionAvail().x, 14 * em);
  const Rectangle area{{at.x + 3.2F * em, at.y + 0.3F * em}, {at.x + size.x, at.y + size.y - 1.3F * em}};
  ImGui::InvisibleButton("##plot", size);
  const bool is_hovered = ImGui::IsItemHovered(), is_clicked = ImGui::IsItemClicked();

  std::vector<const MethodPlot::Point*> known;
  for (const MethodPlot::Point& point : methods.points())
    if (point.milliseconds > 0) known.push_back(&point);
  double cheapest = 1e9, dearest = 0, largest = 0;
  for (const MethodPlot::Point* point : known) {
    cheapest = std::min(cheapest, point->milliseconds), dearest = std::max(dearest, point->milliseconds);
    largest = std::max(largest, error_of(*point, measure));
  }
  if (largest == 0) largest = 1;
  // What is a thousand times better than another method lies at the lower end.
  double least = largest;
  const auto shown = [&](const MethodPlot::Point& point) {
    return std::max(error_of(point, measure), largest * 1e-3);
  };
  for (const MethodPlot::Point* point : known) least = std::min(least, shown(*point));
  const Axis x(cheapest, dearest, area.from.x, area.to.x), y(least, largest, area.to.y, area.from.y);
  grid(x, y, area);

  std::vector<Dot> dots;
  for (const MethodPlot::Point* point : known)
    dots.push_back({point, {x.at(point->milliseconds), y.at(shown(*point))}});
  place_labels(dots, area, reach);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  std::string clicked;
  for (const Dot& dot : dots) {
    const ImVec4& color = !dot.point->has_error             ? theme().dim
                          : dot.point->error.non_finite > 0 ? theme().wrong
                          : dot.point->method == present    ? theme().next
                                                            : theme().text;
    const ImU32 ink = ImGui::GetColorU32(color);
    const ImVec2 end(dot.label.from.x > dot.at.x ? dot.label.from.x : dot.label.to.x,
                     (dot.label.from.y + dot.label.to.y) / 2);
    if (std::abs(end.y - dot.at.y) > 1) list.AddLine(dot.at, end, ImGui::GetColorU32(theme().dim), scale);
    list.AddCircleFilled(dot.at, reach, ink);
    list.AddText(dot.label.from, ink, dot.point->method.c_str());
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (!is_hovered || !(dot.label.holds(mouse) || around(dot.at, 2 * reach).holds(mouse))) continue;
    describe(*dot.point, name_of(measure.unit));
    if (is_clicked) clicked = dot.point->method;
  }
  return clicked;
}

}  // namespace

void methods_section(app::AnyLab& lab, WindowState& state, float scale) {
  state.methods_open = MethodPlot::is_for(lab) && ImGui::CollapsingHeader("Error and cost of the methods");
  if (!state.methods_open || !state.methods) return;
  const MethodPlot& methods = *state.methods;
  if (!methods.fault().empty()) {
    ImGui::PushTextWrapPos(0);
    ImGui::TextColored(theme().next, "%s", methods.fault().c_str());
    ImGui::PopTextWrapPos();
    return;
  }
  if (!methods.measure()) {
    ImGui::TextColored(theme().dim, "working out the exact answer");
    return;
  }
  const char* unit = name_of(methods.measure()->unit);
  ImGui::TextColored(theme().dim, "%s error in %s", app::ranks_by_rms(unit) ? "rms" : "mean", unit);
  params::Parameter& method = lab.parameters().at("method");
  const std::string clicked = plot(methods, method.text(), scale);
  if (!clicked.empty()) method.set(clicked);
  const std::string cost = fmt::format("ms a frame of {}x{}", methods.size().x, methods.size().y);
  const float right = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(cost.c_str()).x;
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(right, 0.0F));
  ImGui::TextColored(theme().dim, "%s", cost.c_str());
}

}  // namespace texel::window
