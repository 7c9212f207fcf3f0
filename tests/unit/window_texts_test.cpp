// SPDX-License-Identifier: MIT
// The window's parts that need no window: the step's text, a compiler's message, undo and redo, drags.
#include <gtest/gtest.h>

#include "app/gestures.hpp"
#include "core/files.hpp"
#include "core/scratch_folder.hpp"
#include "history.hpp"
#include "shader_message.hpp"
#include "step_text.hpp"

namespace texel::window {
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
  write_file(root.path() / "a.glsl", "vec3 f() {\n  //@step 5.1 begin\n  return x;\r\n  //@end\n}\n");
  write_file(root.path() / "labs/05_x/README.md",
             "### 5.1 One\n![A picture.](a.png)\n\nOf *a*\nthis is known:\n\n$$a = b$$\n\n"
             "| name | value |\n|---|---|\n| `c` | $d_1$ |\n\nNo more.\n- **Where:** here\n"
             "- **Write:** the value,\n  and more.\n- **Checked by:** us\n  and you\n\nThe end.\n"
             "### 5.10 Other\n- **Write:** nothing\n");
  const StepText text = read_step_text(root.path(), "05_x", "5.1", "a.glsl", 2);
  EXPECT_EQ(text.lines,
            (std::vector<std::string>{"vec3 f() {", "  //@step 5.1 begin", "  return x;", "  //@end"}));
  EXPECT_EQ(text.line, 2);
  EXPECT_EQ(text.first_line, 1);
  EXPECT_EQ(text.task,
            "Of a this is known:\n   a = b\nname | value\nc | d₁\nNo more.\n\nWrite: the value, and more.");
}

TEST(StepText, stops_before_the_starters_text_and_bears_missing_files) {
  const ScratchFolder root;
  write_file(root.path() / "a.glsl", "//@step 5.1 begin\nright\n//@starter\n// wrong\n//@end\n");
  const StepText text = read_step_text(root.path(), "05_x", "5.1", "a.glsl", 1);
  EXPECT_EQ(text.lines.size(), 2U);
  EXPECT_EQ(text.task, "");
  EXPECT_TRUE(read_step_text(root.path(), "05_x", "5.1", "missing.glsl", 1).lines.empty());
}

TEST(ErrorMessage, has_the_first_message_its_line_and_how_many_follow) {
  const ScratchFolder root;
  const std::filesystem::path shaders = root.path() / "shaders";
  std::filesystem::create_directory(shaders);
  write_file(shaders / "a.frag", "one\n  two two \nthree\n");
  const ErrorMessage message =
      read_message("shaders/a.frag:2:7: error: no\nshaders/a.frag:3: error: also\nend", root.path());
  EXPECT_EQ(message.first, "shaders/a.frag:2:7: error: no");
  EXPECT_EQ(message.source_line, "two two");
  EXPECT_EQ(message.file, shaders / "a.frag");
  EXPECT_EQ(message.line, 2);
  EXPECT_EQ(message.column, 7);
  EXPECT_EQ(message.others, 2);
  // One of another kind stays as it is.
  const ErrorMessage other = read_message("brick.png: is cut off; restore it", "/nowhere");
  EXPECT_EQ(other.first, "brick.png: is cut off; restore it");
  EXPECT_TRUE(other.file.empty());
  EXPECT_EQ(other.others, 0);
}

TEST(History, goes_back_and_forth_and_forgets_what_was_undone) {
  const auto look = [](const char* value) { return SavedLook{{value}, app::View::color, {}}; };
  History history;
  for (const char* value : {"a", "a", "b", "c"}) history.note(look(value));
  EXPECT_EQ(*history.undo(), look("b"));
  EXPECT_EQ(*history.undo(), look("a"));
  EXPECT_EQ(history.undo(), nullptr);
  EXPECT_EQ(*history.redo(), look("b"));
  history.note(look("d"));
  EXPECT_EQ(history.redo(), nullptr);
  EXPECT_EQ(*history.undo(), look("b"));
}

TEST(Gestures, move_camera_and_light_and_stay_in_range) {
  float yaw = 0, pitch = 0, distance = 0, turned = 0, light = 0;
  params::Set set;
  set.add(yaw, {"yaw", 170, -360, 360, "degrees", "h"});
  set.add(pitch, {"pitch", 80, -89, 89, "degrees", "h"});
  set.add(distance, {"distance", 2, 1, 100, "units", "h"});
  set.add(turned, {"turn", 350, 0, 360, "degrees", "h"});
  set.add(light, {"light_yaw", 0, -180, 180, "degrees", "h"});
  app::orbit(set, {-100, 100});  // to the left: the yaw grows by 35 and goes round; up to the pole
  EXPECT_FLOAT_EQ(yaw, -155);
  EXPECT_FLOAT_EQ(pitch, 89);
  app::zoom(set, -1);
  EXPECT_FLOAT_EQ(distance, 2 / 0.9F);
  app::zoom(set, 20);
  EXPECT_FLOAT_EQ(distance, 1);
  app::turn(set, 20);
  EXPECT_FLOAT_EQ(turned, 10);
  app::turn(set, -20);
  EXPECT_FLOAT_EQ(turned, 350);
  app::move_light(set, {100, 5});  // this lab's light has no pitch
  EXPECT_FLOAT_EQ(light, 35);
}

}  // namespace
}  // namespace texel::window
