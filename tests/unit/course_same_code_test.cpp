// SPDX-License-Identifier: MIT
#include "course/same_code.hpp"

#include <gtest/gtest.h>

#include <utility>

namespace texel::course {
namespace {

using Pair = std::pair<const char*, const char*>;

TEST(SameCode, differs_in_comments_and_white_space_alone) {
  for (const auto& [a, b] : {Pair{"return color * 2.0 - 1.0;", "return color*2.0-1.0;  // from 0 … 1\n"},
                             {"a = b;\n/* it's\n two */ c = d;", "a=b; c=d;"},
                             {"#define N 3\nint n = N;", "\n#define N 3  // three\n\n  int n=N;\n"},
                             {"#include \"lib/a.glsl\"\nx;", "#include \"lib/a.glsl\"\n\nx;"},
                             {"it = '\\n';", "it = '\\n';"},
                             {"it = '\\'';\n\n", "it = '\\'';  // a quote\r\n"},
                             {"say(\"\\\" // b\");  // c", "say(\"\\\" // b\");"}})
    EXPECT_TRUE(is_same_code(a, b)) << a << "\nand\n" << b;
}

TEST(SameCode, tells_apart_what_a_compiler_does) {
  for (const auto& [a, b] : {Pair{"return color * 2.0 - 1.0;", "return color * 2.0 - 0.9;"},
                             {"int a;", "inta;"},
                             {"int/**/a;", "inta;"},
                             {"a + +b", "a ++b"},
                             {"a / *b", "a /*b"},
                             {"x = 1 .5;", "x = 1.5;"},
                             {"x = 1e -5;", "x = 1e-5;"},
                             {"x = 0x1p -5;", "x = 0x1p-5;"},
                             {"x = \"a\" s;", "x = \"a\"s;"},
                             {"x = u \"a\";", "x = u\"a\";"},
                             {"#define F (x)\n", "#define F(x)\n"},
                             {"#define N 3\n+ 4", "#define N 3 + 4\n"},
                             {"a = b; // c\nd = e;", "a = b; // c d = e;"},
                             {"say(\"a  b\");", "say(\"a b\");"},
                             {"say(\"a // b\");", "say(\"a \");"},
                             {"x = u 'a';", "x = u'a';"},
                             {"it = ' ';", "it = '  ';"},
                             {"a /* b", "a"}})
    EXPECT_FALSE(is_same_code(a, b)) << a << "\nand\n" << b;
}

TEST(SameCode, needs_equal_bytes_where_more_than_a_look_is_needed) {
  for (const auto& [a, b] : {Pair{"// a \\\nb = c;\nd = '\\0';", "d = '\\0';"},
                             {"// a \\\r\nb = c;", "b = c;"},
                             {"it = 'x' ;", "it = 'x';"},
                             {"n = 1'000 ;", "n = 1'000;"},
                             {"say(R\"(a\" // b)\");", "say(R\"(a\" // c)\");"}})
    EXPECT_FALSE(is_same_code(a, b)) << a << "\nand\n" << b;
}

}  // namespace
}  // namespace texel::course
