// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>

#include "app/canvas.hpp"

namespace texel::window {

/// One turn of the model, or of the camera where the lab turns none, as pictures 000.png, 001.png, … in a
/// folder, one a call.
class Turntable {
 public:
  static constexpr int kPictures = 36;  ///< every 10 degrees

  /// Makes the folder. Throws Error (exit 3) when it cannot.
  explicit Turntable(std::filesystem::path folder);
  /// Draws and writes the next picture; the parameters stay as they are. Throws Error as Canvas::draw and
  /// Snapshot::write.
  void write_next(app::Canvas& canvas, app::AnyLab& lab, app::View view, glm::ivec2 size, int samples);
  [[nodiscard]] int written() const { return written_; }
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_;
  int written_ = 0;
};

}  // namespace texel::window
