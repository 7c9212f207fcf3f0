// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <optional>
#include <string>

#include "app/lab.hpp"
#include "app/legend.hpp"
#include "gl/context.hpp"
#include "gl/recorder.hpp"
#include "gl/target.hpp"

namespace texel::app {

/// Draws a lab into a framebuffer object: the one path for the window, snapshots, batches and the pixel
/// inspector.
class Canvas {
 public:
  Canvas(gl::Context& context, const Assets& assets, AnyLab& lab)
      : context_(context), assets_(assets), lab_(lab), programs_(assets.shader_root()) {}
  /// The lab's OpenGL objects go while their context is still there.
  ~Canvas() { lab_.forget(); }
  Canvas& operator=(Canvas&&) = delete;

  /// Another value of one parameter right of a vertical line: `position` from 0 (left edge) to 1.
  struct Split {
    std::string parameter, value;
    float position = 0.5F;
    bool operator==(const Split&) const = default;
  };

  /// Draws the triangles' edges over the colours from now on, or no longer. Not in a browser.
  void show_edges(bool on) { edges_ = on; }

  /// Draws the lab with its present parameters. Afterwards one of the read functions, or texture(), has the
  /// picture. Throws Error for shaders that do not compile, files that do not load and whatever OpenGL calls
  /// an error. `colours` is the kind of target for the view `color`.
  void draw(View view, glm::ivec2 size, int samples, const std::optional<Split>& split = {},
            gl::Target::Kind colors = gl::Target::Kind::color);

  /// A picture of the background alone: for a view that cannot be drawn.
  void draw_nothing(glm::ivec2 size);

  /// As draw, and says what was drawn.
  gl::Record record(View view, glm::ivec2 size, int samples);

  /// The picture as 8-bit sRGB, RGBA. A data view is shown in colours (shaders/app/present.frag).
  [[nodiscard]] image::Image8 read8() const { return picture_->read8(); }
  /// The picture itself, which must have been drawn.
  [[nodiscard]] const gl::Target& picture() const { return *picture_; }
  /// The values of a data view: RGBA, alpha 1 where the scene is and 0 where the background is.
  [[nodiscard]] image::ImageF read_float() const {
    return measured_ ? measured_->error : data_->read_float();
  }
  /// Of the last picture, when it was the view `error`; else null.
  [[nodiscard]] const ErrorFigures* error_figures() const {
    return measured_ ? &measured_->figures : nullptr;
  }
  /// How the colours of the last picture, of the data view `view`, are read.
  [[nodiscard]] Legend legend(View view) const;
  /// What the lab said of the last picture.
  [[nodiscard]] const Notes& notes() const { return notes_; }
  /// A data view's values, as read_float() after draw() has them; of `color` the levels of the picture with
  /// one sample a pixel, alpha 1 on the object. The picture stays as it is.
  [[nodiscard]] image::ImageF values_of(View view, glm::ivec2 size);
  /// The value of a data view at one pixel of the picture, counted from the bottom left.
  [[nodiscard]] glm::vec4 value_at(View view, glm::ivec2 size, glm::ivec2 pixel);
  /// The textures that the lab reads for its colours; the picture stays as it is.
  [[nodiscard]] std::vector<gl::Record::TextureUse> textures(glm::ivec2 size);

  /// Copies the 8-bit picture into the window's framebuffer, as large as it fits into `size` pixels, in the
  /// middle. Does nothing before the first picture.
  void copy_to_window(glm::ivec2 origin, glm::ivec2 size) const;

  [[nodiscard]] gl::ProgramCache& programs() { return programs_; }
  [[nodiscard]] const Assets& assets() const { return assets_; }
  [[nodiscard]] gl::Context& context() const { return context_; }

 private:
  void draw_into(const gl::Target& target, View view, const std::optional<Split>& split);
  const gl::Target& draw_scene(View view, glm::ivec2 size, int samples = 1,
                               const std::optional<Split>& split = {},
                               gl::Target::Kind colors = gl::Target::Kind::color);
  void finish(View view, glm::ivec2 size);
  gl::Target& fit(std::unique_ptr<gl::Target>& target, gl::Target::Kind kind, glm::ivec2 size, int samples);

  gl::Context& context_;
  const Assets& assets_;
  AnyLab& lab_;
  gl::ProgramCache programs_;
  std::unique_ptr<gl::Target> picture_;  ///< the last that succeeded
  std::unique_ptr<gl::Target> color_;    ///< the one being drawn
  std::unique_ptr<gl::Target> data_;
  gl::VertexArray no_attributes_;

  Notes notes_;
  bool edges_ = false;
  std::optional<Measured> measured_;  ///< when the last picture was the view `error`
};

}  // namespace texel::app
