// SPDX-License-Identifier: MIT
// The plot of the methods: error against cost, each point with its name.
#include <fmt/format.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

#include "bench/method_plot.hpp"
#include "window/gui.hpp"
#include "window/more_section.hpp"

namespace texel::bench {
namespace {

using window::theme;
using window::wrapped_text;

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

/// A method on the screen.
struct Dot {
  const MethodPlot::Point* point;
  ImVec2 at;
  ImRect label{};
};

ImRect around(ImVec2 at, float reach) {
  return {at.x - reach, at.y - reach, at.x + reach, at.y + reach};
}

/// Beside its dot, or as near as it finds room between the other dots and names.
void place_labels(std::vector<Dot>& dots, const ImRect& area, float reach) {
  const float line = ImGui::GetTextLineHeight();
  std::vector<ImRect> taken;
  for (const Dot& dot : dots) taken.push_back(around(dot.at, reach));
  for (Dot& dot : dots) {
    const float width = ImGui::CalcTextSize(dot.point->method.c_str()).x;
    const auto beside = [&](int place) {  // right and left, then half a line lower and higher, and so on
      const float left = place % 2 == 0 ? dot.at.x + 1.5F * reach : dot.at.x - 1.5F * reach - width;
      const float down = (place / 2 % 2 == 0 ? 0.5F : -0.5F) * static_cast<float>(place / 4);
      const float top = dot.at.y - line / 2 + down * line;
      return ImRect(left, top, left + width, top + line);
    };
    constexpr int kPlaces = 96;
    int place = 0;
    while (place < kPlaces &&
           (!area.Contains(beside(place)) ||
            std::ranges::any_of(taken, [&](const ImRect& other) { return other.Overlaps(beside(place)); })))
      ++place;
    dot.label = beside(place < kPlaces ? place : 0);
    taken.push_back(dot.label);
  }
}

void grid(const Axis& x, const Axis& y, const ImRect& area) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 text = ImGui::GetColorU32(theme().dim), line = ImGui::GetColorU32(ImGuiCol_FrameBg);
  const float height = ImGui::GetTextLineHeight();
  float last = -1e9F;
  for (const double tick : x.ticks()) {
    const float at = x.at(tick);
    list.AddLine({at, area.Min.y}, {at, area.Max.y}, line);
    const std::string label = fmt::format("{:g}", tick);
    const float width = ImGui::CalcTextSize(label.c_str()).x;
    if (at - width / 2 < last || at + width / 2 > area.Max.x) continue;
    list.AddText({at - width / 2, area.Max.y + height * 0.1F}, text, label.c_str());
    last = at + width / 2 + height * 0.4F;
  }
  last = 1e9F;
  for (const double tick : y.ticks()) {
    const float at = y.at(tick);
    list.AddLine({area.Min.x, at}, {area.Max.x, at}, line);
    if (at + height / 2 > last) continue;
    const std::string label = fmt::format("{:g}", tick);
    list.AddText({area.Min.x - height * 0.4F - ImGui::CalcTextSize(label.c_str()).x, at - height / 2}, text,
                 label.c_str());
    last = at - height / 2;
  }
}

/// Methods are ranked by the mean of their errors; for colours by the root mean square, in which few pixels
/// that are far off weigh as much as one sees them.
bool ranks_by_rms(const app::Measure& measure) {
  return measure.unit == app::Unit::steps;
}

double error_of(const MethodPlot::Point& point, const app::Measure& measure) {
  return ranks_by_rms(measure) ? point.error.rms : point.error.mean;
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
  const ImRect area(at.x + 3.2F * em, at.y + 0.3F * em, at.x + size.x, at.y + size.y - 1.3F * em);
  ImGui::InvisibleButton("##plot", size);
  const bool is_hovered = ImGui::IsItemHovered(), is_clicked = ImGui::IsItemClicked();

  std::vector<Dot> dots;
  double cheapest = 1e9, dearest = 0, largest = 0;
  for (const MethodPlot::Point& point : methods.points()) {
    if (point.milliseconds <= 0) continue;  // not measured yet
    dots.push_back({&point, {}});
    cheapest = std::min(cheapest, point.milliseconds), dearest = std::max(dearest, point.milliseconds);
    largest = std::max(largest, error_of(point, measure));
  }
  if (largest == 0) largest = 1;
  // What is a thousand times better than another method lies at the lower end.
  double least = largest;
  const auto shown = [&](const MethodPlot::Point& point) {
    return std::max(error_of(point, measure), largest * 1e-3);
  };
  for (const Dot& dot : dots) least = std::min(least, shown(*dot.point));
  const Axis x(cheapest, dearest, area.Min.x, area.Max.x), y(least, largest, area.Max.y, area.Min.y);
  grid(x, y, area);

  for (Dot& dot : dots) dot.at = {x.at(dot.point->milliseconds), y.at(shown(*dot.point))};
  place_labels(dots, area, reach);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  std::string clicked;
  for (const Dot& dot : dots) {
    const ImVec4& color = !dot.point->has_error             ? theme().dim
                          : dot.point->error.non_finite > 0 ? theme().wrong
                          : dot.point->method == present    ? theme().next
                                                            : theme().text;
    const ImU32 ink = ImGui::GetColorU32(color);
    const ImVec2 end(dot.label.Min.x > dot.at.x ? dot.label.Min.x : dot.label.Max.x, dot.label.GetCenter().y);
    if (std::abs(end.y - dot.at.y) > 1) list.AddLine(dot.at, end, ImGui::GetColorU32(theme().dim), scale);
    list.AddCircleFilled(dot.at, reach, ink);
    list.AddText(dot.label.Min, ink, dot.point->method.c_str());
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (!is_hovered || !(dot.label.Contains(mouse) || around(dot.at, 2 * reach).Contains(mouse))) continue;
    describe(*dot.point, name_of(measure.unit));
    if (is_clicked) clicked = dot.point->method;
  }
  return clicked;
}

class MethodsSection final : public window::MoreSection {
 public:
  MethodsSection(gl::Context& context, const app::Assets& assets, app::AnyLab& lab)
      : lab_(lab), methods_(context, assets, lab) {}

