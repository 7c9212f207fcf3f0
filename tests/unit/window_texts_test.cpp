// SPDX-License-Identifier: MIT
// The window's parts that need no window: a compiler's message, undo and redo, drags.
#include <gtest/gtest.h>

#include "../support/picture_files.hpp"
#include "app/gestures.hpp"
#include "history.hpp"
#include "shader_message.hpp"

namespace texel::window {
namespace {

TEST(ErrorMessage, has_the_first_message_its_line_and_how_many_follow) {
  const ScratchFolder root;
  test::put(root.path(), {{"shaders/a.frag", "one\n  two two \nthree\n"}});
  const ErrorMessage message =
      read_message("shaders/a.frag:2:7: error: no\nshaders/a.frag:3: error: also\nend", root.path());
  EXPECT_EQ(message.first, "shaders/a.frag:2:7: error: no");
  EXPECT_EQ(message.source_line, "two two");
  EXPECT_EQ(message.file, root.path() / "shaders/a.frag");
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
  const auto look = [](const char* value) { return SavedLook{{{"a", value}}, app::View::color, {}, {}}; };
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
