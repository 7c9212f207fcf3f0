// SPDX-License-Identifier: MIT
#pragma once
#include <glm/vec4.hpp>
#include <memory>

#include "gl/objects.hpp"
#include "image/image.hpp"

namespace texel::gl {

/// A framebuffer object to draw into: colour as GL_SRGB8_ALPHA8 (with GL_FRAMEBUFFER_SRGB on, linear values
/// are encoded as they are written), encoded colour as GL_RGBA8 (shaders encode; a pixel's samples are
/// averaged as they are encoded) or GL_RGBA32F for data, with a buffer of depth and stencil.
class Target {
 public:
  enum class Kind { color, encoded, data };

  /// `samples` above 1 draws multisampled (at most the driver's maximum) and resolves. If `other` has the
  /// same kind, size and samples, both share depth and samples, which nobody reads after resolve(): that
  /// saves memory, and by the processor's caches a fifth of lab 1's time.
  Target(Kind kind, int width, int height, int samples, const Target* other = nullptr);

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] int samples() const { return samples_; }
  [[nodiscard]] Kind kind() const { return kind_; }

  /// Makes it the framebuffer and its whole area the viewport.
  void bind() const;
  /// After drawing: averages the samples, so that texture() and read…() have the picture.
  void resolve() const;
  /// Makes the resolved picture the framebuffer that is read.
  void bind_for_reading() const { glBindFramebuffer(GL_READ_FRAMEBUFFER, resolved_.id()); }
  /// The resolved picture.
  [[nodiscard]] const Texture& texture() const { return texture_; }
  /// The resolved picture in memory; RGBA.
  [[nodiscard]] image::Image8 read8() const;
  [[nodiscard]] image::ImageF read_float() const;
  /// Whether every pixel of the resolved picture is `colour`, RGBA in linear light, within one 8-bit level.
  [[nodiscard]] bool shows_only(const glm::vec4& color) const;
  /// Replaces the resolved picture of a colour target by one in memory, RGBA of the same size.
  void write8(const image::Image8& image) const;

 private:
  Kind kind_;
  int width_, height_, samples_;
  Texture texture_;
  Framebuffer resolved_;
  struct Scratch {
    Renderbuffer depth, color;  ///< the second, and the framebuffer, for more than one sample
    Framebuffer multisampled;
  };
  std::shared_ptr<Scratch> scratch_;
};

}  // namespace texel::gl