  bool draw(float scale) override {
    if (!ImGui::CollapsingHeader("Error and cost of the methods")) return false;
    if (!methods_.fault().empty())
      wrapped_text(theme().next, methods_.fault());
    else if (!methods_.measure())
      wrapped_text(theme().dim, "working out the exact answer");
    else
      show(scale);
    return true;
  }

  std::string work(glm::ivec2 picture_size) override {
    methods_.measure_next(picture_size);
    if (methods_.share() >= 1 || !methods_.fault().empty()) return "";
    return fmt::format("measuring the methods: {:.0f} %", 100 * methods_.share());
  }

  void forget() override { methods_.forget(); }

 private:
  void show(float scale) {
    const app::Measure& measure = *methods_.measure();
    ImGui::TextColored(theme().dim, "%s error in %s", ranks_by_rms(measure) ? "rms" : "mean",
                       name_of(measure.unit));
    params::Parameter& method = lab_.parameters().at("method");
    const std::string clicked = plot(methods_, method.text(), scale);
    if (!clicked.empty()) method.set(clicked);
    const std::string cost = fmt::format("ms a frame of {}x{}", methods_.size().x, methods_.size().y);
    const float right = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(cost.c_str()).x;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(right, 0.0F));
    ImGui::TextColored(theme().dim, "%s", cost.c_str());
  }

  app::AnyLab& lab_;
  MethodPlot methods_;
};

const bool section_is_known = [] {
  window::MoreSection::make = [](gl::Context& context, const app::Assets& assets,
                                 app::AnyLab& lab) -> std::unique_ptr<window::MoreSection> {
    if (!MethodPlot::is_for(lab)) return nullptr;
    return std::make_unique<MethodsSection>(context, assets, lab);
  };
  return true;
}();

}  // namespace
}  // namespace texel::bench
