// SPDX-License-Identifier: MIT
#pragma once
#include <concepts>
#include <glm/glm.hpp>

#include "app/camera.hpp"
#include "params/set.hpp"

namespace texel::app {

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
