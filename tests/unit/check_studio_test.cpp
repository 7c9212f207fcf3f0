// SPDX-License-Identifier: MIT
// Which picture gets the blame when a program dies. The program is a script that does what a picture's name
// says.
#include "check/studio.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <thread>

#include "../support/picture_files.hpp"
#include "check/check.hpp"
#include "core/files.hpp"

namespace texel::check {
namespace {

namespace fs = std::filesystem;

constexpr const char* kProgram = R"(#!/bin/sh
while [ $# -gt 0 ]; do
  case $1 in --batch) list=$2 ;; --out) out=$2 ;; esac
  shift
done
for name in $(grep -o '"name": *"[^"]*"' "$list" | cut -d '"' -f 4); do
  case $name in
    dies*) kill -s SEGV $$ ;;
    fails*)
      said='"status": "failed", "message": "/somewhere/lab.frag:3: no such function", "place": "lab.frag:3"'
      echo "[{\"name\": \"$name\", $said}]" >"$out/results.json"
      ;;
    names*)
      said='"status": "drawn", "drawn_by": "llvmpipe"'
      echo "[{\"name\": \"$name\", $said}]" >"$out/results.json"
      echo drawn >"$out/$name"
      ;;
    thing_file*) echo x >"$out/thing"; kill -s SEGV $$ ;;
    thing_folder*) mkdir "$out/thing" && echo drawn >"$out/$name" ;;
    links*) ln -s /etc/hostname "$out/$name" ;;
    asks*) printenv TEXEL_THREADS >"$out/$name" ;;
    *) echo drawn >"$out/$name" ;;
  esac
done
)";

class StudioTest : public testing::Test {
 protected:
  StudioTest() {
    fs::create_directories(folder_ / "program");
    fs::create_directories(folder_ / "root");
    studio_.program = folder_ / "program/lab";
    studio_.root = folder_ / "root";
    write_file(studio_.program, kProgram);
    fs::permissions(studio_.program, fs::perms::owner_all);
  }

  using Names = std::vector<std::string>;

  /// Draws these pictures, and checks which are there afterwards, and which files have a fault.
  void draw_all(const Names& names, const Names& expected, const Names& faulty = {}) {
    std::vector<course::Case> cases;
    for (const std::string& name : names) {
      course::Case& one = cases.emplace_back();
      one.name = name, one.file = name + ".png";
    }
    drawn_ = draw(studio_, cases, folder_ / "out");
    Names present, faults;
    for (const std::string& name : names)
      if (fs::exists(picture(name))) present.push_back(name);
    for (const auto& [file, why] : drawn_.faults) faults.push_back(file.substr(0, file.size() - 4));
    EXPECT_EQ(present, expected);
    EXPECT_EQ(faults, faulty);
  }
  [[nodiscard]] fs::path picture(const std::string& name) const { return folder_ / ("out/" + name + ".png"); }

  test::TemporaryFolder folder_;
  Studio studio_;
  Drawn drawn_;
};

TEST_F(StudioTest, blames_the_picture_at_which_the_program_died_and_has_the_others_drawn) {
  draw_all({"a", "b", "dies", "c", "d"}, {"a", "b", "c", "d"}, {"dies"});
  EXPECT_EQ(drawn_.faults["dies.png"], "The program crashed here: it read or wrote invalid memory (SIGSEGV)");
  EXPECT_TRUE(drawn_.refused.empty());
  EXPECT_EQ(drawn_.notes.size(), 1U);
}

TEST_F(StudioTest, starts_a_program_that_dies_four_times_at_the_most) {
  draw_all({"a", "dies1", "dies2", "b", "dies3", "dies4", "c"}, {"a", "b"},
           {"c", "dies1", "dies2", "dies3", "dies4"});
  EXPECT_EQ(drawn_.faults["c.png"], "Not drawn: the program crashed or was stopped before this case");
}

TEST_F(StudioTest, empties_the_output_before_each_start_and_takes_pictures_alone) {
  draw_all({"a", "thing_file", "thing_folder", "links", "b"}, {"a", "thing_folder", "b"},
           {"links", "thing_file"});
  EXPECT_FALSE(fs::is_symlink(picture("links")));
  for (const char* name : {"out/thing", "out/results.json"}) EXPECT_FALSE(fs::exists(folder_ / name)) << name;
}

TEST_F(StudioTest, starts_nothing_when_the_time_is_used_up) {
  TimeBudget budget(0);
  studio_.budget = &budget;
  draw_all({"a", "b"}, {}, {"a", "b"});
  EXPECT_EQ(drawn_.faults.at("b.png"), "Not drawn: the submission used up its time");
}

TEST_F(StudioTest, passes_on_what_the_program_says_of_a_picture_and_of_its_driver) {
  draw_all({"a", "fails", "b"}, {"a", "b"}, {"fails"});
  EXPECT_EQ(drawn_.faults["fails.png"], "/somewhere/lab.frag:3: no such function");
  EXPECT_EQ(drawn_.refused["fails.png"], "lab.frag:3");
  EXPECT_EQ(drawn_.renderer, "");
  draw_all({"a", "names"}, {"a", "names"});
  EXPECT_EQ(drawn_.renderer, "llvmpipe");
}

// Else a program might die at a picture while the one before is not yet written.
TEST_F(StudioTest, allows_the_program_one_thread) {
  draw_all({"asks"}, {"asks"});
  EXPECT_EQ(read_file(picture("asks")), "1\n");
}

