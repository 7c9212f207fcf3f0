// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>

#include "image/compared.hpp"
#include "judge/judge.hpp"
#include "judge/mistakes.hpp"
#include "judge/results.hpp"

/// The judge's work on files.
namespace texel::check {

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

}  // namespace texel::check
