// SPDX-License-Identifier: MIT
// From an OBJ file to a mesh that can be drawn. The steps have files of their own beside this one: the
// numbers of a line (line_numbers.cpp), an index of a face (face_index.cpp), triangulation (clip_ears.cpp),
// the vertex stream (corner_numbers.cpp), round projections (spherical_texcoord.cpp).
#pragma once
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>
#include <unordered_map>

#include "app/assets.hpp"
#include "app/models.hpp"
#include "image/color.hpp"
#include "mesh/bounds.hpp"
#include "mesh/normals.hpp"
#include "mesh/obj.hpp"
#include "mesh/stretch.hpp"
#include "mesh/texcoords.hpp"
#include "mesh/weld.hpp"
#include "parameters.hpp"

namespace texel::obj_texcoords {

struct Imported {
  mesh::Mesh mesh;                 ///< centred, its farthest vertex at distance 1
  std::vector<mesh::Group> parts;  ///< at least one
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

/// Reads the file, generates what is missing, and builds the vertex stream. Errors as mesh::load_obj.
inline Imported import_obj(const std::filesystem::path& file, Projection projection, Normals normals,
                           Tint tint) {
  mesh::ObjData data = mesh::load_obj(file);
  Imported imported;
  imported.notes.warnings = data.warnings;
  imported.materials = data.materials;
  if (tint == Tint::groups) data.material_runs = data.group_runs;  // parts by g and o

  if (normals != Normals::from_file) mesh::remove_normals(data);
  if (data.normals.empty() && normals == Normals::from_file)
    imported.notes.facts.emplace_back("the file has no normals: smooth ones are generated");
  if (data.normals.empty() && normals != Normals::flat)
    mesh::generate_missing_normals(
        data, normals == Normals::smooth_area ? mesh::Weighting::area : mesh::Weighting::angle);

  mesh::Mesh mesh = mesh::weld(std::move(data));
  app::warn_of_lost_shape(mesh, file.string(), imported.notes);
  mesh::normalize_to_unit(mesh);
  if (normals == Normals::flat) mesh::flat_normals(mesh);
  if (projection == Projection::triplanar) {
    mesh.texcoords.clear();  // the shader makes its own from the position
  } else if (projection != Projection::from_file || mesh.texcoords.empty()) {
    if (projection == Projection::from_file)
      imported.notes.facts.emplace_back("the file has no texture coordinates: a box projection is generated");
    using enum mesh::Projection;
    // From the first one on: a file without texture coordinates gets a box.
    constexpr mesh::Projection kByProjection[] = {box, planar, box, cylindrical, spherical};
    mesh::generate_texcoords(mesh, kByProjection[static_cast<int>(projection)]);
    for (std::string& line : mesh::describe_stretch(mesh)) imported.notes.facts.push_back(std::move(line));
  }
  imported.parts = mesh.groups;
  if (imported.parts.empty())
    imported.parts.push_back({"", 0, static_cast<std::uint32_t>(mesh.indices.size())});
  find_materials(imported);
  imported.mesh = std::move(mesh);
  return imported;
}

// ---- Which picture and which colour each part has.

/// The material of part `i`; null for none.
inline const mesh::Material* material_of(const Imported& imported, std::size_t i) {
  const std::size_t index = imported.material_of_part[i];
  return index < imported.materials.size() ? &imported.materials[index] : nullptr;
}

/// The name or path of the picture of part `i`; "" for none.
inline std::string picture_of(const std::string& texture, const Imported& imported, std::size_t i) {
  if (texture != "material") return texture;
  if (!imported.names_pictures) return "label_grid";
  const mesh::Material* material = material_of(imported, i);
  return material != nullptr ? material->color_map : "";
}

/// The sRGB colour of part `i`: hues a golden section apart, so neighbours in the list look different.
inline glm::vec3 part_color(std::size_t i) {
  const auto hue = static_cast<float>(std::fmod(0.618034 * static_cast<double>(i), 1.0));
  const glm::vec3 phase = 2 * std::numbers::pi_v<float> * (hue + glm::vec3(0, 1, 2) / 3.0F);
  return 0.6F + 0.4F * glm::cos(phase);
}

/// The sRGB colour by which the picture of part `i` is multiplied.
inline glm::vec3 tint_of(Tint tint, const std::string& texture, const Imported& imported, std::size_t i) {
  if (tint == Tint::materials || tint == Tint::groups) return part_color(i);
  const mesh::Material* material = texture == "material" ? material_of(imported, i) : nullptr;
  return material != nullptr ? material->diffuse : glm::vec3(1);
}

/// The texel at a coordinate, repeating; linear or encoded.
inline glm::vec3 pixel_color(const image::Image8& picture, const glm::vec2& texcoord, bool linear) {
  const glm::vec2 tile = glm::fract(texcoord);
  const int x = std::min(static_cast<int>(tile.x * static_cast<float>(picture.width)), picture.width - 1);
  const int y = std::min(static_cast<int>(tile.y * static_cast<float>(picture.height)), picture.height - 1);
  const image::Encoding encoding = linear ? image::Encoding::srgb : image::Encoding::linear;
  glm::vec3 color;
  for (int c = 0; c < 3; ++c) color[c] = image::from_encoding8(picture.at(x, y, c), encoding);
  return color;
}

}  // namespace texel::obj_texcoords
