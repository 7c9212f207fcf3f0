// SPDX-License-Identifier: MIT
#include "course/step_text.hpp"

#include <gtest/gtest.h>

#include "core/files.hpp"

namespace texel::course {
namespace {

TEST(StepText, formulas_become_unicode) {
  const std::pair<const char*, const char*> rows[] = {
      {"the normal: $n = 2c − 1$. `DECODE` says **which**", "the normal: n = 2c − 1. DECODE says which"},
      {"$$E_1 = Δs_1\\ T \\qquad E_2 = 0$$", "   E₁ = Δs₁ T \n   E₂ = 0"},
      {"$\\mathrm{atan}(\\sqrt{n_x^2 + 1}, \\lvert a \\rvert)$", "atan(√(n_x² + 1), | a |)"},
      {"the [Slides] and [a page](https://example.org/a) cost $5", "the Slides and a page cost $5"},
      {"a *unit*, an *ear* and 2 * 3; `*p`", "a unit, an ear and 2 * 3; *p"},
      {"$p = V^{-1} P^{-1} c$", "p = V⁻¹ P⁻¹ c"}};
  for (const auto& [markdown, text] : rows) EXPECT_EQ(without_markdown(markdown), text);
}

TEST(StepText, has_the_steps_lines_and_the_handouts_task) {
  const ScratchFolder root;
  std::filesystem::create_directories(root.path() / "labs/05_x");
  write_file(root.path() / "a.glsl",
             "vec3 f() {\n  //@step 5.1 begin\n  return x;\r\n  //@end\n}\n\nint g() {\n"
             "//@step 5.1 begin\ny\n//@starter\n// x\n//@end\n");
  write_file(
      root.path() / "labs/05_x/README.md",
      "### 5.1 One\n![A picture.](a.png)\n\nOf *a*\nthis is known:\n\n$$a = b$$\n\n"
      "| name | value |\n|---|---|\n| `c` | $d_1$ |\n\n- `c`: 1,\n  2.\n\n"
      "**Predict:** What comes\nnext?\n1. `a`\n2. b,\n   or c\n\n<details><summary>Answers</summary>\n\n"
      "1. No.\n   Not so.\n2. Right: $x_1$.\n\n</details>\n\n- **Where:** here\n"
      "- **Write:** the value,\n  and more.\n- **Checked by:** us\n  and you\n\n"
      "<details><summary>After it passes</summary>\n\nWell *done*.\nLook.\n\n</details>\n\nThe end.\n"
      "### 5.10 Other\n- **Write:** nothing\n");
  const StepText text = read_step_text(root.path(), "05_x", "5.1", "a.glsl", 2);
  std::string lines;
  for (const auto& [number, line, is_given] : text.lines)
    lines += std::to_string(number) + (is_given ? "  " : "> ") + line + "|";
  EXPECT_EQ(lines,
            "1  vec3 f() {|2    //@step 5.1 begin|3>   return x;|7  int g() {|8  //@step 5.1 begin|9> y|");
  EXPECT_EQ(text.task,
            "Of a this is known:\n   a = b\nname | value\nc | d₁\n\nc: 1, 2.\n\nWhere: here\n\nWrite: the "
            "value, and more.");
  EXPECT_EQ(text.question, "Predict: What comes next?");
  EXPECT_EQ(text.choices, (std::vector<std::string>{"a", "b, or c"}));
  EXPECT_EQ(text.answers, (std::vector<std::string>{"No. Not so.", "Right: x₁."}));
  EXPECT_EQ(text.after, "Well done. Look.");
}

TEST(StepText, bears_missing_files) {
  const StepText text = read_step_text("missing", "05_x", "5.1", "a.glsl", 1);
  EXPECT_TRUE(text.lines.empty() && text.task.empty());
}

}  // namespace
}  // namespace texel::course
