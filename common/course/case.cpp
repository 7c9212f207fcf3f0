// SPDX-License-Identifier: MIT
#include "course/case.hpp"

#include <algorithm>
#include <array>

#include "core/error.hpp"
#include "core/pattern.hpp"

namespace texel::course {
namespace {

struct ViewOf {
  const char* name;
  Unit unit;
};
constexpr std::array<ViewOf, 10> kViews = {{{"color", Unit::steps},
                                            {"normal", Unit::degrees},
                                            {"tangent", Unit::degrees},
                                            {"texcoord", Unit::texture_widths},
                                            {"direction", Unit::degrees},
                                            {"lod", Unit::levels},
                                            {"depth", Unit::units},
                                            {"mask", Unit::units},
                                            {"error", Unit::units},
                                            {"mesh", Unit::degrees}}};
constexpr std::array kUnits = {"8-bit steps", "degrees", "levels", "texels", "texture widths", "units"};

}  // namespace

const char* name_of(View view) {
  return kViews.at(static_cast<std::size_t>(view)).name;
}

std::optional<View> find_view(std::string_view name) {
  const auto found = std::ranges::find(kViews, name, &ViewOf::name);
  if (found == kViews.end()) return {};
  return static_cast<View>(found - kViews.begin());
}

const char* name_of(Unit unit) {
  return kUnits.at(static_cast<std::size_t>(unit));
}

Unit unit_of(View view) {
  return kViews.at(static_cast<std::size_t>(view)).unit;
}

std::optional<Size> find_size(const std::string& text) {
  static const Pattern kSize("([0-9]{1,5})x([0-9]{1,5})");
  const Pattern::Groups sides = kSize.match(text);
  if (sides.empty()) return {};
  const auto is_side = [](int pixels) { return pixels >= 1 && pixels <= Size::kMostPixels; };
  const Size size{std::stoi(sides[1]), std::stoi(sides[2])};
  return is_side(size.width) && is_side(size.height) ? std::optional(size) : std::nullopt;
}

Size parse_size(const std::string& text) {
  if (const auto size = find_size(text)) return *size;
  throw Error::usage("'" + text + "' is not a size", "write WIDTHxHEIGHT in pixels, each from 1 to 16384");
}

std::string as_text(Size size) {
  return std::to_string(size.width) + "x" + std::to_string(size.height);
}

}  // namespace texel::course
