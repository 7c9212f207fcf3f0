// SPDX-License-Identifier: MIT
#include "course/same_code.hpp"

#include <gtest/gtest.h>

namespace texel::course {
namespace {

TEST(SameCode, differs_in_comments_and_white_space_alone) {
  EXPECT_TRUE(is_same_code("return color * 2.0 - 1.0;", "return color*2.0-1.0;  // from 0 … 1\n"));
  EXPECT_TRUE(is_same_code("a = b;\n/* it's\n two */ c = d;", "a=b; c=d;"));
  EXPECT_TRUE(is_same_code("#define N 3\nint n = N;", "\n#define N 3  // three\n\n  int n=N;\n"));
  EXPECT_TRUE(is_same_code("#include \"lib/a.glsl\"\nx;", "#include \"lib/a.glsl\"\n\nx;"));
  EXPECT_TRUE(is_same_code("it = '\\n';", "it = '\\n';"));
}

TEST(SameCode, tells_apart_what_a_compiler_does) {
  EXPECT_FALSE(is_same_code("return color * 2.0 - 1.0;", "return color * 2.0 - 0.9;"));
  EXPECT_FALSE(is_same_code("int a;", "inta;"));
  EXPECT_FALSE(is_same_code("int/**/a;", "inta;"));
  EXPECT_FALSE(is_same_code("a + +b", "a ++b"));
  EXPECT_FALSE(is_same_code("a / *b", "a /*b"));
  EXPECT_FALSE(is_same_code("x = 1 .5;", "x = 1.5;"));
  EXPECT_FALSE(is_same_code("x = 1e -5;", "x = 1e-5;"));
  EXPECT_FALSE(is_same_code("#define F (x)\n", "#define F(x)\n"));
  EXPECT_FALSE(is_same_code("#define N 3\n+ 4", "#define N 3 + 4\n"));
  EXPECT_FALSE(is_same_code("a = b; // c\nd = e;", "a = b; // c d = e;"));
  EXPECT_FALSE(is_same_code("say(\"a  b\");", "say(\"a b\");"));
  EXPECT_FALSE(is_same_code("say(\"a // b\");", "say(\"a \");"));
  EXPECT_FALSE(is_same_code("a /* b", "a"));
}

TEST(SameCode, needs_equal_bytes_where_more_than_a_look_is_needed) {
  EXPECT_FALSE(is_same_code("// a \\\nb = c;\nd = '\\0';", "d = '\\0';"));
  EXPECT_FALSE(is_same_code("it = 'x' ;", "it = 'x';"));
  EXPECT_FALSE(is_same_code("say(\"\\\"\") ;", "say(\"\\\"\");"));
}

}  // namespace
}  // namespace texel::course
