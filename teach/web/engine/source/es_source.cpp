// SPDX-License-Identifier: MIT
#include "es_source.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <vector>

#include "core/plain_text.hpp"

namespace texel::gl {
namespace {

constexpr const char* kHead =
    "#version 300 es\n"
    "precision highp float;\n"
    "precision highp int;\n"
    "precision highp sampler2D;\n"
    "precision highp samplerCube;\n";

// View 0 is `color`; the shader that shows data views in colours has no VIEW. {} is what is done there.
constexpr const char* kOfColors = R"(#ifndef VIEW
#define VIEW 0
#endif
#if VIEW == 0
{}#endif
)";
constexpr const char* kDecoding = R"(  if (texel_keeps_bytes) {
    vec3 encoded = clamp(picture.rgb, 0.0, 1.0);
    picture.rgb = mix(encoded / 12.92, pow((encoded + 0.055) / 1.055, vec3(2.4)), greaterThan(encoded, vec3(0.04045)));
  }
)";
constexpr const char* kEncoding = R"(  if (!texel_keeps_bytes) {
    vec3 light = clamp(picture.rgb, 0.0, 1.0);
    picture.rgb = mix(light * 12.92, 1.055 * pow(light, vec3(1.0 / 2.4)) - 0.055, greaterThan(light, vec3(0.0031308)));
  }
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

// What is interpolated is linear in the picture when it is divided by w, so its difference to the next pixel
// is its derivative. The second line: how far the vertices were moved is told at the place that was moved.
constexpr const char* kMovingBack =
    R"(  vec2 rounding = texel_rounding * gl_FragCoord.w;
  rounding += dFdx(rounding) * rounding.x + dFdy(rounding) * rounding.y;
  texel_fragment_w = gl_FragCoord.w + dFdx(gl_FragCoord.w) * rounding.x + dFdy(gl_FragCoord.w) * rounding.y;
)";

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

/// Each declaration "in vec3 name;" or "out vec3 name;" of a type that is interpolated becomes one of
/// `texel_at_name` and a variable `name`. Which of them the compiler sees depends on the shader's own
/// branches: TEXEL_HAS_name says so.
std::string with_copies(const std::string& body, const std::string& direction,
                        std::vector<std::string>& names) {
  std::string result;
  int next = 1;
  for (const std::string& line : lines_of(body)) {
    next = line.starts_with("#line ") ? std::stoi(line.substr(6)) : next + 1;
    std::istringstream words(line);
    std::string first, type, name;
    words >> first >> type >> name;
    const bool is_smooth = type == "float" || type == "vec2" || type == "vec3" || type == "vec4";
    const std::size_t end = name.find(';');
    if (first != direction || !is_smooth || end == std::string::npos) {
      result += line + "\n";
      continue;
    }
    names.push_back(name.substr(0, end));
    result += fmt::format("{0} {1} texel_at_{2}; {1} {2};\n#define TEXEL_HAS_{2}\n#line {3}\n", direction,
                          type, names.back(), next);
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

// A loop that never ends would stop the browser's drawing for good: its drivers do not give up. So all loops
// of one pixel together have so many rounds.
constexpr const char* kRounds =
    R"(int texel_rounds = 0;
bool texel_goes_on() {{ return ++texel_rounds <= {}; }}
)";
/// What a pixel shows whose loops had to be ended. No lab draws this alpha.
constexpr const char* kEndless = "  if (texel_rounds > {}) picture = vec4(1.0, 0.0, 1.0, 0.5);\n";

/// Where the comment or the line of the preprocessor ends that begins at `at`; `at` where none does.
std::size_t after_comment(const std::string& text, std::size_t at) {
  if (text.compare(at, 2, "/*") == 0) {
    const std::size_t end = text.find("*/", at + 2);
    return end == std::string::npos ? text.size() : end + 2;
  }
  if (text.compare(at, 2, "//") == 0 || text[at] == '#') {
    std::size_t end = text.find('\n', at);
    while (end != std::string::npos && end > 0 && text[end - 1] == '\\') end = text.find('\n', end + 1);
    return std::min(end, text.size());
  }
  return at;
}

/// Behind the parentheses that follow; 0 where they do not close.
std::size_t after_parentheses(const std::string& text, std::size_t at) {
  for (int depth = 0; at < text.size(); ++at) {
    if (const std::size_t next = after_comment(text, at); next > at)
      at = next - 1;
    else if (text[at] == '(')
      ++depth;
    else if (text[at] == ')' && --depth <= 0)
      return at + 1;
  }
  return 0;
}

/// Counts the rounds of all loops. Changes no line's number. Gives whether there was a loop.
bool guard_loops(std::string& text) {
  std::vector<std::size_t> bodies;
  bool has_do = false;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t begin = at, next = after_comment(text, at);
    while (at < text.size() && is_word(text[at])) ++at;
    const std::string word = text.substr(begin, at - begin);
    if (word.empty()) at = std::max(at + 1, next);
    if (word != "for" && word != "while" && word != "do") continue;
    has_do |= word == "do";
    const std::size_t body = word == "do" ? at : after_parentheses(text, at);
    const std::size_t first = text.find_first_not_of(" \t\r\n", body);
    const bool ends_do = word == "while" && has_do && first != std::string::npos && text[first] == ';';
    if (body > 0 && !ends_do) bodies.push_back(body);
  }
  std::sort(bodies.rbegin(), bodies.rend());  // from the end on, so that the places stay
  for (const std::size_t body : bodies) text.insert(body, " if (!texel_goes_on()) break; else");
  return !bodies.empty();
}

}  // namespace

std::string es_source(const std::string& text, bool is_fragment, int subpixel_bits, bool encodes) {
  std::string body = text.substr(text.find('\n') + 1);  // without #version
  const bool loops = guard_loops(body);
  const bool moves = subpixel_bits < kEnoughSubpixelBits && body.find("gl_VertexID ==") == std::string::npos;
  const bool decodes = is_fragment && body.find("out vec4 picture;") != std::string::npos;
  std::string declared, before, after;
  std::vector<std::string> names;
  if (is_fragment && moves) {
    body = with_copies(body, "in", names);
    if (!names.empty()) {
      replace_all(body, "gl_FragCoord.w", "texel_fragment_w");
      declared = "in vec2 texel_rounding;\nfloat texel_fragment_w;\n";
      before = kMovingBack +
               for_each(names,
                        "@ = texel_at_@ * gl_FragCoord.w;\n"
                        "  @ = (@ + dFdx(@) * rounding.x + dFdy(@) * rounding.y) / texel_fragment_w;");
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
    after += fmt::format(kOfColors, encodes ? kEncoding : kDecoding);
  }
  if (loops) {
    declared += fmt::format(kRounds, kMostRounds);
    if (decodes) after += fmt::format(kEndless, kMostRounds);
  }
  if (before.empty() && after.empty()) return kHead + declared + body;
  return std::string(kHead).append(declared).append("#define main texel_main\n").append(body) +
         "#undef main\nvoid main() {\n" + before + "  texel_main();\n" + after + "}\n";
}

std::string es_message(const std::string& log) {
  std::string message = log;
  replace_all(message, "texel_at_", "");
  replace_all(message, "texel_fragment_w", "gl_FragCoord.w");
  const auto has = [&](const char* text) { return log.find(text) != std::string::npos; };
  if (has("int") && has("float") &&
      (has("wrong operand types") || has("cannot convert") || has("dimension mismatch")))
    message += "\nIn the browser an int does not become a float by itself: write 2.0 in place of 2.";
  return message;
}

}  // namespace texel::gl
