// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "core/json.hpp"
#include "course/case.hpp"

/// The files between the tools and a lab's program: the list of --batch, and the results.json that the
/// program leaves beside the pictures.
namespace texel::course {

/// {parameter: value}; a value that is read is a text, a number or a boolean. Throws Error (exit 2).
Json to_json(const std::vector<Setting>& settings);
std::vector<Setting> settings_from(const Json& set);

/// `[{"name", "view", "size", "set": {parameter: value}}]`. The name is the file; a mesh has no view and
/// size.
std::string to_batch(const std::vector<Case>& cases);

/// Reads such a list. `name` becomes name.png, unless it ends in .png or .pfm itself, or in .ply for a mesh.
/// Throws Error (exit 2) that counts to the entry that is wrong.
/// Whether the lab has such views and parameters is not known here.
std::vector<Case> parse_batch(const std::string& list);

/// What became of a case.
struct Drawing {
  std::string file;
  bool is_drawn = false;
  std::string message;   ///< for people: why it is not drawn, or ""
  std::string place;     ///< the file and line that are to blame, as "cube.obj:9", or ""
  std::string drawn_by;  ///< the driver, as gl::Context::name; "" for what is not drawn
  double milliseconds = 0;

  bool operator==(const Drawing&) const = default;
};

/// Its name in the folder of the pictures.
inline constexpr const char* kDrawingsFile = "results.json";

/// `[{"name", "status": "drawn" | "failed", "message", "place", "drawn_by", "milliseconds"}]`
std::string to_json(const std::vector<Drawing>& drawings);

/// Reads such a list, which a program may have written that nobody trusts: entries that are none are left
/// out, and texts are cut off after 2000 bytes.
std::vector<Drawing> parse_drawings(const std::string& text);

}  // namespace texel::course
