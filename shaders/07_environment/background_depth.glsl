// SPDX-License-Identifier: MIT
// Where the quad lies in the depth buffer, with w = 1: z from -1 (near plane) to 1 (far plane).
uniform float near;
uniform float far;

#if DEPTH_METHOD == DEPTH_METHOD_FAR_PLANE
const float kBackgroundZ = 1.0;
#else
const float kBackgroundZ = 0.999;  // the worksheet's
#endif

// At which distance along the view axis an object has that depth: the projection's z / w, solved for the distance. With
// near = 0.0001 and far = 100 nearly all of the range is used up in front of the eye, and 0.999 is 0.2 units away.
float background_distance() {
  return 2.0 * near * far / ((1.0 - kBackgroundZ) * far + (1.0 + kBackgroundZ) * near);
}
