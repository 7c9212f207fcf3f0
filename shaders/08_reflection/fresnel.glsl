// SPDX-License-Identifier: MIT
// Step 8.4. The share of unpolarised light that is reflected between two dielectrics. cos_i: cosine of the angle of
// ray and normal, 0 to 1. eta: this side's index of refraction over the other side's. A refracted ray exists here.
float fresnel(float cos_i, float eta) {
  //@step 8.4 begin
  float cos_t = sqrt(max(1.0 - eta * eta + eta * eta * cos_i * cos_i, 0.0));
  if (cos_i <= 0.0) return 1.0;  // along the surface; between equal media the quotients below would be 0 / 0
#if SURFACE == SURFACE_SCHLICK
  // C. Schlick, "An Inexpensive BRDF Model for Physically-based Rendering", 1994. Take the cosine in the thinner
  // medium. Then Schlick's formula, too, reaches 1 where total reflection begins.
  float r0 = (eta - 1.0) / (eta + 1.0);
  r0 *= r0;
  return r0 + (1.0 - r0) * pow(max(1.0 - min(cos_i, cos_t), 0.0), 5.0);
#else
  // The mean of both polarisations (A. Fresnel 1823; M. Born and E. Wolf, "Principles of Optics", section 1.5.2).
  float s = (eta * cos_i - cos_t) / (eta * cos_i + cos_t);
  float p = (cos_i - eta * cos_t) / (cos_i + eta * cos_t);
  return 0.5 * (s * s + p * p);
#endif
  //@starter
  // return 0.5;
  //@end
}
