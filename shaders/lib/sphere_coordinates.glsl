// SPDX-License-Identifier: MIT
// Texture coordinates of a sphere from a point's direction, and how they change from pixel to pixel.
const float PI = 3.14159265358979;

// Step 6.1. Longitude and angle from the north pole, as fractions of a full and of a half turn. n: any length except
// zero. u is 0 at +z, falls past +x to -1/2 at the back, and jumps there to 1/2. v is 0 at +y and 1 at -y.
// The worksheet's formula: u runs left, v down. So a picture with the bottom row first is turned by 180 degrees.
vec2 sphere_texcoord(vec3 n) {
  //@step 6.1 begin
  float u = atan(n.x, n.z) / (-2.0 * PI);
  float v = atan(sqrt(n.x * n.x + n.z * n.z), n.y) / PI;
  return vec2(u, v);
  //@starter
  // return n.xy;
  //@end
}

// The difference of two neighbours' coordinates, the short way round. Across the seam u differs by nearly 1, but
// the two points lie side by side.
vec2 wrapped_difference(vec2 difference) {
  return vec2(difference.x - round(difference.x), difference.y);
}

// The change of sphere_texcoord if n changes by dn: its derivative, by the chain rule. It has no seam: it takes no
// difference of two angles.
vec2 sphere_gradient(vec3 n, vec3 dn) {
  float r2 = max(dot(n.xz, n.xz), 1e-12), r = sqrt(r2);  // at a pole u has no derivative: a large one is near enough
  float dr = dot(n.xz, dn.xz) / r;
  float du = (n.z * dn.x - n.x * dn.z) / (-2.0 * PI * r2);
  float dv = (n.y * dr - r * dn.y) / (PI * (r2 + n.y * n.y));
  return vec2(du, dv);
}
