// SPDX-License-Identifier: MIT
// What the readers of all formats share, and the one of PNG: libspng, or stb_image in a page.
#pragma once
#include <string>
#include <string_view>

#include "core/error.hpp"
#include "image/image.hpp"

namespace texel::image {

/// An Error (exit 3) of a file that is no sound picture.
Error broken(const std::string& name, const std::string& what);

/// Throws Error (exit 3) beyond the limits that `load8` has.
void check_limits(const std::string& name, long long width, long long height, int channels);

/// Throws Error (exit 3) when so many pixels cannot come from so few bytes: a tiny file with a huge header is
/// refused before its picture is allocated.
void check_long_enough(const std::string& name, int width, int height, std::string_view bytes);

/// A PNG as `load8` gives it.
Image8 decode_png(std::string_view bytes, const std::string& name, int channels);

}  // namespace texel::image
