// SPDX-License-Identifier: MIT
#include "course/case.hpp"

#include <algorithm>
#include <array>
#include <charconv>

namespace texel::course {
namespace {

constexpr std::array kViews = {"color", "normal", "tangent", "texcoord", "direction",
                               "lod",   "depth",  "mask",    "error",    "mesh"};
constexpr std::array kUnits = {"8-bit steps", "degrees", "levels", "texels", "texture widths", "units"};

}  // namespace

const char* name_of(View view) {
  return kViews.at(static_cast<std::size_t>(view));
}

std::optional<View> find_view(std::string_view name) {
  const auto found = std::find(kViews.begin(), kViews.end(), name);
  if (found == kViews.end()) return {};
  return static_cast<View>(found - kViews.begin());
}

const char* name_of(Unit unit) {
  return kUnits.at(static_cast<std::size_t>(unit));
}

Unit unit_of(View view) {
  switch (view) {
    case View::color:
      return Unit::steps;
    case View::normal:
    case View::tangent:
    case View::direction:
    case View::mesh:
      return Unit::degrees;
    case View::lod:
      return Unit::levels;
    case View::texcoord:
      return Unit::texture_widths;
    case View::depth:
    case View::mask:
    case View::error:
      break;
  }
  return Unit::units;
}

std::optional<Size> find_size(std::string_view text) {
  Size size;
  const char* end = text.data() + text.size();
  const auto [middle, error] = std::from_chars(text.data(), end, size.width);
  if (error != std::errc{} || middle == end || *middle != 'x') return {};
  if (const auto [last, fault] = std::from_chars(middle + 1, end, size.height);
      fault != std::errc{} || last != end)
    return {};
  const auto is_side = [](int pixels) { return pixels >= 1 && pixels <= Size::kMostPixels; };
  if (!is_side(size.width) || !is_side(size.height)) return {};
  return size;
}

std::string as_text(Size size) {
  return std::to_string(size.width) + "x" + std::to_string(size.height);
}

}  // namespace texel::course
