// SPDX-License-Identifier: MIT
// What an edit builds anew, as ninja would: an edit in one lab that lab, an edit in a shader nothing.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <sstream>

#include "../support/places.hpp"
#include "../support/process.hpp"
#include "../support/said.hpp"
#include "core/scratch_folder.hpp"

namespace texel {
namespace {

namespace fs = std::filesystem;
using test::shell;
using test::shell_word;

/// A file that seems to be saved this moment, and at the end of the scope is as old as it was.
class Touched {
 public:
  explicit Touched(fs::path file) : file_(std::move(file)), before_(fs::last_write_time(file_)) {
    fs::last_write_time(file_, fs::file_time_type::clock::now());
  }
  ~Touched() { fs::last_write_time(file_, before_); }
  Touched(const Touched&) = delete;
  Touched& operator=(const Touched&) = delete;

 private:
  fs::path file_;
  fs::file_time_type before_;
};

class Rebuild : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(fs::exists(kBuild / "build.ninja")) << "not built by ninja: configure by a preset";
    // Under another name the file is not made anew before anything else.
    fs::copy_file(kBuild / "build.ninja", work_.path() / "copy.ninja");
    ASSERT_EQ(built(), std::set<std::string>()) << "there is something to build before any edit";
  }

  /// What a build would make now, by the names of its outputs.
  [[nodiscard]] std::set<std::string> built() const {
    const test::Result result = shell(fmt::format("ninja -n -v -C {} -f {} 2>&1", shell_word(kBuild.string()),
                                                  shell_word((work_.path() / "copy.ninja").string())));
    EXPECT_EQ(result.exit_code, 0) << result.output;
    std::set<std::string> outputs;
    std::istringstream words(result.output);
    for (std::string word, before; words >> word; before = word)
      if (before == "-o") outputs.insert(word);
    EXPECT_EQ(outputs.empty(), test::has(result.output, "no work to do")) << result.output;
    return outputs;
  }

  static std::vector<fs::path> files_in(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
      if (entry.is_regular_file()) files.push_back(entry.path());
    return files;
  }

  const fs::path kBuild = test::kBuild, kSource = test::kSource;
  ScratchFolder work_;
};

TEST_F(Rebuild, of_one_lab_when_a_file_of_it_is_saved) {
  int edits = 0;
  for (const fs::directory_entry& lab : fs::directory_iterator(kSource / "labs")) {
    if (!fs::exists(lab.path() / "lab.cpp")) continue;
    const std::string name = lab.path().filename().string();
    const std::set<std::string> own = {fmt::format("labs/CMakeFiles/lab{0}.dir/{0}/lab.cpp.o", name),
                                       fmt::format("bin/lab{}.new", name)};
    for (const fs::path& file : files_in(lab.path())) {
      const std::string ending = file.extension().string();
      if (ending != ".cpp" && ending != ".hpp") continue;
      const Touched edit(file);
      EXPECT_EQ(built(), own) << file;
      ++edits;
    }
  }
  EXPECT_GE(edits, 2 * 9);
}

TEST_F(Rebuild, of_nothing_when_a_shader_is_saved) {
  int edits = 0;
  for (const fs::path& file : files_in(kSource / "shaders")) {
    const Touched edit(file);
    EXPECT_EQ(built(), std::set<std::string>()) << file;
    ++edits;
  }
  EXPECT_GE(edits, 3 * 9);
}

}  // namespace
}  // namespace texel
