// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "core/error.hpp"

/// The catalogue of mutants, `tests/mutants/*.toml`: small wrong changes of the kind that a student or a
/// maintainer makes. The tests must notice them, and the grader recognises them in a student's pictures.
/// `tests/mistakes/*.toml` has more mistakes that students make; only the grader must notice those. And the
/// catalogue of equivalents, `tests/equivalents/*.toml`: right solutions written another way, which the
/// grader must accept.
///
///     [[mutant]]                                            # or [[equivalent]]
///     name = "green-flipped"                                # unique over all files
///     file = "shaders/05_normal_map/decode_normal.glsl"     # from the project's root
///     # Text that occurs in the file exactly once, and what stands there instead, which may be "":
///     what = "return color * 2.0 - 1.0;"
///     by = "return (color * 2.0 - 1.0) * vec3(1.0, -1.0, 1.0);"
///     step = "5.1"                                          # optional: the step that it is a solution of
///     # What a student should read: what is wrong, and after a colon or full stop what is right. Of an
///     # equivalent, what is different and why it is right.
///     says = "Green points down in your map: +Y is up."
///     same = "blue-flipped"                                 # optional: the step's mutant with the same
///                                                           # pictures; its text fits both
///     survives = "…"                                        # optional, no equivalent has it: why no test
///                                                           # can notice
namespace texel::material {

struct Mutant {
  bool is_right = false;  ///< an equivalent: tests and grader must accept it
  std::string name;       ///< lower-case letters, digits and '-'
  std::string file;       ///< relative, with '/'
  std::string what, by;
  std::string step;  ///< "5.1", or ""
  std::string says;
  std::string same;      ///< the mutant from which no picture tells it, or ""
  std::string survives;  ///< why it is right that no test notices it, or ""
  Place place;           ///< where the catalogue has it
};

/// What a mistake's sentences begin with, up to a colon or a full stop, as a title: "Green is inverted" of
/// "Green is inverted: in these maps green points up (+Y)."
std::string title_of(const std::string& says);

/// The mutants of the course's tree that a student may make, of both folders. Throws Error (exit 3) as
/// read_catalogue, and when `same` names no other mutant of the step.
std::vector<Mutant> read_mistakes(const std::filesystem::path& tree);

/// The tables of these kinds in every .toml file of the folder, by file, then by kind. Throws Error (exit 3)
/// with file and line for broken TOML, an unknown key, a wrong type, a missing or empty text, a name that is
/// used twice or has other signs, a file that is no path below the root, a step that is not like 5.1, and a
/// replacement that changes nothing; and when there is nothing in them. Threats, `tests/threats/*.toml`, are
/// changes that do harm or cheat: they are asked for by their kind, so that nobody runs them outside the
/// grader's sandbox by mistake. They have no `survives`; `says` is what must happen.
std::vector<Mutant> read_catalogue(const std::filesystem::path& folder,
                                   const std::vector<std::string>& kinds = {"mutant", "equivalent"});

/// The text of the mutant's file with the mutant's change. Throws Error (exit 3) with the mutant's place when
/// `what` does not occur in it exactly once.
std::string mutated(const Mutant& mutant, const std::string& text);

}  // namespace texel::material
