// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <glm/mat2x2.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "image/cube_faces.hpp"

/// The right answer in double precision, from the analytic surface. It shares no code with the methods
/// that are compared with it. Unless a function says otherwise: right-handed, y up, angles in radians,
/// lengths in world units, colours in linear light, no errors thrown; functions are accurate to a few
/// roundings of double, and the tests say how many.
namespace texel::truth {

/// A surface at one texture coordinate. The derivatives are by the texture coordinate (s, t) and in
/// closed form. The normal always points out of the surface: cross(ds, dt) has the
/// opposite sign where the texture is mirrored.
struct SurfacePoint {
  glm::dvec3 position;
  glm::dvec3 ds, dt;  ///< derivatives of the position, world units per texture width
  glm::dvec3 normal;  ///< unit length, outward
};

/// A surface with texture coordinates. The ones below lie, point for point, where the shapes of
/// mesh/primitives.hpp do.
using Surface = std::function<SurfacePoint(glm::dvec2 texcoord)>;

/// The square (-h, -h) to (h, h) in the plane z = 0, facing +z; (0, 0) at its lower left, (1, 1) at its upper
/// right.
Surface quad(double half_size = 0.7);

/// One face of the cube from (-h, -h, -h) to (h, h, h): (0, 0) at its lower left seen from outside, upright;
/// the lower edge of +y and the upper edge of -y are those at the front (+z).
Surface cube_face(image::Face face, double half_size = 1);

/// A sphere about the origin: s is the longitude / 2 pi, counter-clockwise seen from above, 0 at +z and 1/4
/// at +x; t is the latitude / pi + 1/2. At the poles, ds is so short that it counts as zero, but its
/// direction is the limit along the meridian of s.
Surface sphere(double radius = 1);

/// A torus about the y axis, minor < major: s as on the sphere, t the angle around the tube / 2 pi, 0 at the
/// outer equator and 1/4 at the top.
Surface torus(double major, double minor);

/// The texture coordinate of a point on the sphere (of any radius, about the origin), s in [0, 1). The poles
/// have any s; here s = 0.
glm::dvec2 sphere_texcoord(glm::dvec3 position);

/// The texture coordinate of a point on the torus with this major radius, s and t in [0, 1).
glm::dvec2 torus_texcoord(glm::dvec3 position, double major);

/// A change of parameterisation: texcoord = linear * parameter + offset, where `parameter` is the texture
/// coordinate of one of the surfaces above.
struct TexcoordMap {
  glm::dmat2 linear{1};
  glm::dvec2 offset{0};

  [[nodiscard]] glm::dvec2 texcoord(glm::dvec2 parameter) const { return linear * parameter + offset; }
  [[nodiscard]] glm::dvec2 parameter(glm::dvec2 texcoord) const;
};

/// The same surface with other texture coordinates; `map.linear` must be invertible.
Surface reparameterized(Surface surface, const TexcoordMap& map);

/// Where an object stands: world = linear * object + offset; `linear` is any invertible matrix, so turns,
/// non-uniform scales and shears of the space.
struct Placement {
  glm::dmat3 linear{1};
  glm::dvec3 offset{0};
};

/// The surface in world space. The normal is multiplied by the inverse transpose and stays perpendicular and
/// outward.
Surface placed(Surface surface, const Placement& world_from_object);

/// On which side of the plane of tangent and normal the bitangent lies: the sign of dot(cross(n, t), b). +1
/// when (t, b, n) is right-handed, -1 when the texture is mirrored, 0 when the three lie in a plane.
double handedness(glm::dvec3 tangent, glm::dvec3 bitangent, glm::dvec3 normal);

/// The axes of a normal map's texel (x, y, z).
struct Frame {
  glm::dvec3 tangent, bitangent, normal;  ///< unit length
  double handedness;                      ///< -1 where the texture is mirrored, else +1
};

/// The frame of MikkTSpace, which bakers share: T is ds without its part along the normal, at unit length,
/// and B = handedness * cross(N, T): always at right angles. Under shear t does not grow along B. Source:
/// M. S. Mikkelsen, "Simulation of Wrinkled Surfaces Revisited" (2008).
Frame orthonormal_frame(const SurfacePoint& point);

}  // namespace texel::truth
