// SPDX-License-Identifier: MIT
// What compilers of GLSL say of a missing semicolon, and where it is missing.
#include "gl/shader_source.hpp"

#include <gtest/gtest.h>

namespace texel::gl {
namespace {

TEST(CompilerLog, names_the_line_after_which_a_semicolon_is_missing) {
  constexpr const char* kSame = "";
  // The code begins at line 500001 of what the compiler read. A log is as Mesa 22.3, NVIDIA's driver or ANGLE
  // has it.
  constexpr std::tuple<const char*, const char*, const char*, const char*> kRows[] = {
      {"the brace", "void f() {\n  x = 1\n}\n",
       "0:500003(1): error: syntax error, unexpected '}', expecting ',' or ';'",
       "0:500002: error: a ';' is missing at the end of this line: x = 1"},
      {"comments, blank and left out lines between",
       "x = g(1)  // one\r\n\n/* two\n x; */\n#endif\n  return x;\n",
       "0:500006(2): error: syntax error, unexpected RETURN, expecting ',' or ';'",
       "0:500001: error: a ';' is missing at the end of this line: x = g(1)"},
      {"break", "  if (x > 1.0) break\n  }\n",
       "0:500002(2): error: syntax error, unexpected '}', expecting ';'",
       "0:500001: error: a ';' is missing at the end of this line: if (x > 1.0) break"},
      {"NVIDIA", "x = 1\n}\n",
       "0(500002) : error C0000: syntax error, unexpected '}', expecting ',' or ';' at token \"}\"",
       "0:500001: error: a ';' is missing at the end of this line: x = 1"},
      {"ANGLE", "x = 1\nreturn x;\n", "ERROR: 0:500002: 'return' : syntax error",
       "0:500001: error: a ';' is missing at the end of this line: x = 1"},
      {"a word in the middle", "x = 1;\nflaot y = 2;\n",
       "0:500002(8): error: syntax error, unexpected NEW_IDENTIFIER, expecting ',' or ';'", kSame},
      {"the same by ANGLE", "x = 1;\nflaot y = 2;\n", "ERROR: 0:500002: 'y' : syntax error", kSame},
      {"a body or a semicolon", "float f()\nreturn 1;\n",
       "0:500002(1): error: syntax error, unexpected RETURN, expecting ';' or '{'", kSame},
      {"a bracket", "x = (1\nreturn x;\n",
       "0:500002(1): error: syntax error, unexpected RETURN, expecting ')' or ','", kSame},
      {"no operand", "x = 1 +\n}\n", "ERROR: 0:500002: '}' : syntax error", kSame},
      {"no statement", "if (x > 1.0)\n}\n", "ERROR: 0:500002: '}' : syntax error", kSame},
      {"the first line", "}\n", "ERROR: 0:500001: '}' : syntax error", kSame},
      {"another error", "x = 1\n}\n", "0:500002(1): error: `y' undeclared", kSame},
      {"no place", "x = 1\n}\n", "syntax error, unexpected '}', expecting ';'", kSame},
  };
  for (const auto& [what, code, log, becomes] : kRows) {
    const std::string text = std::string("#version 330 core\n#define A 1\n#line 500001\n") + code;
    const std::string expected = becomes == kSame ? log : becomes;
    EXPECT_EQ(at_missing_semicolons(std::string(log) + "\nmore\n", text), expected + "\nmore\n") << what;
  }
}

}  // namespace
}  // namespace texel::gl
