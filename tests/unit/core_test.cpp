// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <thread>
#include <vector>

#include "../support/picture_files.hpp"
#include "../support/said.hpp"
#include "core/error.hpp"
#include "core/files.hpp"
#include "core/parallel.hpp"
#include "core/plain_text.hpp"
#include "core/process.hpp"
#include "core/scratch_folder.hpp"
#include "core/stages.hpp"
#include "core/stopwatch.hpp"
#include "core/terminal.hpp"

namespace texel {
namespace {

using test::error_of;
using test::TemporaryFolder;

TEST(Error, says_place_and_remedy) {
  const Error error = Error::failed("no such face", {"cube.obj", 7, 3}, "count from 1");
  EXPECT_STREQ(error.what(), "cube.obj:7:3: no such face; count from 1");
  EXPECT_EQ(error.exit_code(), Exit::failed);
  EXPECT_EQ(error.place().line, 7);
}

TEST(Error, leaves_out_what_is_not_known) {
  EXPECT_STREQ(Error::failed("is empty", {"cube.obj"}).what(), "cube.obj: is empty");
  EXPECT_STREQ(Error::usage("no such lab").what(), "no such lab");
  EXPECT_EQ(Error::usage("no such lab").exit_code(), Exit::usage);
}

TEST(Nearest, finds_a_mistyped_word) {
  EXPECT_EQ(nearest("galery", {"list", "gallery", "compare"}), "gallery");
  EXPECT_EQ(nearest("--bump-strenght", {"--bump-strength", "--bricks"}), "--bump-strength");
}

TEST(Nearest, finds_nothing_when_all_are_far) {
  EXPECT_EQ(nearest("xyzzy", {"list", "gallery", "compare"}), "");
  EXPECT_EQ(nearest("anything", {}), "");
}

TEST(WriteFile, replaces_a_file_and_leaves_nothing_beside_it) {
  const TemporaryFolder folder("core_replace");
  write_file(folder / "a.txt", "old and longer");
  write_file(folder / "a.txt", std::string_view("new\0bytes", 9));
  EXPECT_EQ(read_file(folder / "a.txt"), std::string("new\0bytes", 9));
  const auto entries = std::filesystem::directory_iterator((folder / "a.txt").parent_path());
  EXPECT_EQ(std::distance(begin(entries), end(entries)), 1);
}

TEST(WriteFile, keeps_the_old_file_when_it_fails) {
  const TemporaryFolder folder("core_keep");
  std::filesystem::create_directory(folder / "taken");
  write_file(folder / "taken/inside.txt", "old");
  // A folder that is not empty cannot be replaced by a file, not even by root.
  EXPECT_THROW(write_file(folder / "taken", "new"), Error);
  EXPECT_EQ(read_file(folder / "taken/inside.txt"), "old");
  const auto entries = std::filesystem::directory_iterator((folder / "taken").parent_path());
  EXPECT_EQ(std::distance(begin(entries), end(entries)), 1);
}

TEST(WriteFile, names_the_file_when_its_folder_is_missing) {
  const TemporaryFolder folder("core_missing");
  const std::string message = error_of([&] { write_file(folder / "none/a.txt", "x"); });
  EXPECT_NE(message.find("none/a.txt: cannot write: No such file"), std::string::npos) << message;
  EXPECT_TRUE(folder.empty());
}

TEST(WriteFile, fails_when_the_disk_is_full) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  // The temporary file lies beside, so the device itself is reached through a link of that name.
  const TemporaryFolder folder("core_full");
  const std::string beside = (folder / "a.txt").string() + "." + std::to_string(::getpid()) + ".part";
  std::filesystem::create_symlink("/dev/full", beside);
  const std::string message = error_of([&] { write_file(folder / "a.txt", "x"); });
  EXPECT_NE(message.find("No space left"), std::string::npos) << message;
  EXPECT_TRUE(folder.empty());
}

TEST(ReadFile, tells_a_missing_file_from_a_folder) {
  const TemporaryFolder folder("core_read");
  EXPECT_NE(error_of([&] { read_file(folder / "none"); }).find("cannot open"), std::string::npos);
  EXPECT_NE(error_of([&] { read_file(folder / ""); }).find("not a regular file"), std::string::npos);
}

TEST(ReadFile, does_not_wait_for_a_pipe) {
  const TemporaryFolder folder("core_pipe");
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  EXPECT_NE(error_of([&] { read_file(folder / "pipe"); }).find("not a regular file"), std::string::npos);
}

TEST(MappedFile, shows_the_bytes_of_a_file) {
  const TemporaryFolder folder("core_mapped");
  write_file(folder / "a.txt", "v 0 0 0\n");
  EXPECT_EQ(MappedFile(folder / "a.txt").bytes(), "v 0 0 0\n");
  write_file(folder / "empty.txt", "");
  EXPECT_TRUE(MappedFile(folder / "empty.txt").bytes().empty());
  EXPECT_THROW(MappedFile(folder / "none"), Error);
}

TEST(RunProgram, gives_output_and_exit_code) {
  const Ran ran = run_program({"sh", "-c", "echo out; echo err >&2; exit 3"});
  EXPECT_EQ(ran.exit_code, 3);
  EXPECT_EQ(ran.output, "out\n");
  EXPECT_EQ(run_program({"sh", "-c", "echo out; echo err >&2"}, true).output, "out\nerr\n");
  EXPECT_EQ(run_program({"sh", "-c", "kill -9 $$"}).exit_code, 128 + 9);
  EXPECT_EQ(run_program({"cat"}).output, "") << "it reads nothing";
  // More than a pipe holds.
  EXPECT_EQ(run_program({"head", "-c", "1000000", "/dev/zero"}).output.size(), 1000000U);
}

TEST(RunProgram, takes_words_as_they_are_and_says_what_is_missing) {
  EXPECT_EQ(run_program({"printf", "%s", "a b; $HOME"}).output, "a b; $HOME");
  EXPECT_THROW(run_program({"no_such_program_anywhere"}), Error);
}

TEST(Processors, are_those_of_the_machine_or_as_many_as_TEXEL_THREADS_says) {
  ::unsetenv("TEXEL_THREADS");
  const unsigned all = processors();
  EXPECT_GE(all, 1U);
  const auto with = [](const char* text) {
    ::setenv("TEXEL_THREADS", text, 1);
    return processors();
  };
  EXPECT_EQ(with("3"), 3U);
  EXPECT_EQ(with("1024"), 1024U);
  EXPECT_EQ(with(""), all);
  for (const char* wrong : {"0", "-1", "two", "2 ", "1.5", "1025", "99999999999"})
    EXPECT_EQ(error_of([&] { with(wrong); }, Exit::usage),
              "TEXEL_THREADS is '" + std::string(wrong) +
                  "', not a number of threads; set it to a number from 1 to 1024, or unset it");
  ::unsetenv("TEXEL_THREADS");
}

TEST(InParallel, does_everything_once_whatever_the_number_of_threads) {
  for (const unsigned threads : {1U, 2U, 7U}) {
    std::vector<std::atomic<int>> done(100);
    in_parallel(threads, done.size(), [&](std::size_t i) { ++done[i]; });
    for (const std::atomic<int>& times : done) EXPECT_EQ(times, 1) << threads;
  }
  in_parallel(3, 0, [](std::size_t) { FAIL() << "there is nothing to do"; });
}

TEST(InParallel, throws_what_one_of_them_threw) {
  const auto fail = [](std::size_t i) {
    if (i == 40) throw Error::failed("the fortieth");
  };
  for (const unsigned threads : {1U, 3U})
    EXPECT_EQ(error_of([&] { in_parallel(threads, 100, fail); }), "the fortieth");
}

TEST(InParallel, throws_the_same_of_several_whichever_comes_first) {
  const auto fail = [](std::size_t i) {
    if (i == 0) std::this_thread::sleep_for(std::chrono::milliseconds(20));
    throw Error::failed(i == 0 ? "the first" : "another");
  };
  for (const unsigned threads : {1U, 2U, 4U})
    EXPECT_EQ(error_of([&] { in_parallel(threads, 10, fail); }), "the first") << threads;
}

/// What a stage has taken so far, milliseconds on the wall.
double wall_of(const std::string& name) {
  for (const NamedStage& stage : stage_times())
    if (stage.name == name) return stage.time.wall;
  return -1;
}

TEST(Stages, leave_out_what_is_begun_within_and_what_other_threads_do) {
  const auto wait = [] { std::this_thread::sleep_for(std::chrono::milliseconds(20)); };
  const Stopwatch whole;
  {
    const Stage outer("outer");
    {
      const Stage inner("inner");
      wait();
    }
    std::jthread([&] {
      const Stage beside("beside");
      wait();
    }).join();
  }
  const double inner = wall_of("inner"), outer = wall_of("outer");
  EXPECT_LE(inner + outer, whole.milliseconds()) << "counted twice";
  EXPECT_GE(inner, 20);
  EXPECT_GE(outer, 20);
  EXPECT_EQ(wall_of("beside"), -1);
  { const Stage again("inner"); }
  EXPECT_GE(wall_of("inner"), inner);
  EXPECT_EQ(wall_of("outer"), outer);
  for (const NamedStage& stage : stage_times()) EXPECT_LT(stage.time.processor, 20) << stage.name << " slept";
}

TEST(ScratchFolder, is_new_and_goes_with_all_that_is_in_it) {
  std::filesystem::path path;
  {
    const ScratchFolder folder, other;
    path = folder.path();
    EXPECT_NE(path, other.path());
    EXPECT_TRUE(std::filesystem::is_empty(path));
    write_file(path / "file", "text");
  }
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(PlainText, lines_end_with_any_line_feed_and_the_last_one_needs_none) {
  const std::vector<std::string> lines = {"a", "", "b", "c"};
  EXPECT_EQ(lines_of("a\r\n\nb\nc"), lines);
  EXPECT_EQ(lines_of("a\n\nb\nc\n"), lines);
  EXPECT_TRUE(lines_of("").empty());
}

TEST(Wrapped, breaks_lines_at_blanks_and_keeps_what_a_line_begins_with) {
  EXPECT_EQ(wrapped("one two three\n  four five", 9), "one two\nthree\n  four\nfive\n");
  EXPECT_EQ(wrapped("see a/path/that/is/long.cpp:1: no", 10, 2),
            "  see\n  a/path/that/is/long.cpp:1:\n  no\n");
}

}  // namespace
}  // namespace texel
