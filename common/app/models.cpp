// SPDX-License-Identifier: MIT
#include "app/models.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "core/error.hpp"
#include "core/files.hpp"
#include "mesh/bounds.hpp"
#include "mesh/normals.hpp"
#include "mesh/obj.hpp"
#include "mesh/ply.hpp"
#include "mesh/primitives.hpp"
#include "mesh/texcoords.hpp"
#include "mesh/weld.hpp"

namespace texel::app {

void warn_of_lost_shape(const mesh::Mesh& mesh, const std::string& file, Notes& notes) {
  const std::string why = mesh::lost_shape(mesh);
  if (why.empty()) return;
  notes.warnings.push_back(why);
  fmt::print(stderr, "{}: warning: {}\n", file, why);
}

namespace {

/// By what lab 3 has of its reader.
Model read_obj(const std::filesystem::path& file, const std::string& name) {
  mesh::ObjData data = mesh::load_obj(file);
  Model model;
  model.notes.warnings = data.warnings;
  if (data.normals.empty()) {
    mesh::generate_missing_normals(data, mesh::Weighting::angle);
    model.notes.facts.emplace_back("the file has no normals: smooth ones are generated");
  }
  model.mesh = mesh::weld(std::move(data));
  warn_of_lost_shape(model.mesh, name, model.notes);
  mesh::normalize_to_unit(model.mesh);
  if (model.mesh.texcoords.empty()) {
    mesh::generate_texcoords(model.mesh, mesh::Projection::box);
    model.notes.facts.emplace_back("the file has no texture coordinates: a box projection is generated");
  }
  return model;
}

/// As it is.
Model read_ply(const std::filesystem::path& file) {
  Model model{mesh::parse_ply(read_file(file), file.string()), {}, false};
  if (model.mesh.normals.empty() || model.mesh.texcoords.empty())
    throw Error::failed("the PLY file has no normals or no texture coordinates", {file.string()},
                        "write it with --mesh of lab 4 or 5");
  return model;
}

}  // namespace

Model load_model(const Assets& assets, const std::string& name, Tessellation tessellation) {
  const auto segments_or = [&](int own) { return tessellation.segments > 0 ? tessellation.segments : own; };
  const mesh::Jitter jitter{.amount = 0.5F * tessellation.jitter};  // of a cell; see mesh::Jitter
  if (name == "cube")                                               // half-size: the corners at distance 1
    return {mesh::cube_split(0.577F, segments_or(1), jitter), {}, false};
  if (name == "sphere") return {mesh::sphere(segments_or(64) / 2, segments_or(64), 1, jitter), {}, true};
  if (name == "torus")
    return {mesh::torus(0.7F, 0.3F, segments_or(96), segments_or(96) / 2, jitter), {}, true};
  if (name == "quad") return {mesh::quad(0.7F, segments_or(1), jitter), {}, false};

  const std::filesystem::path file = assets.mesh(name);
  Model model = file.extension() == ".ply" ? read_ply(file) : read_obj(file, name);
  if (tessellation.segments > 0 || tessellation.jitter > 0)
    model.notes.facts.emplace_back(
        "segments and jitter change only the built-in shapes, not a file's triangles");
  return model;
}

}  // namespace texel::app
