// SPDX-License-Identifier: MIT
// From an OBJ file to a mesh that can be drawn. The steps have files of their own beside this one: the
// numbers of a line (line_numbers.cpp), an index of a face (face_index.cpp), triangulation (clip_ears.cpp),
// the vertex stream (corner_numbers.cpp), round projections (spherical_texcoord.cpp).
#pragma once
#include <fmt/format.h>

#include <memory>
#include <string_view>
#include <unordered_map>

#include "app/assets.hpp"
#include "app/models.hpp"
#include "core/progress.hpp"
#include "mesh/bounds.hpp"
#include "mesh/normals.hpp"
#include "mesh/obj.hpp"
#include "mesh/stretch.hpp"
#include "mesh/texcoords.hpp"
#include "mesh/weld.hpp"
#include "parameters.hpp"

namespace texel::obj_texcoords {

struct Imported {
  std::shared_ptr<const mesh::Mesh> mesh;  ///< centred, its farthest vertex at distance 1
  std::vector<mesh::Group> parts;          ///< at least one
  std::vector<mesh::Material> materials;
  std::vector<std::size_t> material_of_part;  ///< the first of that name; beyond the list: none
  bool names_pictures = false;                ///< whether some material has a color_map
  app::Notes notes;
};

/// Finds each part's material by its name. A file may have as many of both as it has triangles.
inline void find_materials(Imported& imported) {
  std::unordered_map<std::string_view, std::size_t> place;
  for (std::size_t i = 0; i < imported.materials.size(); ++i) {
    place.try_emplace(imported.materials[i].name, i);
    imported.names_pictures = imported.names_pictures || !imported.materials[i].color_map.empty();
  }
  for (const mesh::Group& part : imported.parts) {
    const auto found = place.find(part.material);
    imported.material_of_part.push_back(found == place.end() ? imported.materials.size() : found->second);
  }
}

inline mesh::Projection mesh_projection(Projection projection) {
  switch (projection) {
    case Projection::planar:
      return mesh::Projection::planar;
    case Projection::cylindrical:
      return mesh::Projection::cylindrical;
    case Projection::spherical:
      return mesh::Projection::spherical;
    default:
      return mesh::Projection::box;
  }
}

/// Reads the file, generates what is missing, and builds the vertex stream. Errors as mesh::load_obj.
inline Imported import_obj(const std::filesystem::path& file, Projection projection, Normals normals,
                           Tint tint) {
  Progress progress(file.filename().string());
  const auto say_part = [&](double part) { progress.say(fmt::format("reading, {:.0f} %", 100 * part)); };
  mesh::ObjData data = mesh::load_obj(file, {.progress = say_part});
  Imported imported;
  imported.notes.warnings = data.report.warnings;
  imported.materials = data.materials;
  if (tint == Tint::groups) data.material_runs = data.group_runs;  // parts by g and o

  if (normals != Normals::from_file) mesh::remove_normals(data);
  if (data.normals.empty() && normals == Normals::from_file)
    imported.notes.facts.emplace_back("the file has no normals: smooth ones are generated");
  progress.say("normals");
  if (data.normals.empty() && normals != Normals::flat)
    mesh::generate_missing_normals(
        data, normals == Normals::smooth_area ? mesh::Weighting::area : mesh::Weighting::angle);

  progress.say("vertices");
  mesh::Mesh mesh = mesh::weld(std::move(data));
  app::warn_of_lost_shape(mesh, file.string(), imported.notes);
  mesh::normalize_to_unit(mesh);
  if (normals == Normals::flat) mesh::flat_normals(mesh);
  progress.say("texture coordinates");
  if (projection == Projection::triplanar) {
    mesh.texcoords.clear();  // the shader makes its own from the position
  } else if (projection != Projection::from_file || mesh.texcoords.empty()) {
    if (projection == Projection::from_file)
      imported.notes.facts.emplace_back("the file has no texture coordinates: a box projection is generated");
    mesh::generate_texcoords(mesh, mesh_projection(projection));
    for (std::string& line : mesh::describe_stretch(mesh)) imported.notes.facts.push_back(std::move(line));
  }
  imported.parts = mesh.groups;
  if (imported.parts.empty())
    imported.parts.push_back({"", 0, static_cast<std::uint32_t>(mesh.indices.size())});
  find_materials(imported);
  imported.mesh = std::make_shared<const mesh::Mesh>(std::move(mesh));
  return imported;
}

}  // namespace texel::obj_texcoords
