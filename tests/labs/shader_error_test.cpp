// SPDX-License-Identifier: MIT
// A student's mistake in a shader: exit code 3, the file and line that they wrote, and no picture.
#include <fmt/format.h>

#include <algorithm>

#include "core/files.hpp"
#include "labs.hpp"

namespace texel::test {
namespace {

class ShaderError : public EveryLab {
 protected:
  ShaderError() {
    std::filesystem::create_directory(folder_ / "root");
    std::filesystem::copy("shaders", folder_ / "root/shaders", std::filesystem::copy_options::recursive);
    std::filesystem::create_directory_symlink(std::filesystem::absolute("assets"), folder_ / "root/assets");
  }

  /// Draws with `line` appended to a shader of the lab. The message names that line.
  void expect_error_in(const std::string& file, const std::string& line, const std::string& message) const {
    SCOPED_TRACE(file + ": " + line);
    const std::filesystem::path path = folder_ / "root/shaders" / file;
    const std::string good = read_file(path);
    ASSERT_TRUE(good.ends_with('\n'));
    write_file(path, good + line + "\n");
    const std::string picture = (folder_ / "a.png").string();
    const Result result = run_lab(lab(), fmt::format("--size 32x32 --snapshot {}", shell_word(picture)),
                                  "TEXEL_ROOT=" + shell_word((folder_ / "root").string()));
    write_file(path, good);
    EXPECT_EQ(result.exit_code, 3);
    EXPECT_EQ(result.output, "");
    const auto number = std::count(good.begin(), good.end(), '\n') + 1;
    EXPECT_TRUE(result.errors.starts_with(fmt::format("{}: shaders/{}:{}:", lab(), file, number)))
        << result.errors;
    EXPECT_TRUE(has(result.errors, message)) << result.errors;
    EXPECT_FALSE(std::filesystem::exists(picture));
  }

  /// The lab's files with that ending.
  [[nodiscard]] std::vector<std::string> files(const std::string& ending) const {
    std::vector<std::string> result;
    const std::filesystem::path shaders = folder_ / "root/shaders";
    for (const auto& entry : std::filesystem::directory_iterator(shaders / lab().substr(3)))
      if (entry.path().extension() == ending)
        result.push_back(std::filesystem::relative(entry.path(), shaders).string());
    std::sort(result.begin(), result.end());
    return result;
  }
};
INSTANTIATE_TEST_SUITE_P(Labs, ShaderError, each_lab, lab_name);

TEST_P(ShaderError, names_the_file_and_line) {
  const std::vector<std::string> fragment = files(".frag"), vertex = files(".vert");
  ASSERT_FALSE(fragment.empty());
  ASSERT_FALSE(vertex.empty());
  expect_error_in(fragment.front(), "void broken( {", "syntax error");
  expect_error_in(vertex.front(), "vec3 broken() { return vec2(1.0); }", "vec3");
}

TEST_P(ShaderError, names_the_included_file) {
  // A step that a student writes, where the lab has one in a file of its own, and what all labs share.
  std::vector<std::string> included = files(".glsl");
  included.resize(std::min<std::size_t>(included.size(), 1));
  included.emplace_back("lib/picture.glsl");
  for (const std::string& file : included)
    expect_error_in(file, "float broken() { return nothing; }", "nothing");
}

}  // namespace
}  // namespace texel::test
