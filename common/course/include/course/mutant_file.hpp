// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "core/error.hpp"

/// The catalogue of mutants, `tests/mutants/*.toml`: small wrong changes of the kind that a student or a
/// maintainer makes. The tests must notice them, and the grader recognises them in a student's pictures.
///
///     [[mutant]]
///     name = "green-flipped"                                # unique over all files
///     file = "shaders/05_normal_map/decode_normal.glsl"     # from the project's root
///     what = "return color * 2.0 - 1.0;"                    # text of the file that occurs exactly once in
///     it by = "return (color * 2.0 - 1.0) * vec3(1.0, -1.0, 1.0);"     # what stands there instead; may be
///     "" step = "5.1"                                          # optional: the step of the lab that is then
///     wrong says = "Green points down in your map: +Y is up."     # one sentence that a student should read
///     survives = "…"                                        # optional: why no test can notice it
namespace texel::course {

struct Mutant {
  std::string name;  ///< lower-case letters, digits and '-'
  std::string file;  ///< relative, with '/'
  std::string what, by;
  std::string step;  ///< "5.1", or ""
  std::string says;
  std::string survives;  ///< why it is right that no test notices it, or ""
  Place place;           ///< where the catalogue has it
};

/// Reads one file of the catalogue. Throws Error (exit 3) with file and line for broken TOML, an unknown key,
/// a wrong type, a missing or empty text, a name that is taken or has other signs, a file that is no path
/// below the root, a step that is not like 5.1, and a replacement that changes nothing.
std::vector<Mutant> read_mutants(const std::filesystem::path& file);

/// Every .toml file of the folder, by name. Throws Error (exit 3) when there is none, when two files have
/// mutants of the same name, or as read_mutants.
std::vector<Mutant> read_catalogue(const std::filesystem::path& folder);

/// The text of the mutant's file with the mutant's change. Throws Error (exit 3) with the mutant's place when
/// `what` does not occur in it exactly once.
std::string mutated(const Mutant& mutant, const std::string& text);

}  // namespace texel::course