/// A tree whose "cmake" is a script.
class BuildTest : public testing::Test {
 protected:
  BuildTest() {
    fs::create_directories(folder_ / "bin");
    fs::create_directories(tree_.build);
    lab_.folder = "05_x";
    ::setenv("PATH", ((folder_ / "bin").string() + ":" + path_).c_str(), 1);
  }
  ~BuildTest() override { ::setenv("PATH", path_.c_str(), 1); }
  void cmake_is(const std::string& script) const {
    write_file(folder_ / "bin/cmake", "#!/bin/sh\ncd " + (folder_ / "").string() + "\n" + script);
    fs::permissions(folder_ / "bin/cmake", fs::perms::owner_all);
  }
  std::string build(const std::string& who, const std::function<void(const std::string&)>& waits) {
    return build_program(tree_, lab_, who, waits);
  }

  test::TemporaryFolder folder_;
  OwnTree tree_{folder_ / "tree", folder_ / "tree/build"};
  std::string path_ = std::getenv("PATH");
  course::Lab lab_;
};

TEST_F(BuildTest, waits_for_another_in_the_same_folder_and_says_for_whom) {
  // Each works until it is told to go. Two at once say so.
  cmake_is(
      "mkdir busy || { touch go; echo 'error: two at once'; exit 1; }\n"
      "while [ ! -e go ]; do sleep 0.01; done\nrmdir busy\n");
  std::string first, awaited;
  std::thread other([&] { first = build("the window", [](const std::string&) {}); });
  for (int i = 0; i < 6000 && !fs::exists(folder_ / "busy"); ++i)  // a minute, as the slowest machine needs
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  const std::string second = build("a watch", [&](const std::string& who) {
    awaited = who;
    write_file(folder_ / "go", "");
  });
  other.join();
  EXPECT_EQ(first, "");
  EXPECT_EQ(second, "");
  EXPECT_EQ(awaited, "the window");
}

TEST_F(BuildTest, gives_what_compiler_linker_and_ninja_say_from_the_first_error_on) {
  const std::string failed = "[1/2] Building\nFAILED: x.o \n/usr/bin/c++ -c x.cpp\n",
                    stopped = "ninja: build stopped: subcommand failed.\n";
  const std::string linker =
      "/usr/bin/ld: x.o: in function `main':\nx.cpp: undefined reference to `f()'\n"
      "collect2: error: ld returned 1 exit status\n";
  const std::string missing = ", needed by 'x.o', missing and no known rule to make it\n";
  for (const auto& [said, expected] : std::vector<std::pair<std::string, std::string>>{
           {failed + "../../labs/x.cpp:1:1: warning: w\n../../labs/x.cpp:2:1: error: e\n" + stopped,
            "labs/x.cpp:2:1: error: e\n"},
           {failed + linker + stopped, linker},
           {"ninja: error: '" + (tree_.source / "labs/x.cpp").string() + "'" + missing,
            "ninja: error: 'labs/x.cpp'" + missing},
           {"ninja: fatal: pipe: Too many open files\n", "ninja: fatal: pipe: Too many open files\n"},
           // The command says nothing of its own.
           {failed + stopped, failed + stopped}}) {
    write_file(folder_ / "says", said);
    cmake_is("cat says\nexit 1\n");
    EXPECT_EQ(build("a watch", [](const std::string&) {}), expected);
  }
}

TEST(Renderers, in_software_are_told_from_gpus_by_their_names) {
  for (const char* name :
       {"llvmpipe (LLVM 15.0.6, 256 bits)", "softpipe, Mesa 22.3.6", "Software Rasterizer",
        "Google SwiftShader",
        "zink Vulkan 1.4(llvmpipe (LLVM 22.1.8, 256 bits) (MESA_LLVMPIPE)), Mesa 26.2.6-1"})
    EXPECT_TRUE(is_software(name)) << name;
  for (const char* name :
       {"NVIDIA H200/PCIe/SSE2, 4.6.0 NVIDIA 570.86", "Mesa Intel(R) UHD Graphics 620 (KBL GT2)",
        "AMD Radeon RX 6600 (radeonsi, navi23, LLVM 19.1.7, DRM 3.61), Mesa 25.0.7",
        "zink Vulkan 1.4(NVIDIA GeForce RTX 4060 (NVIDIA_PROPRIETARY)), Mesa 25.0.7",
        "D3D12 (NVIDIA GeForce RTX 3060), Mesa 25.0.7"})
    EXPECT_FALSE(is_software(name)) << name;
}

TEST(Renderers, are_named_and_a_gpu_gets_advice) {
  EXPECT_EQ(renderer_note("softpipe", "softpipe"), "Drawn by softpipe.");
  EXPECT_EQ(renderer_note("softpipe", ""), "Drawn by softpipe.");
  EXPECT_EQ(renderer_note("softpipe", "llvmpipe"),
            "Your pictures are drawn by softpipe, the expected ones by llvmpipe. The limits allow for both.");
  const std::string gpu = renderer_note("Radeon", "llvmpipe");
  EXPECT_NE(gpu.find("Drawn by Radeon, which seems to be a GPU"), gpu.npos) << gpu;
  EXPECT_NE(gpu.find("LIBGL_ALWAYS_SOFTWARE=1"), gpu.npos) << gpu;
}

}  // namespace
}  // namespace texel::check
