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
#include "core/json.hpp"
#include "core/parallel.hpp"
#include "core/plain_text.hpp"
#include "core/process.hpp"
#include "core/stages.hpp"
#include "core/stopwatch.hpp"
#include "core/terminal.hpp"

namespace texel {
namespace {

using test::error_of;
using test::has;
using test::TemporaryFolder;

TEST(Error, says_place_and_remedy_where_they_are_known) {
  const Error error = Error::failed("no such face", {"cube.obj", 7, 3}, "count from 1");
  EXPECT_STREQ(error.what(), "cube.obj:7:3: no such face; count from 1");
  EXPECT_EQ(error.exit_code(), Exit::failed);
  EXPECT_EQ(error.place().line, 7);
  EXPECT_STREQ(Error::failed("is empty", {"cube.obj"}).what(), "cube.obj: is empty");
  EXPECT_STREQ(Error::usage("no such lab").what(), "no such lab");
  EXPECT_EQ(Error::usage("no such lab").exit_code(), Exit::usage);
}

TEST(Nearest, finds_a_mistyped_word_and_nothing_when_all_are_far) {
  EXPECT_EQ(did_you_mean("galery", {"list", "gallery", "compare"}), "did you mean 'gallery'?");
  EXPECT_EQ(did_you_mean("--bump-strenght", {"--bump-strength", "--bricks"}),
            "did you mean '--bump-strength'?");
  EXPECT_EQ(did_you_mean("xyzzy", {"list", "gallery", "compare"}, "see --help"), "see --help");
  EXPECT_EQ(did_you_mean("anything", {}), "");
}

/// A folder, and how many files and folders are in it.
class Files : public testing::Test {
 protected:
  [[nodiscard]] std::ptrdiff_t count() const {
    return std::distance(std::filesystem::directory_iterator(folder_ / ""), {});
  }
  TemporaryFolder folder_;
  const std::filesystem::path file_ = folder_ / "a.txt";
};

TEST_F(Files, are_replaced_and_nothing_is_left_beside_them) {
  write_file(file_, "old and longer");
  write_file(file_, std::string_view("new\0bytes", 9));
  EXPECT_EQ(read_file(file_), std::string("new\0bytes", 9));
  EXPECT_EQ(MappedFile(file_).bytes(), std::string_view("new\0bytes", 9));
  EXPECT_EQ(count(), 1);
  write_file(file_, "");
  EXPECT_TRUE(MappedFile(file_).bytes().empty());
}

TEST_F(Files, stay_as_they_were_when_writing_fails) {
  std::filesystem::create_directory(folder_ / "taken");
  write_file(folder_ / "taken/inside.txt", "old");
  // A folder that is not empty cannot be replaced by a file, not even by root.
  EXPECT_THROW(write_file(folder_ / "taken", "new"), Error);
  EXPECT_EQ(read_file(folder_ / "taken/inside.txt"), "old");
  EXPECT_TRUE(has(error_of([&] { write_file(folder_ / "none/a.txt", "x"); }),
                  "none/a.txt: cannot write: No such file"));
  EXPECT_EQ(count(), 1);
}

TEST_F(Files, are_not_left_when_the_disk_is_full) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  // The temporary file lies beside, so the device itself is reached through a link of that name.
  std::filesystem::create_symlink("/dev/full", file_.string() + "." + std::to_string(::getpid()) + ".part");
  EXPECT_TRUE(has(error_of([&] { write_file(file_, "x"); }), "No space left"));
  EXPECT_TRUE(folder_.empty());
}

TEST_F(Files, that_are_none_are_told_apart) {
  EXPECT_TRUE(has(error_of([&] { read_file(folder_ / "none"); }), "cannot open"));
  EXPECT_TRUE(has(error_of([&] { read_file(folder_ / ""); }), "not a regular file"));
  ASSERT_EQ(::mkfifo((folder_ / "pipe").c_str(), 0600), 0);  // it is not waited for
  EXPECT_TRUE(has(error_of([&] { read_file(folder_ / "pipe"); }), "not a regular file"));
  EXPECT_THROW(MappedFile(folder_ / "none"), Error);
}

TEST(RunProgram, gives_output_and_exit_code_and_takes_words_as_they_are) {
  const Ran ran = run_program({"sh", "-c", "echo out; echo err >&2; exit 3"});
  EXPECT_EQ(ran.exit_code, 3);
  EXPECT_EQ(ran.output, "out\n");
  EXPECT_EQ(run_program({"sh", "-c", "echo out; echo err >&2"}, true).output, "out\nerr\n");
  EXPECT_EQ(run_program({"sh", "-c", "kill -9 $$"}).exit_code, 128 + 9);
  EXPECT_EQ(run_program({"cat"}).output, "") << "it reads nothing";
  // More than a pipe holds.
  EXPECT_EQ(run_program({"head", "-c", "1000000", "/dev/zero"}).output.size(), 1000000U);
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

TEST(InParallel, throws_the_same_of_several_whichever_comes_first) {
  const auto fail = [](std::size_t i) {
    if (i == 40) std::this_thread::sleep_for(std::chrono::milliseconds(20));
    if (i >= 40) throw Error::failed(i == 40 ? "the fortieth" : "another");
  };
  for (const unsigned threads : {1U, 2U, 4U})
    for (const std::size_t count : {std::size_t{41}, std::size_t{50}})
      EXPECT_EQ(error_of([&] { in_parallel(threads, count, fail); }), "the fortieth") << threads;
}

/// What a stage has taken so far, milliseconds on the wall.
double wall_of(const std::string& name) {
  for (const auto& [stage, milliseconds] : stage_times())
    if (stage == name) return milliseconds;
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

TEST(PlainText, has_lines_that_end_with_any_line_feed_and_breaks_them_at_blanks) {
  const std::vector<std::string> lines = {"a", "", "b", "c"};
  EXPECT_EQ(lines_of("a\r\n\nb\nc"), lines);
  EXPECT_EQ(lines_of("a\n\nb\nc\n"), lines);
  EXPECT_TRUE(lines_of("").empty());
  EXPECT_EQ(wrapped("one two three\n  four\n\na   b ccc", 8), "one two\nthree\n  four\n\na   b\n    ccc\n");
  EXPECT_EQ(wrapped("see a/path/a.cpp:1: no", 10, 2), "  see\n  a/path/a.cpp:1:\n  no\n");
}

TEST(Json, keeps_the_order_of_keys) {
  const std::string text = R"({"b":1,"a":[2.5,null],"c":{"z":true,"y":"s"}})";
  EXPECT_EQ(to_text(parse_json(text)), text);
  EXPECT_EQ(to_text(parse_json(R"({"b":1})"), 2), "{\n  \"b\": 1\n}");
}

TEST(Json, names_the_line_and_column_of_what_is_wrong) {
  try {
    parse_json("[1,\n 2,\n }");
    FAIL() << "it was read";
  } catch (const Json::exception& error) {
    EXPECT_NE(std::string(error.what()).find("line 3, column 2"), std::string::npos) << error.what();
  }
}

TEST(Json, is_null_where_a_text_is_none) {
  for (const char* text : {"", "{", "[1,]", "Segmentation fault", "{\"a\": 1} more", "\"\xFF\""})
    EXPECT_TRUE(json_or_null(text).is_null()) << text;
  EXPECT_EQ(json_or_null("[1]").size(), 1U);
}

TEST(Json, has_a_sign_for_bytes_that_are_no_text) {
  EXPECT_EQ(to_text(Json("a\xFFz")), "\"a\xEF\xBF\xBDz\"");
}

}  // namespace
}  // namespace texel
