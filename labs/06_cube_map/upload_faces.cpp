// SPDX-License-Identifier: MIT
// Step 6.3. Six pictures become one texture.
#include "upload_faces.hpp"

#include "gl/upload.hpp"
#include "image/mipmaps.hpp"

namespace texel::cube_map {

void upload_faces(const std::array<image::Image8, 6>& faces, bool mipmapped) {
  //@step 6.3 begin
  for (GLuint i = 0; i < 6; ++i) {
    const GLenum face = GL_TEXTURE_CUBE_MAP_POSITIVE_X + i;  // the six constants follow each other
    gl::upload_level(face, 0, faces[i], image::Encoding::srgb);
    if (!mipmapped) continue;
    const std::vector<image::Image8> levels = image::mip_chain(faces[i], image::Encoding::srgb);
    for (std::size_t level = 1; level < levels.size(); ++level)
      gl::upload_level(face, static_cast<int>(level), levels[level], image::Encoding::srgb);
  }
  //@starter
  // // The picture of +Z, called BACK, on every face, and only its full size.
  // for (GLenum face = GL_TEXTURE_CUBE_MAP_POSITIVE_X; face <= GL_TEXTURE_CUBE_MAP_NEGATIVE_Z; ++face)
  //   gl::upload_level(face, 0, faces[4], image::Encoding::srgb);
  // glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAX_LEVEL, 0);
  //@end
}

}  // namespace texel::cube_map
