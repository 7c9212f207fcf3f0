// SPDX-License-Identifier: MIT
#pragma once
#include <glad/gl.h>

#include <set>
#include <string>
#include <vector>

#include "gl/objects.hpp"

namespace texel::gl {

/// What a frame drew, read from OpenGL itself at each draw call, not from the lab. Nothing is
/// counted by a query: for that llvmpipe compiles every shader again (200 ms) and waits for each draw call.
struct Record {
  struct AttributeUse {
    std::string name;
    long long bytes = 0;
    bool operator==(const AttributeUse&) const = default;
  };
  struct TextureUse {
    std::string name;  ///< the sampler that reads it
    GLuint id = 0;
    bool is_cube = false;
    int width = 0, height = 0, levels = 0;  ///< that it has
    std::string format = {};
    long long bytes = 0;  ///< all levels and faces
    bool operator==(const TextureUse&) const = default;
  };
  long long vertices = 0, triangles = 0;
  int draw_calls = 0;
  long long index_bytes = 0;
  std::vector<AttributeUse> attributes;
  std::vector<TextureUse> textures;
  /// Why something is invisible: incomplete mipmaps, a unit without a texture, …
  std::vector<std::string> warnings;
};

/// While it lives, it records every glDrawArrays and glDrawElements: it replaces the function
/// pointers that glad loaded. One at a time.
class Recorder {
 public:
  Recorder();
  ~Recorder();
  Recorder& operator=(Recorder&&) = delete;
  /// What was drawn so far.
  [[nodiscard]] Record take();

 private:
  Record record_;
  std::set<GLint> index_buffers_;  ///< that were counted
  PFNGLDRAWARRAYSPROC draw_arrays_;
  PFNGLDRAWELEMENTSPROC draw_elements_;
};

}  // namespace texel::gl
