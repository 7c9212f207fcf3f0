// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// A case: one picture of a lab, from its line in the lab file to the grader's judgement. The gallery's
/// looks, the bench's and the graded cases, and the entries of a batch are all cases.
namespace texel::course {

/// A parameter and its value as the command line takes it: {"normal_map", "on"}.
struct Setting {
  std::string parameter, value;

  bool operator==(const Setting&) const = default;
};

/// What a picture shows: the colours, or one of the quantities on the way to them. A mesh is no picture: it
/// is the lab's vertex stream.
enum class View { color, normal, tangent, texcoord, direction, lod, depth, mask, error, mesh };
const char* name_of(View view);
/// The view of that name, if there is one.
std::optional<View> find_view(std::string_view name);

/// What a difference is counted in.
enum class Unit {
  steps,           ///< 1/255 of a colour channel's range
  degrees,         ///< angle between two directions
  levels,          ///< of mipmaps
  texels,          ///< distance of two texture coordinates
  texture_widths,  ///< the same, in widths of the texture
  units            ///< of world space; or of the view itself
};
/// "8-bit steps", "degrees", "levels", "texels", "texture widths", "units"
const char* name_of(Unit unit);
/// In what the judge counts a view's error.
Unit unit_of(View view);

/// In pixels, each side from 1 to kMostPixels.
struct Size {
  static constexpr int kMostPixels = 16384;
  int width = 0, height = 0;

  bool operator==(const Size&) const = default;
};
/// The size that is written as "512x512"; nothing for any other text.
std::optional<Size> find_size(const std::string& text);
/// The same; throws Error (usage) for any other text.
Size parse_size(const std::string& text);
/// "512x512"
std::string as_text(Size size);

/// A parameter whose value is drawn from the secret seed: one of these values, or, of two numbers, any
/// between.
struct Hidden {
  std::string parameter;
  std::vector<std::string> values;
  bool are_numbers = false;  ///< and no texts, as "2.5"

  bool operator==(const Hidden&) const = default;
};

struct Case {
  std::string lab;   ///< the lab's folder, "05_normal_map"
  std::string name;  ///< unique in the lab
  std::string file;  ///< that the lab's program writes: a .png, a .pfm of a data view, or a .ply of a mesh
  View view = View::color;
  Size size = {512, 512};
  std::vector<Setting> settings;  ///< parameters that differ from the default, in the file's order

  // Of a graded case:
  std::string step;                          ///< "5.1", that it judges
  double limit = 0;                          ///< full marks up to this difference, in unit_of(view)
  bool hidden = false;                       ///< some of its settings come from the secret seed:
  std::vector<Hidden> hidden_settings = {};  ///< these, and models that nobody has seen

  [[nodiscard]] bool is_mesh() const { return view == View::mesh; }

  bool operator==(const Case&) const = default;
};

}  // namespace texel::course
