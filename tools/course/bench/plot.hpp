// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

namespace texel::tools {

/// A plot with logarithmic axes, drawn as SVG: numbered dots in the colours of their series.
struct Plot {
  struct Point {
    double x = 0, y = 0;  ///< x must be positive; y = 0 lies on the lower edge
    std::string label;    ///< in the dot, short
    std::string title;    ///< what hovering shows, lines
    bool filled = false;  ///< on the front
  };
  struct Series {
    std::string name;
    std::vector<Point> points;
    bool line = false;  ///< joins the filled points
  };
  std::string x_label, y_label;
  std::vector<Series> series;       ///< eight colours
  std::vector<std::string> legend;  ///< what the dots' labels stand for, one a line
};

/// The whole picture as an <svg> element, 960 units wide. Its colours are the page's custom properties --ink,
/// --quiet, --line and --card, with light defaults: the plot also works as a separate file.
std::string svg(const Plot& plot);

}  // namespace texel::tools
