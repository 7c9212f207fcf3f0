// SPDX-License-Identifier: MIT
// The files between the tools and a lab's program.
#include "course/batch.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "../support/said.hpp"

namespace texel::course {
namespace {

TEST(Drawings, are_the_same_when_they_were_written_and_read) {
  std::vector<Drawing> drawings = {
      {"a.png", true, "", "", "llvmpipe", 12.5},
      {"b.ply", false, "cube.obj:9: \"no\" number\nand more", "cube.obj:9", "", 0},
      {"c.png", false, "#error caf\xe9 \xff", "x.frag:3", "", 0}};
  const std::vector<Drawing> read = parse_drawings(to_json(drawings));
  drawings[2].message = "#error caf\uFFFD \uFFFD";  // a message may quote any bytes
  EXPECT_EQ(read, drawings);
}

TEST(Drawings, of_a_program_that_nobody_trusts_are_only_what_fits) {
  for (const char* text : {"", "{", "3", "{\"name\": \"a.png\"}", "[3, null, [], {}, {\"name\": 7}]",
                           R"([{"name": "a.png", "status": 1}])", R"([{"name": "a.png", "message": ["x"]}])",
                           R"([{"name": "a.png", "milliseconds": "y"}])"})
    EXPECT_TRUE(parse_drawings(text).empty()) << text;
  EXPECT_TRUE(parse_drawings(R"([3, {"name": "b.png", "status": "drawn"}])").at(0).is_drawn);
  const std::vector<Drawing> lengthy = {{"a.png", false, std::string(5000, 'x'), "", "", 0}};
  EXPECT_EQ(parse_drawings(to_json(lengthy)).at(0).message.size(), 2000U);
}

TEST(Batch, is_the_same_when_it_was_written_and_read) {
  Case picture, mesh;
  picture.name = "bumps", picture.file = "bumps.pfm", picture.view = View::normal, picture.size = {64, 48};
  picture.settings = {{"turn", "30"}, {"normal_map", "brick"}};
  mesh.name = "torus", mesh.file = "torus.ply", mesh.view = View::mesh;
  EXPECT_EQ(parse_batch(to_batch({picture, mesh})), (std::vector<Case>{picture, mesh}));
}

TEST(Batch, writes_in_its_folder_alone) {
  for (const char* name : {"", "..", ".hidden", "../a", "below/a", "/tmp/a"})
    EXPECT_NE(test::error_of([&] { parse_batch(fmt::format(R"([{{"name": "{}"}}])", name)); }, Exit::usage),
              "")
        << name;
  EXPECT_EQ(parse_batch(R"([{"name": "a"}])").at(0).file, "a.png");
}

}  // namespace
}  // namespace texel::course
