// SPDX-License-Identifier: MIT
// The rays at one point of the surface, in world space. The same function serves a vertex and a pixel.
#include "fresnel.glsl"

uniform vec3 eye;         // world space
uniform bool eye_inside;  // the ball
uniform float index;      // of refraction, inside relative to outside

struct Rays {
  vec3 reflected;
  vec3 refracted;     // where there is none, along the surface: the last that there was
  float reflectance;  // which part of the light is reflected
};

// Step 8.2. The direction of the view ray that arrives at the surface.
vec3 incident_ray(vec3 position) {
#if METHOD == METHOD_CONSTANT_EYE
  return -eye;  // right for one point only: the one in front of the eye (worksheet)
#else
  //@step 8.2 begin
  return position - eye;
  //@starter
  // return vec3(0.0, -1.0, 0.0);
  //@end
#endif
}

// Step 8.1. Mirrors a ray at a surface: its part along the normal changes sign. normal: unit length, on either side.
vec3 reflected_ray(vec3 incident, vec3 normal) {
  //@step 8.1 begin
  return incident - 2.0 * dot(normal, incident) * normal;  // GLSL's reflect()
  //@starter
  // return normal;
  //@end
}

// Step 8.3. Bends a unit ray at a surface whose unit normal is on the ray's side (Snell's law). eta: index of refraction
// on this side over that on the other. Returns (0, 0, 0) if there is no refracted ray: all light is reflected.
vec3 refracted_ray(vec3 incident, vec3 normal, float eta) {
  //@step 8.3 begin
  float cos_i = -dot(normal, incident);
  float cos_t_squared = 1.0 - eta * eta * (1.0 - cos_i * cos_i);
  if (cos_t_squared < 0.0) return vec3(0.0);
  return eta * incident + (eta * cos_i - sqrt(cos_t_squared)) * normal;  // GLSL's refract()
  //@starter
  // return incident;
  //@end
}

Rays follow_rays(vec3 position, vec3 normal) {
  vec3 incident = incident_ray(position);
#if SURFACE == SURFACE_MIRROR
  return Rays(reflected_ray(incident, normal), vec3(0.0), 1.0);
#else
  vec3 unit = normalize(incident);
  float eta = 1.0 / index;
  if (eye_inside && dot(unit, normal) > 0.0) {  // the ray leaves
    normal = -normal;
    eta = index;
  }
  vec3 reflected = reflected_ray(unit, normal);
  vec3 refracted = refracted_ray(unit, normal, eta);
  // The level of a look-up comes from the rays of neighbouring pixels. So each kind of ray changes steadily over the ball,
  // also where no light takes it.
  if (refracted == vec3(0.0)) return Rays(reflected, normalize(unit - dot(unit, normal) * normal), 1.0);
#if SURFACE == SURFACE_REFRACTION
  return Rays(reflected, refracted, 0.0);
#else
  return Rays(reflected, refracted, fresnel(-dot(unit, normal), eta));
#endif
#endif
}
