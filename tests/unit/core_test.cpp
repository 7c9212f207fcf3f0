// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "../support/picture_files.hpp"
#include "core/error.hpp"
#include "core/files.hpp"
#include "core/process.hpp"

namespace texel {
namespace {

using test::TemporaryFolder;

std::string message_of(const auto& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "nothing was thrown";
}

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
  const std::string message = message_of([&] { write_file(folder / "none/a.txt", "x"); });
  EXPECT_NE(message.find("none/a.txt: cannot write: No such file"), std::string::npos) << message;
  EXPECT_TRUE(folder.empty());
}

TEST(WriteFile, fails_when_the_disk_is_full) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  // The temporary file lies beside, so the device itself is reached through a link of that name.
  const TemporaryFolder folder("core_full");
  const std::string beside = (folder / "a.txt").string() + "." + std::to_string(::getpid()) + ".part";
  std::filesystem::create_symlink("/dev/full", beside);
  const std::string message = message_of([&] { write_file(folder / "a.txt", "x"); });
  EXPECT_NE(message.find("No space left"), std::string::npos) << message;
  EXPECT_TRUE(folder.empty());
}

TEST(ReadFile, tells_a_missing_file_from_a_folder) {
  const TemporaryFolder folder("core_read");
  EXPECT_NE(message_of([&] { read_file(folder / "none"); }).find("cannot open"), std::string::npos);
  EXPECT_NE(message_of([&] { read_file(folder / ""); }).find("not a regular file"), std::string::npos);
}

TEST(ReadFile, does_not_wait_for_a_pipe) {
  const TemporaryFolder folder("core_pipe");
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  EXPECT_NE(message_of([&] { read_file(folder / "pipe"); }).find("not a regular file"), std::string::npos);
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

}  // namespace
}  // namespace texel
