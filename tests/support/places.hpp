// SPDX-License-Identifier: MIT
#pragma once

namespace texel::test {

/// The folders of the programs, of the build and of the tree: the same in every test, set in one file.
extern const char* const kBin;
extern const char* const kBuild;
extern const char* const kSource;

}  // namespace texel::test
