// SPDX-License-Identifier: MIT
// Installed to a prefix that is then moved, the labs draw the same pictures.
#include <fmt/format.h>

#include "core/files.hpp"
#include "labs.hpp"

namespace texel::test {
namespace {

TEST(Installed, labs_draw_the_same_after_the_prefix_is_moved) {
  const TemporaryFolder folder(fmt::format("installed_{}", ::getpid()));
  const std::string first = (folder / "first").string(), moved = (folder / "moved place").string();
  const Result install = shell(fmt::format("cmake --install {} --prefix {}", kBuild, shell_word(first)));
  ASSERT_EQ(install.exit_code, 0) << install.errors;
  std::filesystem::rename(first, moved);
  for (const char* lab : {"lab01_texture_quad", "lab03_obj_texcoords", "lab05_normal_map", "lab09_bump"}) {
    const std::string here = (folder / "here.png").string(), there = (folder / "there.png").string();
    const std::string arguments = "--size 160x120 --snapshot ";
    EXPECT_EQ(run_lab(lab, arguments + shell_word(here)).exit_code, 0);
    // Neither a variable nor the working directory leads back to the source tree.
    const Result result = shell(fmt::format(
        "cd / && env -u TEXEL_ROOT {} {}", shell_word(moved + "/bin/" + lab), arguments + shell_word(there)));
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    EXPECT_TRUE(read_file(here) == read_file(there)) << lab;
  }
  // A broken shader in the moved prefix is the one that is read.
  write_file(moved + "/share/texel-labs/shaders/01_texture_quad/texture_quad.frag", "broken\n");
  const Result broken =
      shell(fmt::format("env -u TEXEL_ROOT {} --snapshot {}", shell_word(moved + "/bin/lab01_texture_quad"),
                        shell_word(moved + "/a.png")));
  EXPECT_EQ(broken.exit_code, 3) << broken.errors;
}

}  // namespace
}  // namespace texel::test
