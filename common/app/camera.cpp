// SPDX-License-Identifier: MIT
#include "app/camera.hpp"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace texel::app {

glm::vec3 direction_from_angles(float yaw, float pitch) {
  const float a = glm::radians(yaw), b = glm::radians(pitch);
  return {std::sin(a) * std::cos(b), std::sin(b), std::cos(a) * std::cos(b)};
}

glm::mat4 turn_about_y(float degrees) {
  return glm::rotate(glm::mat4(1), glm::radians(degrees), glm::vec3(0, 1, 0));
}

glm::mat4 tilt_about_x(float degrees) {
  return glm::rotate(glm::mat4(1), glm::radians(degrees), glm::vec3(1, 0, 0));
}

glm::mat4 OrbitCamera::view_from_world() const {
  return glm::lookAt(eye(), glm::vec3(0), glm::vec3(0, 1, 0));
}

glm::mat4 OrbitCamera::clip_from_view(float aspect, float near, float far) const {
  return glm::perspective(glm::radians(field_of_view), aspect, near, far);
}

glm::mat4 OrbitCamera::clip_from_world(float aspect) const {
  return clip_from_view(aspect) * view_from_world();
}

}  // namespace texel::app
