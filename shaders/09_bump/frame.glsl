// SPDX-License-Identifier: MIT
// An orthonormal frame around a unit vector n: columns T, B and N = n, right-handed. Any two vectors perpendicular to n
// are good enough for lighting. A relief needs those along u and v.

#if METHOD == METHOD_ROTATE_TO_NORMAL
// J. R. Frisvad, "Building an Orthonormal Basis from a 3D Unit Vector Without Normalization", JGT 16 (2012), listing 3:
// the rotation that takes +z to n. Near n = -z it divides by almost 0.
mat3 frame_at(vec3 n) {
  if (n.z < -0.9999999) return mat3(vec3(0.0, -1.0, 0.0), vec3(-1.0, 0.0, 0.0), n);
  float a = 1.0 / (1.0 + n.z), b = -n.x * n.y * a;
  return mat3(vec3(1.0 - n.x * n.x * a, b, -n.x), vec3(b, 1.0 - n.y * n.y * a, -n.y), n);
}

#elif METHOD == METHOD_SIGN_CORRECTED
// The same for n.z >= 0; for the other half the frame of (n.x, n.y, -n.z), mirrored.
mat3 frame_at(vec3 n) {
  float side = n.z < 0.0 ? -1.0 : 1.0;  // sign(n.z) is 0 on the border, and so would B be
  float a = 1.0 / (1.0 + abs(n.z)), b = -n.x * n.y * a;
  return mat3(vec3(1.0 - n.x * n.x * a, b, -side * n.x), side * vec3(b, 1.0 - n.y * n.y * a, -side * n.y), n);
}

#elif METHOD == METHOD_DUFF
// T. Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 6 (2017), listing 3.
mat3 frame_at(vec3 n) {
  float side = n.z < 0.0 ? -1.0 : 1.0;  // the paper's copysign: never 0
  float a = -1.0 / (side + n.z), b = n.x * n.y * a;
  return mat3(vec3(1.0 + side * n.x * n.x * a, side * b, -side * n.x), vec3(b, side + n.y * n.y * a, -n.y), n);
}

#elif METHOD == METHOD_HUGHES_MOLLER
// J. F. Hughes and T. Moeller, "Building an Orthonormal Basis from a Unit Vector", JGT 4 (1999): leave out the smaller of
// x and z, swap the other two and change a sign.
mat3 frame_at(vec3 n) {
  vec3 B = abs(n.x) > abs(n.z) ? vec3(-n.y, n.x, 0.0) : vec3(0.0, -n.z, n.y);
  B = normalize(B);
  return mat3(cross(B, n), B, n);
}

#elif METHOD == METHOD_CROSS_UP
// Step 9.3, first place. T is perpendicular to n and to the axis. At the poles these are parallel: T is NaN.
mat3 frame_at(vec3 n) {
  //@step 9.3 begin
  vec3 T = normalize(cross(n, vec3(0.0, 1.0, 0.0)));
  return mat3(T, cross(n, T), n);
  //@starter
  // return mat3(vec3(1.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0), n);
  //@end
}

#else  // METHOD_UV_ALIGNED, and METHOD_BLINN, which also scales a slope (below)
// Step 9.3, second place. T runs along the circle of latitude, where u grows (to -x at +z). B runs along the
// meridian, where v grows (down). At the poles u has no direction: any T is right. Near the poles the squares in
// length() lose digits.
mat3 frame_at(vec3 n) {
  //@step 9.3 begin
  float radius = length(n.xz);
  vec3 T = radius > 1e-16 ? vec3(-n.z, 0.0, n.x) / radius : vec3(-1.0, 0.0, 0.0);
  return mat3(T, cross(n, T), n);
  //@starter
  // return mat3(vec3(1.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0), n);
  //@end
}
#endif

// The ball's normal bent by m, the map's normal; both in object space.
vec3 bent_normal(vec3 n, vec3 m) {
#if METHOD == METHOD_ROTATE_TO_NORMAL
  return frame_at(n) * m;  // averaged normals are too short: the worksheet leaves them so
#elif METHOD == METHOD_BLINN
  // The map's slopes -dh/du = m.x / m.z and -dh/dv, per length of the map; along v the map is as long as half a meridian.
  // The circle of latitude is 2 sin(angle from the pole) times as long. Slopes along it are smaller by this factor: the
  // surface gradient of J. F. Blinn, "Simulation of Wrinkled Surfaces", SIGGRAPH 1978, section 2. At the poles only
  // slope 0 is possible.
  float longer = 2.0 * length(n.xz);
  return normalize(frame_at(n) * vec3(m.x / max(longer, 1e-3), m.y, m.z));
#else
  return normalize(frame_at(n) * m);
#endif
}
