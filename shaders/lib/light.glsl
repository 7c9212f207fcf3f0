// SPDX-License-Identifier: MIT
// Linear light that a surface of colour `albedo` sends to the eye: ambient light, light from one far source,
// and a highlight (J. Blinn, "Models of light reflection for computer synthesized pictures", 1977).
// normal, to_eye: unit vectors in world space, as is the uniform `light`.
vec3 lit(vec3 albedo, vec3 normal, vec3 to_eye) {
  float diffuse = max(dot(normal, light), 0.0);  // a surface that faces away gets nothing, not less than nothing
  float highlight = diffuse > 0.0 ? pow(max(dot(normal, normalize(light + to_eye)), 0.0), 48.0) : 0.0;
  return albedo * mix(ambient, 1.0, diffuse) + specular * highlight;
}
