// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "app/canvas.hpp"

namespace texel::bench {

/// Error and cost of each of the lab's methods with the present parameters, measured a little at a time. For
/// a lab with a parameter `method` and the view `error`.
class MethodPlot {
 public:
  static constexpr int kHeight = 256;  ///< of the pictures that are measured, in pixels
  static constexpr int kRounds = 9;    ///< each method is timed so often

  struct Point {
    std::string method;
    app::ErrorFigures error;
    double milliseconds = 0;       ///< a frame: median of the rounds so far
    bool has_error = false;        ///< with the present parameters
    std::vector<double> frame_ns;  ///< one a round
  };

  [[nodiscard]] static bool is_for(app::AnyLab& lab);

  MethodPlot(gl::Context& context, const app::Assets& assets, app::AnyLab& lab);

  /// Goes on for about a frame's time, and begins again when a parameter (but not the method) or the
  /// picture's shape has changed. The parameters stay as they are.
  void measure_next(glm::ivec2 picture_size);
  /// How much of the work is done, 0 to 1.
  [[nodiscard]] double share() const;
  /// Shaders or files have changed.
  void forget();

  /// All methods, in their order. While a new look is measured, what is known is still that of the last one.
  [[nodiscard]] const std::vector<Point>& points() const { return points_; }
  [[nodiscard]] const std::optional<app::Measure>& measure() const { return measure_; }
  [[nodiscard]] glm::ivec2 size() const { return size_; }
  /// Why there is nothing to measure, or "".
  [[nodiscard]] const std::string& fault() const { return fault_; }

 private:
  void begin_again(const std::string& look);
  void measure_error(Point& point);
  void time_frame(Point& point);

  app::AnyLab& lab_;
  app::Canvas canvas_;  // the window's own keeps its picture
  std::vector<Point> points_;
  std::optional<app::Measure> measure_;
  std::string look_, fault_;
  glm::ivec2 size_{0};
  std::size_t done_ = 0;  ///< errors, then frames
};

}  // namespace texel::bench
