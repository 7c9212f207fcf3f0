// SPDX-License-Identifier: MIT
// Step 3.5. A texture coordinate where the file has none: the longitude and latitude of a direction.
#include "mesh/texcoords.hpp"

#include <cmath>
#include <numbers>

namespace texel::mesh {

glm::vec2 spherical_texcoord(const glm::vec3& from_center) {
  //@step 3.5 begin
  const glm::dvec3 d(from_center);
  const double longitude = std::atan2(d.x, d.z);                  // -pi..pi, 0 at +z
  const double latitude = std::atan2(d.y, std::hypot(d.x, d.z));  // -pi/2..pi/2
  const double s = longitude / (2.0 * std::numbers::pi);
  return {s < 0.0 ? s + 1.0 : s, latitude / std::numbers::pi + 0.5};
  //@starter
  // return {};
  //@end
}

}  // namespace texel::mesh
