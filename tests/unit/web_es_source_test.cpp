// SPDX-License-Identifier: MIT
// GLSL 3.30 as OpenGL ES 3.0 takes it.
#include "es_source.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "../support/said.hpp"

namespace texel::gl {
namespace {

constexpr int kFine = kEnoughSubpixelBits, kCoarse = 4;

using test::has;

std::string fragment(const std::string& body, int bits = kFine) {
  return es_source("#version 330 core\n#line 100001\n" + body, true, bits);
}

TEST(EsSource, BeginsWithVersionAndPrecision) {
  const std::string text = fragment("void main() {}\n");
  EXPECT_TRUE(text.starts_with("#version 300 es\nprecision highp float;\nprecision highp int;\n")) << text;
  EXPECT_FALSE(has(text, "330"));
  EXPECT_TRUE(text.ends_with("#line 100001\nvoid main() {}\n")) << text;
}

// The number that a compiler gives the line with `what`.
int line_of(const std::string& text, const std::string& what) {
  int number = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string line = text.substr(at, end - at);
    ++number;
    if (has(line, what)) return number;
    if (line.starts_with("#line ")) number = std::stoi(line.substr(6)) - 1;
    at = end + 1;
  }
  return -1;
}

TEST(EsSource, LinesKeepTheirNumbers) {
  const std::string body =
      "in vec2 st;\nin vec3 n;\nout vec4 picture;\nvoid main() {\n  for (int i = 0;\n       i < 3; ++i) {\n  "
      "}\n  marked;\n}\n";
  for (const int bits : {kFine, kCoarse}) EXPECT_EQ(line_of(fragment(body, bits), "marked"), 100008) << bits;
  const std::string vertex = es_source(
      "#version 330 core\n#line 100001\nout vec2 st;\nvoid main() {\n  marked;\n}\n", false, kCoarse);
  EXPECT_EQ(line_of(vertex, "marked"), 100003);
}

TEST(EsSource, AColorIsDecodedWhereBytesAreKeptOrEncodedForATargetThatDoesNot) {
  const std::string body = "out vec4 picture;\nvoid main() {}\n", decoded = fragment(body);
  EXPECT_TRUE(has(decoded, "if (texel_keeps_bytes) {") && has(decoded, "vec3(2.4)")) << decoded;
  EXPECT_FALSE(has(fragment("out vec4 other;\nvoid main() {}\n"), kKeepsBytes));
  const std::string encoded = es_source("#version 330 core\n" + body, true, kFine, true);
  EXPECT_TRUE(has(encoded, "if (!texel_keeps_bytes) {") && has(encoded, "vec3(1.0 / 2.4)")) << encoded;
}

TEST(EsSource, InputsAreMovedBackOnlyWhereVerticesAreRoundedCoarsely) {
  const std::string body = "in vec2 st;\nout vec4 other;\nvoid main() {}\n";
  EXPECT_TRUE(has(fragment(body, kCoarse), "in vec2 texel_at_st; vec2 st;"));
  EXPECT_TRUE(has(fragment(body, kFine), "in vec2 st;"));
  EXPECT_FALSE(has(fragment(body, kFine), "texel_at_st"));
}

/// A line of a shader after it was guarded.
std::string guarded(const std::string& line) {
  const std::string text = fragment(line + "\n");
  const std::size_t at = text.find("#line 100001\n") + 13;
  return text.substr(at, text.find('\n', at) - at);
}

TEST(EsSource, EachLoopIsCountedAndWhatIsNoneStays) {
  const std::string guard = " if (!texel_goes_on()) break; else";
  const std::pair<std::string, std::string> rows[] = {
      {"while (a < f(b)) b++;", "while (a < f(b))" + guard + " b++;"},
      {"while (a);", "while (a)" + guard + ";"},
      {"do { b++; } while(a);", "do" + guard + " { b++; } while(a);"},
      {"for (int i = 0; i < f(4); ++i) {}", "for (int i = 0; i < f(4); ++i)" + guard + " {}"},
      {"for (;;) {}", "for (;;)" + guard + " {}"},
      {"for (; ; ) while (a) {}", "for (; ; )" + guard + " while (a)" + guard + " {}"},
      {"while /* ( */ (a || b) {}", "while /* ( */ (a || b)" + guard + " {}"}};
  for (const auto& [line, expected] : rows) EXPECT_EQ(guarded(line), expected);
  for (const std::string line : {"// while (a) {}", "/* for (;;) */ a;", "#define M while (a)",
                                 "forward(a; b);", "meanwhile(a);", "while (a"})
    EXPECT_EQ(guarded(line), line);
  EXPECT_FALSE(has(fragment("void main() {}\n"), "texel_rounds"));
}

TEST(EsSource, APixelWhoseLoopsWereEndedIsMarked) {
  const std::string text = fragment("out vec4 picture;\nvoid main() { while (true) {} }\n");
  EXPECT_TRUE(has(text, "++texel_rounds <= " + std::to_string(kMostRounds))) << text;
  EXPECT_TRUE(has(text, "picture = vec4(1.0, 0.0, 1.0, 0.5);")) << text;
}

TEST(EsMessage, SaysWhatToDoAndNamesTheInputsAsTheStudentDoes) {
  EXPECT_TRUE(
      has(es_message("ERROR: 0:100004: '*' : wrong operand types - no operation '*' exists that takes "
                     "'const int' and 'float'"),
          "write 2.0 in place of 2"));
  EXPECT_EQ(es_message("ERROR: 0:3: 'x' : undeclared identifier"), "ERROR: 0:3: 'x' : undeclared identifier");
  EXPECT_EQ(es_message("'texel_at_st' : cannot"), "'st' : cannot");
}

}  // namespace
}  // namespace texel::gl
