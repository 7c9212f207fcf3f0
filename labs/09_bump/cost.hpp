// SPDX-License-Identifier: MIT
// The cost of a frame alone is too small to see in the time of a picture. So the benchmark runs
// the same function on the CPU many times. Nothing to do for you here.
#pragma once

#include "app/lab.hpp"
#include "math/basis.hpp"
#include "parameters.hpp"

namespace texel {

/// The method's basis, at directions all around.
inline app::Preparation bases_around(Method method) {
  constexpr std::size_t kDirections = 100'000;
  std::vector<glm::vec3> directions;
  for (std::size_t i = 0; i < kDirections; ++i) {  // a spiral from pole to pole: even on the sphere
    const double y = 1 - (2 * static_cast<double>(i) + 1) / kDirections,
                 angle = 2.399963 * static_cast<double>(i);
    const double radius = std::sqrt(1 - y * y);
    directions.emplace_back(radius * std::sin(angle), y, radius * std::cos(angle));
  }
  // Blinn's way differs in what it does with the map's normal; its frame is that of u and v.
  const std::string name =
      kMethods[static_cast<std::size_t>(method == Method::blinn ? Method::uv_aligned : method)].name;
  return {"basis", kDirections, [directions = std::move(directions), name] {
            math::for_each_basis([&](const char* basis, auto frame) {
              if (basis != name) return;
              glm::mat3 sum(0);
              for (const glm::vec3& n : directions) sum += frame(n);
              volatile float kept = sum[0].x + sum[1].y;  // or the loop would be left out
              static_cast<void>(kept);
            });
          }};
}

}  // namespace texel
