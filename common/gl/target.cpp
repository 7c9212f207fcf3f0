// SPDX-License-Identifier: MIT
#include "gl/target.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "core/error.hpp"
#include "core/stages.hpp"
#include "gl/upload.hpp"
#include "image/color.hpp"

namespace texel::gl {

Target::Target(Kind kind, int width, int height, int samples, const Target* other)
    : kind_(kind), width_(width), height_(height) {
  const GLint largest = integer(GL_MAX_RENDERBUFFER_SIZE);
  if (width > largest || height > largest)
    throw Error::failed(fmt::format("a picture of {}x{} is larger than this renderer's maximum, {}x{}", width,
                                    height, largest, largest),
                        {}, "choose a smaller --size");
  samples_ = std::clamp(samples, 1, std::max(integer(GL_MAX_SAMPLES), 1));
  const GLenum format = kind == Kind::data ? GL_RGBA32F : kind == Kind::encoded ? GL_RGBA8 : GL_SRGB8_ALPHA8;

  const ScopedBinding binding(GL_TEXTURE_2D, texture_);
  glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), width, height, 0, GL_RGBA,
               kind == Kind::data ? GL_FLOAT : GL_UNSIGNED_BYTE, nullptr);
  set_sampling(GL_TEXTURE_2D, {GL_NEAREST, GL_NEAREST, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_EDGE});
  glBindFramebuffer(GL_FRAMEBUFFER, resolved_.id());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_.id(), 0);
  if (other != nullptr && other->kind_ == kind && other->width_ == width && other->height_ == height &&
      other->samples_ == samples_) {
    scratch_ = other->scratch_;
  } else {
    scratch_ = std::make_shared<Scratch>();
    const GLsizei stored = samples_ > 1 ? samples_ : 0;
    glBindRenderbuffer(GL_RENDERBUFFER, scratch_->depth.id());
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, stored, GL_DEPTH24_STENCIL8, width, height);
    if (samples_ > 1) {
      glBindFramebuffer(GL_FRAMEBUFFER, scratch_->multisampled.id());
      glBindRenderbuffer(GL_RENDERBUFFER, scratch_->color.id());
      glRenderbufferStorageMultisample(GL_RENDERBUFFER, stored, format, width, height);
      glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, scratch_->color.id());
    }
  }
  bind();
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER,
                            scratch_->depth.id());
  const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
  if (status != GL_FRAMEBUFFER_COMPLETE)
    throw Error::failed(fmt::format("this renderer cannot draw into a {}x{} {} picture (0x{:04x})", width,
                                    height, kind == Kind::data ? "float" : "8-bit", status));
}

void Target::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, samples_ > 1 ? scratch_->multisampled.id() : resolved_.id());
  glViewport(0, 0, width_, height_);
}

void Target::resolve() const {
  if (samples_ == 1) return;
  glDisable(GL_SCISSOR_TEST);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, scratch_->multisampled.id());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_.id());
  glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

image::Image8 Target::read8() const {
  const Stage stage("read");
  image::Image8 image(width_, height_, 4);
  bind_for_reading();
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, image.samples.data());
  return image;
}

bool Target::shows_only(const glm::vec4& color) const {
  const image::Encoding encoding = kind_ == Kind::data ? image::Encoding::linear : image::Encoding::srgb;
  int steps[4];
  for (int c = 0; c < 4; ++c)
    steps[c] = image::to_encoding8(color[c], c < 3 ? encoding : image::Encoding::linear);
  const image::Image8 picture = read8();
  for (std::size_t i = 0; i < picture.samples.size(); ++i)
    if (std::abs(picture.samples[i] - steps[i % 4]) > 1) return false;
  return true;
}

image::ImageF Target::read_float() const {
  const Stage stage("read");
  image::ImageF image(width_, height_, 4);
  bind_for_reading();
  glReadPixels(0, 0, width_, height_, GL_RGBA, GL_FLOAT, image.samples.data());
  return image;
}

void Target::write8(const image::Image8& image) const {
  const ScopedBinding binding(GL_TEXTURE_2D, texture_);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, image.samples.data());
}

}  // namespace texel::gl
