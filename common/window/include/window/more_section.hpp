// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <string>

#include "app/canvas.hpp"

namespace texel::window {

/// A section of the panel that only some trees have: teach/bench adds error and cost of the methods.
class MoreSection {
 public:
  virtual ~MoreSection() = default;
  /// Draws it with ImGui for one frame; may change parameters. Returns whether it is open.
  virtual bool draw(float scale) = 0;
  /// While it is open: goes on for about a frame's time with what it shows; the parameters stay as they are.
  /// Returns how far it is, "" once all is done.
  virtual std::string work(glm::ivec2 picture_size) = 0;
  /// Shaders or files have changed.
  virtual void forget() = 0;

  /// Null where the tree has none; returns null where the lab has none.
  static inline std::unique_ptr<MoreSection> (*make)(gl::Context& context, const app::Assets& assets,
                                                     app::AnyLab& lab) = nullptr;
};

}  // namespace texel::window
