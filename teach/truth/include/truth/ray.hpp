// SPDX-License-Identifier: MIT
#pragma once
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "image/cube_faces.hpp"
#include "truth/surface.hpp"

namespace texel::truth {

struct Ray {
  glm::dvec3 origin;
  glm::dvec3 direction;  ///< any length except zero; distances along the ray are multiples of it
};

/// The labs' camera: it circles the origin and looks at it, y up. Angles in **degrees**, as the labs'
/// parameters; the picture is width x height pixels.
struct Camera {
  double yaw = 0;             ///< around the y axis; 0 looks along -z, 90 along -x
  double pitch = 0;           ///< above the horizon
  double distance = 3;        ///< of the eye from the origin
  double field_of_view = 45;  ///< vertical opening angle
  int width = 512, height = 512;

  [[nodiscard]] glm::dvec3 eye() const;
  bool operator==(const Camera&) const = default;
};

/// A ray through a place of the picture and how its unit direction changes from pixel to pixel.
struct PixelRay {
  Ray ray;            ///< direction of unit length
  glm::dvec3 dx, dy;  ///< derivatives of the direction by window x and y, per pixel
};

/// The ray from the eye through `window`: pixels from the lower left corner, so (x + 1/2, y + 1/2) is the
/// middle of pixel (x, y) of a picture whose row 0 is at the bottom (gl_FragCoord). Uses no matrix, so near
/// and far planes do not matter.
PixelRay pixel_ray(const Camera& camera, glm::dvec2 window);
/// That ray alone.
Ray ray_through(const Camera& camera, glm::dvec2 window);

/// The ray in object space. Its direction is not made a unit vector: distances stay those of the world.
Ray object_ray(const Ray& world_ray, const Placement& world_from_object);

/// Where a ray meets a surface for the first time in front of its origin.
struct Hit {
  double distance;                             ///< position = origin + distance * direction
  glm::dvec2 texcoord;                         ///< of the surface in surface.hpp
  image::Face face = image::Face::positive_z;  ///< of a cube
};

/// The square of quad(); both sides are hit.
std::optional<Hit> hit_quad(const Ray& ray, double half_size = 0.7);

/// The cube of cube_face(); from inside too. On an edge, the face named first along x, y, z.
std::optional<Hit> hit_cube(const Ray& ray, double half_size = 1);

/// The sphere of sphere(); from inside too. Everything is measured from the point of the ray that is nearest
/// to the centre: a small sphere far away keeps its accuracy (Haines, Guenther and Akenine-Moeller,
/// "Precision Improvements for Ray/Sphere Intersection", Ray Tracing Gems, 2019, chapter 7).
std::optional<Hit> hit_sphere(const Ray& ray, double radius = 1);

/// The torus of torus(), minor < major; from inside the tube too. The quartic's roots are enclosed between
/// the roots of its derivative, found by Newton steps that fall back to halving, and polished on the torus's
/// distance function. Measured: the point lies within 1e-15 of the surface, in units of major + minor, for an
/// eye at 4 of them. A ray that touches without crossing by more than rounding may be missed.
std::optional<Hit> hit_torus(const Ray& ray, double major, double minor);

/// How the texture coordinate changes from pixel to pixel.
struct TexcoordGradient {
  glm::dvec2 dx, dy;  ///< derivatives by window x and y, texture widths per pixel
};

/// How the place on the surface changes from pixel to pixel.
struct PositionGradient {
  glm::dvec3 dx, dy;  ///< derivatives by window x and y, world units per pixel
};

/// The position's change at the point that the ray meets: the change of direction, carried to the surface and
/// then along the ray into the tangent plane (Igehy, "Tracing Ray Differentials", SIGGRAPH 1999, on
/// transfer). Not finite where the ray grazes.
PositionGradient position_gradient(const PixelRay& pixel, const SurfacePoint& point);

/// The texture coordinate's derivatives at that point, by solving ds * s_x + dt * t_x = position_x in the
/// tangent plane. Where ds vanishes, as at a sphere's pole, they are very large or not finite.
TexcoordGradient texcoord_gradient(const PixelRay& pixel, const SurfacePoint& point);

}  // namespace texel::truth
