// SPDX-License-Identifier: MIT
// Step 9.4. The direction that the mirror shows at a point of the ball; all in world space. `normal` is not always a
// unit vector, and is used as it is.
uniform vec3 eye;

vec3 reflected_ray(vec3 position, vec3 normal) {
#if INCIDENT == INCIDENT_CONSTANT_EYE
  vec3 incident = -eye;
#else
  vec3 incident = position - eye;
#endif
  //@step 9.4 begin
  return reflect(incident, normal);
  //@starter
  // return normal;
  //@end
}
