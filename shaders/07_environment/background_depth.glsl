// SPDX-License-Identifier: MIT
// The quad's place in the depth buffer, with w = 1: z from -1 (near plane) to 1 (far plane).
uniform float near;
uniform float far;

#if DEPTH_METHOD == DEPTH_METHOD_FAR_PLANE
const float kBackgroundZ = 1.0;
#else
const float kBackgroundZ = 0.999;  // the worksheet's
#endif

// The distance along the view axis at which an object has this depth: z / w, solved for the distance. With
// near = 0.0001 and far = 100 nearly the whole range lies just in front of the eye: 0.999 is 0.2 units away.
float background_distance() {
  return 2.0 * near * far / ((1.0 - kBackgroundZ) * far + (1.0 + kBackgroundZ) * near);
}
