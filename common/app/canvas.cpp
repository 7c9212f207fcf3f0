// SPDX-License-Identifier: MIT
#include "app/canvas.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>

#include "app/settings.hpp"
#include "core/error.hpp"
#include "gl/upload.hpp"
#include "image/color.hpp"

namespace texel::app {
namespace {

/// Background of colour pictures, linear light: a dark slate on which both black and white textures are seen.
constexpr glm::vec4 kBackground(0.035F, 0.042F, 0.055F, 1);
/// Of data views, whose alpha is the object's mask.
constexpr glm::vec4 kNothing(0);

const glm::vec4& background_of(const gl::Target& target) {
  return target.kind() == gl::Target::Kind::data ? kNothing : kBackground;
}

void bind_and_clear(const gl::Target& target) {
  target.bind();
  glDisable(GL_SCISSOR_TEST);
  glEnable(GL_FRAMEBUFFER_SRGB);
  const glm::vec4& background = background_of(target);
  glClearColor(background.r, background.g, background.b, background.a);
  glDepthMask(GL_TRUE);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
}

}  // namespace

gl::Target& Canvas::fit(std::unique_ptr<gl::Target>& target, gl::Target::Kind kind, glm::ivec2 size,
                        int samples) {
  if (!target || target->kind() != kind || target->width() != size.x || target->height() != size.y ||
      target->samples() != samples)
    target = std::make_unique<gl::Target>(kind, size.x, size.y, samples, picture_.get());
  return *target;
}

void Canvas::draw_into(const gl::Target& target, View view, const std::optional<Split>& split) {
  static_cast<void>(context_.take_errors());  // of a frame that was broken off
  bind_and_clear(target);

  const glm::ivec2 size(target.width(), target.height());
  const auto draw_lab = [&](bool as_edges = false) {
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    glDisable(GL_CULL_FACE);
    glDisable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    glEnable(GL_FRAMEBUFFER_SRGB);
    gl::unbind_textures();
    Frame frame(size, view, lab_.parameters(), assets_, programs_);
    if (as_edges) {  // the inverse of what is below, whatever the lab's colours are
      glDisable(GL_FRAMEBUFFER_SRGB);
      glDepthFunc(GL_LEQUAL);
    }
    lab_.draw(frame);
    frame.check();
    notes_ = frame.notes();
  };
  const auto draw_once = [&] {
    draw_lab();
    if (!edges_ || view != View::color) return;
    glEnable(GL_COLOR_LOGIC_OP);
    glLogicOp(GL_INVERT);
    // Once each: an edge is drawn with both of its triangles, and twice inverted is as before.
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_EQUAL, 0, ~0U);
    glStencilOp(GL_KEEP, GL_KEEP, GL_INCR);
    glEnable(GL_POLYGON_OFFSET_LINE);
    glPolygonOffset(-1, -1);
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    draw_lab(true);  // what the first time has done cannot fail
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glDisable(GL_POLYGON_OFFSET_LINE);
    glDisable(GL_COLOR_LOGIC_OP);
    glDisable(GL_STENCIL_TEST);
  };
  if (!split) {
    draw_once();
  } else {
    const int border = static_cast<int>(std::lround(split->position * static_cast<float>(size.x)));
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, border, size.y);
    draw_once();
    const KeptValues left(lab_.parameters());
    lab_.parameters().at(split->parameter).set(split->value);
    glScissor(border, 0, size.x - border, size.y);
    draw_once();
    glDisable(GL_SCISSOR_TEST);
  }
  target.resolve();
  if (const std::vector<std::string> errors = context_.take_errors(); !errors.empty()) {
    // Mesa says "GL_INVALID_VALUE in glUniform1i(why)": the call is the place.
    const std::string& said = errors.front();
    const std::size_t why = std::min(said.find('('), said.size());
    throw Error::failed("OpenGL refused this call " + said.substr(why), {said.substr(0, why)});
  }
}

void Canvas::draw(View view, glm::ivec2 size, int samples, const std::optional<Split>& split,
                  gl::Target::Kind colors) {
  ++present_frame;
  measured_.reset();
  if (view == View::error) {
    measured_ = lab_.answer()->measured(*this, size);
    fit(color_, gl::Target::Kind::color, size, 1).write8(measured_->map);
    std::swap(picture_, color_);
  } else {
    draw_scene(view, size, samples, split, colors);
    finish(view, size);
  }
}

