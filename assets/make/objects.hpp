// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace texel::assets {

struct Ball {
  glm::dvec3 middle;
  double radius;
};

/// What stands in the landscape, each as a signed distance function (after Hart, Sphere Tracing, 1996).
struct Object {
  enum class Kind { broadleaf, conifer, house, church, lighthouse, boat };
  Kind kind;
  glm::dvec3 foot;            ///< where it stands, metres
  double size;                ///< 1 is as built
  double turn;                ///< about y, radians
  std::uint32_t seed;         ///< what makes it differ from the next one of its kind
  std::vector<Ball> lobes{};  ///< of a broadleaf's crown, for size 1
};

/// Where a ray meets an object.
struct Hit {
  double t = -1;               ///< along the ray, metres; negative: nothing met
  glm::dvec3 normal{0, 1, 0};  ///< unit, world
  glm::dvec3 albedo{0};        ///< linear-light RGB
  double sky = 1;              ///< the part of the sky that the point sees: less inside a crown
};

/// Everything that stands on the flat ground around the square.
class Objects {
 public:
  /// `may_stand` says whether a tree may grow at (x, z).
  explicit Objects(bool (*may_stand)(double x, double z));

  /// The nearest object nearer than `furthest` along the unit direction.
  [[nodiscard]] Hit intersect(glm::dvec3 origin, glm::dvec3 direction, double furthest) const;
  /// How much of the sun reaches a point, 0..1, for the unit direction towards it.
  [[nodiscard]] double sunlight(glm::dvec3 point, glm::dvec3 sun) const;

 private:
  /// Neighbours, tried only by rays that meet the ball around them all.
  struct Group {
    Ball ball;
    std::vector<Object> objects;
    std::vector<Ball> balls;
  };
  std::vector<Group> groups_;

  /// Calls visit(object, from, to) for each object whose ball the ray is inside of between from and to.
  template <class Visit>
  void visit_along(glm::dvec3 origin, glm::dvec3 direction, const Visit& visit) const;
};

}  // namespace texel::assets
