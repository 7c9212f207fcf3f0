// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <concepts>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "params/set.hpp"

namespace texel::app {

/// Where a camera starts, in degrees and world units.
struct Look {
  float yaw = 30, pitch = 20, distance = 3, field_of_view = 45;
};

/// Unit vector to which an angle around the vertical axis and one above the horizon point, both in degrees;
/// (0, 0) is +z.
inline glm::vec3 direction_from_angles(float yaw, float pitch) {
  const float a = glm::radians(yaw), b = glm::radians(pitch);
  return {std::sin(a) * std::cos(b), std::sin(b), std::cos(a) * std::cos(b)};
}

/// Rotation about the vertical axis by `degrees`: world space from object space.
inline glm::mat4 turn_about_y(float degrees) {
  return glm::rotate(glm::mat4(1), glm::radians(degrees), glm::vec3(0, 1, 0));
}

/// Rotation about the x axis, which points to the right: a positive angle leans the top forwards.
inline glm::mat4 tilt_about_x(float degrees) {
  return glm::rotate(glm::mat4(1), glm::radians(degrees), glm::vec3(1, 0, 0));
}

/// A camera that circles the origin, y up. Its values are parameters: a snapshot can have any look,
/// and in the window the mouse changes them.
struct OrbitCamera {
  float yaw{}, pitch{}, field_of_view{};  ///< degrees
  float distance{};                       ///< from the origin, world units

  template <std::same_as<Look> auto look>  // Clang 14 does not take <Look look>
  void declare(params::Set& set) {
    set.section("Camera");
    set.add(yaw, {"yaw", look.yaw, -360, 360, "degrees",
                  "Camera's angle around the vertical axis; 0 looks along -z"});
    set.add(pitch, {"pitch", look.pitch, -89, 89, "degrees", "Camera's angle above the horizon"});
    set.add(distance, {"distance", look.distance, 0.2, 100, "units", "Camera's distance from the origin",
                       params::Scale::logarithmic});
    set.add(field_of_view,
            {"field_of_view", look.field_of_view, 5, 150, "degrees", "Vertical opening angle"});
  }

  /// The camera's place in world space.
  [[nodiscard]] glm::vec3 eye() const { return distance * direction_from_angles(yaw, pitch); }
  [[nodiscard]] glm::mat4 view_from_world() const {
    return glm::lookAt(eye(), glm::vec3(0), glm::vec3(0, 1, 0));
  }
  /// Perspective projection of a picture that is `aspect` times as wide as high; near and far in world units.
  [[nodiscard]] glm::mat4 clip_from_view(float aspect, float near = 0.05F, float far = 200) const {
    return glm::perspective(glm::radians(field_of_view), aspect, near, far);
  }
  [[nodiscard]] glm::mat4 clip_from_world(float aspect) const {
    return clip_from_view(aspect) * view_from_world();
  }
};

/// Where a light starts: angles in degrees, strengths from 0 to 1.
struct Lighting {
  float yaw = 48, pitch = 42, ambient = 0.25F, specular = 0;
};

/// One far light and ambient light, as parameters; shaders/lib/light.glsl does the arithmetic.
struct Light {
  float light_yaw{}, light_pitch{};  ///< degrees
  float ambient{}, specular{};

  template <std::same_as<Lighting> auto lighting>
  void declare(params::Set& set) {
    set.section("Light");
    set.add(light_yaw, {"light_yaw", lighting.yaw, -180, 180, "degrees",
                        "Direction to the light around the vertical axis"});
    set.add(light_pitch,
            {"light_pitch", lighting.pitch, -90, 90, "degrees", "Direction to the light above the horizon"});
    set.add(ambient, {"ambient", lighting.ambient, 0, 1, "",
                      "Light from everywhere; 1 shows the picture without shading"});
    set.add(specular, {"specular", lighting.specular, 0, 1, "", "Strength of the highlight"});
  }

  /// Unit vector towards the light, world space.
  [[nodiscard]] glm::vec3 direction() const { return direction_from_angles(light_yaw, light_pitch); }
};

}  // namespace texel::app
