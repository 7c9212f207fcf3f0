// SPDX-License-Identifier: MIT
#include "gl/es_source.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <vector>

namespace texel::gl {
namespace {

constexpr const char* kHead =
    "#version 300 es\n"
    "precision highp float;\n"
    "precision highp int;\n"
    "precision highp sampler2D;\n"
    "precision highp samplerCube;\n";

// View 0 is `color`; the shader that shows data views in colours has no VIEW.
constexpr const char* kDecoding = R"(#ifdef VIEW
#if VIEW == 0
#define TEXEL_DRAWS_COLOUR
#endif
#else
#define TEXEL_DRAWS_COLOUR
#endif
#ifdef TEXEL_DRAWS_COLOUR
  if (texel_keeps_bytes) {
    vec3 encoded = clamp(picture.rgb, 0.0, 1.0);
    picture.rgb = mix(encoded / 12.92, pow((encoded + 0.055) / 1.055, vec3(2.4)), greaterThan(encoded, vec3(0.04045)));
  }
#endif
)";

// The vertex goes where 8 bits put it: then triangles cover the pixels that they cover where the limits were
// measured. What is interpolated is moved back by all of the rounding, since those renderers interpolate
// without it. {0} is the picture's size, {1} the shift, {2} and {3} the steps of a pixel that are wanted, and
// that the renderer has. Places far outside, which a float does not tell so finely, and those behind the eye
// stay.
constexpr const char* kRounding =
    R"(  vec2 place = (gl_Position.xy / gl_Position.w * 0.5 + 0.5) * {0} * {2:.1f};
  texel_rounding = vec2(0.0);
  if (gl_Position.w > 0.0 && all(lessThan(abs(place), vec2(4194304.0)))) {{
    vec2 wanted = floor(place + 0.5) / {2:.1f};
    vec2 rounded = floor((wanted + {1}) * {3:.1f} + 0.5) / {3:.1f};
    texel_rounding = (rounded - place / {2:.1f}) * gl_Position.w;
    gl_Position.xy = ((wanted + {1}) / {0} * 2.0 - 1.0) * gl_Position.w;
  }}
)";

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

/// The name in a line "in vec3 name;" or "out vec3 name;" of a type that is interpolated, or "".
std::string interpolated(const std::string& line, const std::string& direction, std::string& type) {
  std::istringstream words(line);
  std::string first, name;
  if (!(words >> first >> type >> name) || first != direction) return {};
  constexpr std::array kTypes = {"float", "vec2", "vec3", "vec4"};
  if (std::find(kTypes.begin(), kTypes.end(), type) == kTypes.end()) return {};
  const std::size_t end = name.find(';');
  return end == std::string::npos ? std::string() : name.substr(0, end);
}

/// Each declaration of an input or output `name` becomes one of `texel_at_name` and a variable `name`. Which
/// of them the compiler sees depends on the shader's own branches: TEXEL_HAS_name says so.
std::string with_copies(const std::string& body, const std::string& direction,
                        std::vector<std::string>& names) {
  std::string result, type;
  std::istringstream lines(body);
  int number = 0;
  for (std::string line; std::getline(lines, line); ++number) {
    if (line.starts_with("#line ")) number = std::stoi(line.substr(6)) - 1;
    const std::string name = interpolated(line, direction, type);
    if (name.empty()) {
      result += line + "\n";
      continue;
    }
    names.push_back(name);
    result += fmt::format("{0} {1} texel_at_{2}; {1} {2};\n#define TEXEL_HAS_{2}\n#line {3}\n", direction,
                          type, name, number + 1);
  }
  return result;
}

std::string for_each(const std::vector<std::string>& names, const std::string& statement) {
  std::string result;
  for (const std::string& name : names) {
    std::string one = "#ifdef TEXEL_HAS_@\n  " + statement + "\n#endif\n";
    replace_all(one, "@", name);
    result += one;
  }
  return result;
}

}  // namespace

std::string es_source(const std::string& text, bool is_fragment, int subpixel_bits) {
  std::string body = text.substr(text.find('\n') + 1);  // without #version
  const bool moves = subpixel_bits < kEnoughSubpixelBits && body.find("gl_VertexID ==") == std::string::npos;
  const bool decodes = is_fragment && body.find("out vec4 picture;") != std::string::npos;
  std::string declared, before, after;
  std::vector<std::string> names;
  if (is_fragment && moves) {
    body = with_copies(body, "in", names);
    if (!names.empty()) {
      replace_all(body, "gl_FragCoord.w", "texel_fragment_w");
      declared = "in vec2 texel_rounding;\nfloat texel_fragment_w;\n";
      before =
          "  vec2 rounding = texel_rounding * gl_FragCoord.w;  // linear in the picture\n"
          "  texel_fragment_w = gl_FragCoord.w + dFdx(gl_FragCoord.w) * rounding.x + dFdy(gl_FragCoord.w) * "
          "rounding.y;\n" +
          for_each(names, "@ = texel_at_@ + dFdx(texel_at_@) * rounding.x + dFdy(texel_at_@) * rounding.y;");
    }
  } else if (moves) {
    body = with_copies(body, "out", names);
    if (!names.empty()) {
      declared =
          fmt::format("uniform vec2 {};\nuniform vec2 {};\nout vec2 texel_rounding;\n", kPictureSize, kShift);
      after = for_each(names, "texel_at_@ = @;") + fmt::format(kRounding, kPictureSize, kShift,
                                                               static_cast<double>(1 << kEnoughSubpixelBits),
                                                               static_cast<double>(1 << subpixel_bits));
    }
  }
  if (decodes) {
    declared += fmt::format("uniform bool {};\n", kKeepsBytes);
    after += kDecoding;
  }
  if (declared.empty()) return kHead + body;
  return std::string(kHead).append(declared).append("#define main texel_main\n").append(body) +
         "#undef main\nvoid main() {\n" + before + "  texel_main();\n" + after + "}\n";
}

std::string es_message(const std::string& log) {
  std::string message = log;
  replace_all(message, "texel_at_", "");
  replace_all(message, "texel_fragment_w", "gl_FragCoord.w");
  const bool mixes_numbers = log.find("int") != std::string::npos && log.find("float") != std::string::npos &&
                             (log.find("wrong operand types") != std::string::npos ||
                              log.find("cannot convert") != std::string::npos ||
                              log.find("dimension mismatch") != std::string::npos);
  if (mixes_numbers)
    message += "\nIn the browser an int does not become a float by itself: write 2.0 in place of 2.";
  return message;
}

}  // namespace texel::gl
