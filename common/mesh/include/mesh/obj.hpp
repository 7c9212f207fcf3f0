// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace texel::mesh {

/// Stands for "this corner has no vt" and the like.
inline constexpr std::uint32_t no_index = 0xFFFFFFFFU;

/// One corner of a triangle: indices from 0 into ObjData's lists.
struct Corner {
  std::uint32_t position = 0;
  std::uint32_t texcoord = no_index;
  std::uint32_t normal = no_index;
  friend bool operator==(const Corner&, const Corner&) = default;
};

/// The part of a `newmtl` that we use. Names run to the end of their line, and paths have '/' for '\'.
struct Material {
  std::string name;
  glm::vec3 diffuse{1.0F};  ///< Kd, as written
  /// map_Kd, or ""; after load_obj an absolute path, or "" where there is no file.
  std::string color_map = {};
};

/// From this triangle on, until the next run: a material's, group's or object's name.
struct NamedRun {
  std::string name;
  std::uint32_t first_triangle = 0;
};

/// From this triangle on: the smoothing group, 0 for off.
struct SmoothingRun {
  std::uint32_t group = 0;
  std::uint32_t first_triangle = 0;
};

/// An OBJ file as parsed: separate lists as in the file, and three corners a triangle. Texture coordinates
/// have t up, as OBJ has them; everything is in the file's own frame and units.
struct ObjData {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec2> texcoords;
  std::vector<glm::vec3> normals;       ///< as written, of any length
  std::vector<Corner> corners;          ///< three a triangle, polygons cut
  std::vector<NamedRun> material_runs;  ///< `usemtl`
  std::vector<NamedRun> group_runs;     ///< `g` and `o`
  std::vector<SmoothingRun> smoothing;  ///< `s`; empty when the file never switches smoothing on
  std::vector<std::string> libraries;   ///< each `mtllib` line's names, as written
  std::vector<Material> materials;      ///< read from the libraries by load_obj
  std::vector<std::string> warnings;    ///< one readable line for each kind of repair and trouble

  [[nodiscard]] std::size_t triangle_count() const { return corners.size() / 3; }
};

/// Each triangle of a polygon may cover all of it: the pictures of larger ones would take minutes.
inline constexpr std::size_t max_face_corners = 65536;

/// Parses an OBJ text in one pass. Knows v (xyz, also with a weight or a color, which nothing shows), vt (1
/// to 3 numbers), vn, f (and fo) with v, v/vt, v//vn, v/vt/vn and negative indices, p, l, g, o, s, usemtl,
/// mtllib, comments, lines continued by '\', LF, CRLF and CR, tabs, a byte order mark. Numbers are rounded
/// correctly to float32. A face may only use lines above it. A line of v, vt or vn with NaN, infinity or a
/// number too large for float32 counts as missing: a face that uses the v is left out, a vt is none, a vn is
/// generated. Faces are cut into triangles in their own plane (polygon.hpp). Throws Error (exit 3) with
/// `name` and the line: an index of v that is 0 or out of range, one of vt that is out of range (0 is none),
/// a number that is malformed, a face of more than max_face_corners, binary data, an empty text, a text
/// without a face of three corners. Linear time. Repairs are counted and told in ObjData::warnings.
ObjData parse_obj(std::string_view text, const std::string& name);

/// Maps a file into memory and parses it, then reads its material libraries from beside it, and finds their
/// color maps beside the library or else beside the file, there also without the folders in their names. What
/// is missing or wrong is a warning. Throws Error (exit 3) as parse_obj and when the file cannot be read.
ObjData load_obj(const std::filesystem::path& path);

/// Parses an MTL text: newmtl, Kd and map_Kd (any case); the rest is ignored. Adds a warning, with `name`,
/// for lines that are lost (a Kd that is no number, a property before the first newmtl), and one for options
/// of map_Kd (-s, -o, -t, -mm, -clamp) that ask for more than the picture as it is.
std::vector<Material> parse_mtl(std::string_view text, const std::string& name,
                                std::vector<std::string>& warnings);

// What lab 3 teaches of it: files in labs/03_obj_texcoords define these functions.

/// The position of a `v` line from its numbers, of which there are at least 3.
glm::vec3 position_from(std::span<const float> numbers);

/// The texture coordinate of a `vt` line from its numbers, of which there are 1 to 3: u, then v, then w.
glm::vec2 texcoord_from(std::span<const float> numbers);

/// The place, from 0, that an OBJ index means in a list of `count` entries so far: 1 is the first entry, -1
/// the last one. `written` is not 0; the caller refuses a result outside the list.
std::int64_t resolve_index(std::int64_t written, std::int64_t count);

}  // namespace texel::mesh