gl::Record Canvas::record(View view, glm::ivec2 size, int samples) {
  ++present_frame;
  gl::Record record;
  {
    gl::Recorder recorder;  // of the lab's own draw calls
    const gl::Target& target = draw_scene(view == View::error ? View::color : view, size, samples);
    record = recorder.take();
    if (record.draw_calls > 0 && target.shows_only(background_of(target)))
      record.warnings.emplace_back(
          "nothing is visible: all triangles are outside the view, culled, behind other triangles, or "
          "have the background's colour");
  }
  if (view == View::error)
    draw(view, size, samples);
  else
    finish(view, size);
  return record;
}

const gl::Target& Canvas::draw_scene(View view, glm::ivec2 size, int samples,
                                     const std::optional<Split>& split, gl::Target::Kind colors) {
  // Values are not averaged over a pixel: half a normal and half a background is neither.
  const gl::Target& target =
      view == View::color ? fit(color_, colors, size, samples) : fit(data_, gl::Target::Kind::data, size, 1);
  draw_into(target, view, split);
  return target;
}

void Canvas::finish(View view, glm::ivec2 size) {
  if (view != View::color) {
    const gl::Target& shown = fit(color_, gl::Target::Kind::color, size, 1);
    gl::Program& program = programs_.get("app/present.vert", "app/present.frag", constants({}, view));
    shown.bind();
    program.use();
    gl::bind(0, GL_TEXTURE_2D, data_->texture());
    program.set("values", 0);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    glDisable(GL_FRAMEBUFFER_SRGB);  // the colours of present.frag are encoded already
    glBindVertexArray(no_attributes_.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
  }
  std::swap(picture_, color_);
}

Legend Canvas::legend(View view) const {
  if (view == View::error) return error_legend(measured_->full_scale, lab_.answer()->measure().unit);
  const bool has_range = view == View::lod || view == View::depth;
  return legend_of(view, lab_.parameters(), has_range ? read_float() : image::ImageF());
}

void Canvas::draw_nothing(glm::ivec2 size) {
  bind_and_clear(fit(color_, gl::Target::Kind::color, size, 1));
  std::swap(picture_, color_);
}

void Canvas::copy_to_window(glm::ivec2 origin, glm::ivec2 size) const {
  if (!picture_) return;
  const glm::vec2 own(picture_->width(), picture_->height());
  const glm::vec2 room = glm::vec2(size) / own;
  const glm::ivec2 shown(glm::round(own * std::min(room.x, room.y)));
  const glm::ivec2 from = origin + (size - shown) / 2, to = from + shown;
  picture_->bind_for_reading();
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  glDisable(GL_FRAMEBUFFER_SRGB);  // the bytes as they are
  glDisable(GL_SCISSOR_TEST);
  if (shown != size) {
    using image::srgb_from_linear;
    glClearColor(srgb_from_linear(kBackground.r), srgb_from_linear(kBackground.g),
                 srgb_from_linear(kBackground.b), 1);
    glClear(GL_COLOR_BUFFER_BIT);
  }
  glBlitFramebuffer(0, 0, picture_->width(), picture_->height(), from.x, from.y, to.x, to.y,
                    GL_COLOR_BUFFER_BIT, GL_LINEAR);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

image::ImageF Canvas::values_of(View view, glm::ivec2 size) {
  image::ImageF values = draw_scene(view == View::color ? View::mask : view, size).read_float();
  if (view != View::color) return values;
  // Colours are compared as they are seen: in levels of the encoded picture, inside the object's mask.
  const image::Image8 shown = draw_scene(view, size).read8();
  for (std::size_t i = 0; i < shown.samples.size(); ++i)
    if (i % 4 != 3) values.samples[i] = shown.samples[i];
  return values;
}

glm::vec4 Canvas::value_at(View view, glm::ivec2 size, glm::ivec2 pixel) {
  return glm::make_vec4(&values_of(view, size).at(pixel.x, pixel.y));
}

std::vector<gl::Record::TextureUse> Canvas::textures(glm::ivec2 size) {
  gl::Recorder recorder;
  draw_into(fit(data_, gl::Target::Kind::data, size, 1), View::color, {});
  return recorder.take().textures;
}

}  // namespace texel::app
