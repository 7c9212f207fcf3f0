// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "judge/mistakes.hpp"

/// What a student's tree gets of the catalogue of mistakes.
namespace texel::material {

/// Samples of the picture `wrong`: most from where it differs from `reference` by more than the case's limit,
/// the others from where it does not. None when it differs nowhere, or is no picture. Both are a file's
/// bytes.
judge::Samples sampled(const course::Case& of, std::string_view reference, std::string_view wrong);

/// A lab's mistakes as the file that judge::parse_mistakes reads.
std::string to_json(const std::vector<judge::Mistake>& mistakes);

}  // namespace texel::material
