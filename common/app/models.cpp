// SPDX-License-Identifier: MIT
#include "app/models.hpp"

#include "mesh/bounds.hpp"
#include "mesh/normals.hpp"
#include "mesh/obj.hpp"
#include "mesh/primitives.hpp"
#include "mesh/texcoords.hpp"
#include "mesh/weld.hpp"

namespace texel::app {

Model load_model(const Assets& assets, const std::string& name) {
  if (name == "cube") return {mesh::cube_split(0.577F), {}, false};  // half-size: the corners at distance 1
  if (name == "sphere") return {mesh::sphere(32, 64), {}, true};
  if (name == "torus") return {mesh::torus(0.7F, 0.3F, 96, 48), {}, true};
  if (name == "quad") return {mesh::quad(0.7F), {}, false};

  mesh::ObjData data = mesh::load_obj(assets.model(name));
  Model model;
  model.notes.warnings = data.report.warnings;
  if (data.normals.empty()) {
    mesh::generate_missing_normals(data, mesh::Weighting::angle);
    model.notes.facts.emplace_back("the file has no normals: smooth ones are generated");
  }
  model.mesh = mesh::weld(std::move(data));
  mesh::normalize_to_unit(model.mesh);
  if (model.mesh.texcoords.empty()) {
    mesh::generate_texcoords(model.mesh, mesh::Projection::box);
    model.notes.facts.emplace_back("the file has no texture coordinates: a box projection is generated");
  }
  return model;
}

}  // namespace texel::app
