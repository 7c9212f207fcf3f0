// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace texel::commands {

/// Small plots side by side, drawn as SVG. All have the same two logarithmic axes, and a name beside each
/// dot.
struct Plot {
  struct Point {
    double x = 0, y = 0;                     ///< x must be positive; y = 0 lies on the lower edge
    std::size_t color = 0;                   ///< one of eight, counted from 0
    bool filled = false;                     ///< on the front
    std::string label;                       ///< beside the dot, or ""
    std::string title;                       ///< what hovering shows, lines
    std::vector<std::string> pictures = {};  ///< files that the page shows beside the title
  };
  struct Line {
    std::vector<std::size_t> points;   ///< of its panel, joined in this order
    std::optional<std::size_t> color;  ///< grey without one
  };
  struct Panel {
    std::string name;
    std::vector<Point> points;
    std::vector<Line> lines;
    bool is_hard = false;
  };
  std::string x_label, y_label;
  std::vector<Panel> panels;
};

/// Each panel as an <svg> element of its own, 340 units wide. The colours are the page's custom properties
/// --ink, --quiet, --line and --card, with light defaults.
std::vector<std::string> panel_svgs(const Plot& plot);

/// All panels in one <svg> element, three in a row: a picture for a document.
std::string svg(const Plot& plot);

}  // namespace texel::commands
