// SPDX-License-Identifier: MIT
// How the texture coordinates of a sphere, u and v of lab 6, change from pixel to pixel.
const float PI = 3.14159265358979;

// The difference of two neighbours' coordinates, the short way round. Across the seam u differs by nearly 1, but
// the two points lie side by side.
vec2 wrapped_difference(vec2 difference) {
  return vec2(difference.x - round(difference.x), difference.y);
}

// The change of u and v if the direction n changes by dn: their derivative, by the chain rule. It has no seam: it takes no
// difference of two angles.
vec2 sphere_gradient(vec3 n, vec3 dn) {
  float r2 = max(dot(n.xz, n.xz), 1e-12), r = sqrt(r2);  // at a pole u has no derivative: a large one is near enough
  float dr = dot(n.xz, dn.xz) / r;
  float du = (n.z * dn.x - n.x * dn.z) / (-2.0 * PI * r2);
  float dv = (n.y * dr - r * dn.y) / (PI * (r2 + n.y * n.y));
  return vec2(du, dv);
}
