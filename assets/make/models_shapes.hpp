// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <initializer_list>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

/// The building blocks of the models: sections swept along a path, rows of points joined to a surface, and
/// the solids made of them. Everything is counter-clockwise seen from outside and in double precision;
/// texture coordinates are lengths on the surface.
namespace texel::assets {

using glm::dvec2;
using glm::dvec3;

struct Corner {
  dvec3 position{0};
  dvec2 texcoord{0};
  dvec3 normal{0};
};

using Face = std::vector<Corner>;

/// A piece of surface; most are closed solids. Corners are shared only when the piece is written.
struct Part {
  std::vector<Face> faces;

  /// Adds a face without the corners that fall together; nothing when fewer than three remain.
  void add(Face face);
  Part& operator+=(const Part& other);
};

/// One row of points per station; every row has equally many. A closed row names its first point only once.
using Rows = std::vector<std::vector<dvec3>>;

/// Monotone piecewise cubic through (x, y) keys, constant beyond them: no overshoot between keys.
/// Source: Fritsch and Carlson, "Monotone piecewise cubic interpolation", SIAM J. Numer. Anal. 17(2), 1980.
class Profile {
 public:
  /// Keys as x, y, x, y, ...; x rises.
  Profile(std::initializer_list<double> keys);
  double operator()(double x) const;

 private:
  std::vector<dvec2> keys_;
  std::vector<double> slopes_;
};

/// A smooth curve through `points` (uniform Catmull-Rom), `steps` pieces between two of them.
std::vector<dvec3> curve_through(const std::vector<dvec3>& points, int steps);

/// A closed ring of `count` points around the origin, counter-clockwise, starting at the bottom (0, -down),
/// at equal arc lengths: half a superellipse |x/width|^n + |y/height|^n = 1 above and another one below.
/// `count` is even, so that point count/2 is the top.
struct Section {
  double width = 0, up = 0, down = 0;
  double up_exponent = 2, down_exponent = 2;
};
std::vector<dvec2> ring(const Section& section, int count);

/// Where a section stands: `side` x `up` = the direction of travel.
struct Frame {
  dvec3 origin, side, up;
  [[nodiscard]] dvec3 at(dvec2 point) const { return origin + point.x * side + point.y * up; }
};
/// A frame at each point of a path, with `up` kept as near to `hint` as the path allows.
std::vector<Frame> frames_along(const std::vector<dvec3>& path, dvec3 hint);

/// How texture coordinates are laid on rows: u by arc length along the row, 0 at the column `middle`; v by
/// arc length across the rows, 0 at `base_row`.
struct Wrap {
  int middle = 0;
  int base_row = 0;
  /// False: a swept body; each row has its own u, and all of a row the same v (the mean distance of the
  /// rows). True: a plate hung from `base_row`; each column has the u that it has there, and its own v.
  bool plate = false;
};

/// Joins rows to a surface. Outside is where (along the row) x (to the next row) points.
Part open_surface(const Rows& rows, const Wrap& wrap);
/// Rows that close on themselves, with both ends closed by a polygon where they are not already a point. The
/// rows are convex at the ends and run counter-clockwise about the direction of travel.
Part solid(const Rows& rows, const Wrap& wrap);

/// A tube with elliptic sections: `radius` gives (side, up) at the fraction 0..1 of the path's points.
Part tube(const std::vector<dvec3>& path, dvec3 hint, int sides, const std::function<dvec2(double)>& radius);
Part cone(dvec3 base, dvec3 tip, double radius, int sides);
Part ellipsoid(const Frame& frame, dvec3 radii, int columns, int rows);

/// The unit sphere and a torus about the y axis with their exact normals; u runs eastwards from the far side
/// (-z), v upwards from the south pole or from the inner side of the tube.
Part sphere_part(int columns, int rows);
Part torus_part(double major, double minor, int columns, int rows);

/// An upright block over a counter-clockwise (seen from above) outline in (x, z), with its upper edge
/// bevelled.
Part block(const std::vector<dvec2>& outline, double bottom, double top, double bevel);
Part box(dvec3 low, dvec3 high, double bevel);
/// A rectangle with its two ends in x rounded to half ellipses of length `front` (+x) and `back` (-x); 0 is
/// square.
std::vector<dvec2> rounded_outline(double x0, double x1, double half_width, double front, double back);

/// Texture coordinates from the two axes in which each face lies, upright and never mirrored.
void map_by_face(Part& part);

/// Corner normals: the angle-weighted mean of the faces at the same position that turn by less than `crease`.
/// Source: Thuermer and Wuethrich, "Computing vertex normals from polygonal facets", JGT 3(1), 1998.
void smooth(Part& part, double crease_degrees);

dvec3 face_normal(const Face& face);
struct ObjStyle {
  double unit = 1;     ///< size of the model, of which a millionth is rounding noise
  int digits = 6;      ///< significant digits of a position
  bool shared = true;  ///< equal lines are written once
  bool texcoords = true;
};

/// A text OBJ under construction.
class ObjText {
 public:
  /// `comment` is put at the head, one `# ` for each line; `library` may be empty.
  ObjText(const std::string& comment, const std::string& library, const ObjStyle& style = {});
  /// Starts a group of faces; an empty material writes no `usemtl`.
  void group(const std::string& name, const std::string& material);
  /// Adds the faces of a part; their normals too when `smooth` has been called.
  void add(const Part& part);
  [[nodiscard]] std::string text() const;

 private:
  struct Pool {
    std::string keyword, lines;
    std::unordered_map<std::string, int> index;
    int count = 0;
    int add(const std::string& numbers, bool shared);
  };
  std::string head_, faces_;
  ObjStyle style_;
  Pool positions_{"v", {}, {}, 0}, texcoords_{"vt", {}, {}, 0}, normals_{"vn", {}, {}, 0};
};

struct Group {
  std::string name;  ///< of the group and of its material
  Part part;
};
/// The OBJ of a whole model: moved and scaled into the unit sphere, and its texture coordinates (lengths
/// until here) scaled so that one copy of the texture covers `texture_size` before that.
std::string model_text(const std::string& comment, const std::string& library, std::vector<Group> groups,
                       double texture_size);

struct Material {
  std::string name, colour, texture;  ///< sRGB colour as three numbers; a file in assets/textures, or empty
};
std::string material_text(const std::string& comment, const std::vector<Material>& materials);

}  // namespace texel::assets
