// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "check/studio.hpp"
#include "image/compared.hpp"
#include "judge/judge.hpp"
#include "judge/mistakes.hpp"
#include "judge/results.hpp"

/// The grader on a student's own machine: the public cases of a tree, drawn by its own programs and judged
/// beside the expected pictures that came with it.
namespace texel::check {

/// A tree with steps, and where it was built.
struct OwnTree {
  std::filesystem::path source, build;
};

/// Where a lab's expected pictures lie: for each public case `name.png`, `.pfm` or `.ply`, `name.mask.png`,
/// kMistakesFile and kRendererFile.
std::filesystem::path expected_folder(const std::filesystem::path& source, const course::Lab& lab);
/// Beside the expected pictures: what known mistakes look like in the public cases.
inline constexpr const char* kMistakesFile = "mistakes.json";
/// Beside the expected pictures: what drew them.
inline constexpr const char* kRendererFile = "renderer.txt";

/// Whether a renderer of this name (GL_RENDERER) draws by the processor: Mesa's llvmpipe and softpipe,
/// zink on Vulkan's llvmpipe, SwiftShader.
bool is_software(const std::string& renderer);
/// What a student should know: `own` drew here, and `expected`, or "" if that is not known, what is compared
/// with.
std::string renderer_note(const std::string& own, const std::string& expected);

/// What stands in the kMistakesFile of such a folder. Throws Error (exit 3) when it is missing or broken.
std::vector<judge::Mistake> known_mistakes(const std::filesystem::path& expected);

/// What a case is judged by.
struct ExpectedFiles {
  std::filesystem::path reference;  ///< what the solution draws
  std::filesystem::path mask;       ///< where the object is, as the solution draws it; none for meshes
};

/// Judges the file `picture`, which may be missing, or a link or folder, which are no pictures. Throws Error
/// (exit 3) when the expected files cannot be read.
judge::Verdict judge(const course::Case& of, const ExpectedFiles& expected,
                     const std::filesystem::path& picture);

/// The bytes of a drawn picture, or "" where there is none that a case could have.
std::string picture_bytes(const std::filesystem::path& picture);

/// The pictures of a case that was checked. Throws Error (exit 3) if it compares vertices, or if a picture is
/// missing or broken.
image::Compared compared(const judge::CaseResult& one);

/// The steps whose code is as it was at first (course::untouched_steps).
std::set<std::string> untouched_steps(const OwnTree& tree);

/// Draws cases of a lab into a folder, over what is there: by the tree's programs, or in a browser by the
/// labs themselves. Each that it does not draw has a fault. Called by several threads at once, unless there
/// is one processor.
using Draws =
    std::function<Drawn(const course::Lab&, const std::vector<course::Case>&, const std::filesystem::path&)>;
/// The programs of the tree, as they are built. `context` is their --context.
Draws by_programs(const OwnTree& tree, const std::string& context);

/// Builds a lab's program in its tree, when nobody else builds there; `waits` is called with the name of who
/// does, if there is one, and `who` is ours. Returns the compiler's messages from the first error on, their
/// paths from the tree's root on, or "" when it was built. Throws Error (exit 3) without CMake.
std::string build_program(const OwnTree& tree, const course::Lab& lab, const std::string& who,
                          const std::function<void(const std::string&)>& waits);

/// Draws the public cases of the labs and judges them as the grader does. A renderer in software draws,
/// unless the environment asks for another or the machine has none; a note of each lab is its renderer_note.
/// Steps that are as they were at first are said to be so. The build folder remembers what passed: a step
/// that passed, and fails since another one changed, is skipped and names that one. Each case's `picture` and
/// `reference` are paths of files; there are no partial scores, only 0 and 1. Throws Error (exit 3) when a
/// program was not built, or expected pictures are missing. What is wrong with markers is a note too.
std::vector<judge::LabResult> check(const OwnTree& tree, const std::vector<course::Lab>& labs,
                                    const Draws& draws);

/// One step of a lab alone, in the lab's results: no other one is drawn, and it is not skipped. Throws as
/// check.
judge::LabResult check_step(const OwnTree& tree, const course::Lab& lab, const std::string& step,
                            const Draws& draws);

/// The files that a student of the lab edits, and the shared shaders.
std::vector<std::filesystem::path> edited_files(const std::filesystem::path& source, const course::Lab& lab);

}  // namespace texel::check
