// SPDX-License-Identifier: MIT
// The model of lab 5 before its tangents are made. Nothing to do for you here: the tangents' steps are in
// triangle_frame.cpp, add_to_corners.cpp and orthonormalize.cpp.
#pragma once
#include <fmt/format.h>

#include <optional>

#include "app/models.hpp"
#include "mesh/primitives.hpp"
#include "mesh/tangents.hpp"
#include "parameters.hpp"

namespace texel::normal_map {

/// The model with its texture coordinates, and with exact tangents if they have a formula and are wanted.
inline app::Model textured_model(const app::Assets& assets, const NormalMapParameters& p) {
  app::Model model = app::load_model(assets, p.model, p.tessellation);
  if (p.method == Method::analytic) {
    if (model.is_revolution)
      mesh::revolution_tangents(model.mesh);
    else
      model.notes.facts.emplace_back("this model has no formula for its tangents: mikktspace instead");
  }
  mesh::lay_texture(model.mesh, p.layout);
  std::size_t flat = 0;
  for (std::size_t t = 0; t < model.mesh.triangle_count(); ++t)
    if (mesh::texture_area(of_triangle(model.mesh, model.mesh.texcoords, t)) == 0) ++flat;
  if (flat > 0)
    model.notes.facts.push_back(
        fmt::format("{} of {} triangles have no area in the texture, and so no tangent: "
                    "any direction in the surface is taken",
                    flat, model.mesh.triangle_count()));
  return model;
}

/// The normal map: "matching" is the one that was made with the texture.
inline std::string normal_map_name(const NormalMapParameters& p) {
  if (p.normal_map != "matching") return p.normal_map;
  const bool has_relief = p.texture == "brick" || p.texture == "wood" || p.texture == "scales";
  return has_relief ? p.texture : "flat";
}

/// How tangents are made for the vertices; nothing if the shader makes them or needs none.
inline std::optional<mesh::TangentMethod> kept_tangents(Method method) {
  if (method < Method::averaged) return std::nullopt;
  using enum mesh::TangentMethod;  // the last is for analytic, where there is no formula
  constexpr mesh::TangentMethod kTangents[] = {averaged, gram_schmidt, angle_weighted, mikktspace,
                                               mikktspace};
  return kTangents[static_cast<int>(method) - static_cast<int>(Method::averaged)];
}

}  // namespace texel::normal_map
