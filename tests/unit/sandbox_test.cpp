// SPDX-License-Identifier: MIT
// Programs that try to do harm, locked in. Where bubblewrap cannot work these tests are skipped, and say why.
#include "sandbox/sandbox.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <iterator>
#include <sstream>
#include <thread>

#include "../support/picture_files.hpp"
#include "../support/process.hpp"
#include "../support/said.hpp"
#include "core/error.hpp"
#include "core/files.hpp"

namespace texel::sandbox {
namespace {

namespace fs = std::filesystem;
using test::has;

const std::string guest = SANDBOX_GUEST;

/// A sandbox that holds the guest and has limits small enough for a test.
Confines small_sandbox() {
  Confines sandbox;
  sandbox.read_only = {fs::path(guest).parent_path()};
  sandbox.limits.wall_seconds = 20;
  sandbox.limits.disk = 1U << 20U;
  return sandbox;
}

Outcome run_guest(const std::string& what, const std::string& where = {},
                  const Confines& sandbox = small_sandbox()) {
  return run_locked_in(sandbox, {guest, what, where});
}

/// An argument that no other test's guest has, which may run at the same time.
std::string own(const std::string& argument) {
  return argument + std::to_string(::getpid());
}

/// Whether a guest with this argument runs on this machine.
bool runs(const std::string& argument) {
  for (const fs::directory_entry& entry : fs::directory_iterator("/proc")) {
    std::ifstream file(entry.path() / "cmdline");
    std::string line;
    std::getline(file, line);  // nothing of a process that ends meanwhile, where an iterator would throw
    if (line.starts_with(guest) && has(line, argument)) return true;
  }
  return false;
}

/// Waits for what happens soon; whether it did.
template <class Condition>
bool soon(Condition condition) {
  for (int i = 0; i < 1000; ++i) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

class SandboxTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!sandbox_fault().empty()) GTEST_SKIP() << "bubblewrap cannot work here: " << sandbox_fault();
  }
};

TEST_F(SandboxTest, gives_exit_code_output_and_usage) {
  const Outcome outcome = run_guest("exit", "7");
  EXPECT_EQ(outcome.exit_code, 7);
  EXPECT_EQ(outcome.signal, 0);
  EXPECT_EQ(outcome.limit, Limit::none);
  EXPECT_FALSE(outcome.succeeded());
  EXPECT_GT(outcome.peak_memory, 100'000U);
  EXPECT_GT(outcome.wall_seconds, 0);
  const Outcome printed = run_guest("print", "hello");
  EXPECT_TRUE(printed.succeeded());
  EXPECT_EQ(printed.output, "hello\n");
  EXPECT_EQ(printed.output_bytes, 6U);
}

TEST_F(SandboxTest, names_the_signal_that_ended_a_program) {
  const Outcome outcome = run_guest("abort");
  EXPECT_EQ(outcome.exit_code, 128 + SIGABRT);
  EXPECT_EQ(outcome.signal, SIGABRT);
}

TEST_F(SandboxTest, gives_127_for_a_missing_program) {
  EXPECT_EQ(run_locked_in(small_sandbox(), {"/no/such/program"}).exit_code, 127);
}

TEST_F(SandboxTest, hands_arguments_over_as_they_are) {
  const std::string hostile = "$(touch x) `id` ; 'a' \"b\" --help \n *";
  EXPECT_EQ(run_guest("print", hostile).output, hostile + "\n");
}

TEST_F(SandboxTest, takes_a_static_constructor_that_leaves_for_an_exit_code_only) {
  Confines sandbox = small_sandbox();
  const test::TemporaryFolder folder("sandbox_leaves");
  sandbox.writable = {(folder / "x").parent_path()};
  sandbox.environment = {{"GUEST_LEAVES", "1"}};
  const Outcome outcome = run_guest("results", sandbox.writable[0].string(), sandbox);
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_TRUE(fs::is_empty(sandbox.writable[0]));
}

TEST_F(SandboxTest, has_no_network) {
  const Outcome outcome = run_guest("network");
  EXPECT_FALSE(has(outcome.output, "possible")) << outcome.output;
  EXPECT_EQ(std::count(outcome.output.begin(), outcome.output.end(), '\n'), 7);
}

/// What lies in the kernel's buffers is counted by no limit. Sockets, which have large ones, are refused
/// above.
TEST_F(SandboxTest, holds_little_in_pipes) {
  const Outcome outcome = run_guest("pipes");
  ASSERT_TRUE(outcome.succeeded()) << outcome.errors;
  // The kernel gives an account without rights 64 MiB, and a page for each pipe beyond.
  EXPECT_LT(std::stoll(outcome.output), 80LL << 20U);
}

TEST_F(SandboxTest, shows_no_file_that_is_not_named) {
  const test::TemporaryFolder folder("sandbox_secret");
  write_file(folder / "reference.pfm", "secret");
  ASSERT_EQ(::chmod((folder / "reference.pfm").c_str(), 0644), 0);
  EXPECT_FALSE(has(run_guest("read", folder / "reference.pfm").output, "possible"));
  EXPECT_FALSE(has(run_guest("read", "/etc/passwd").output, "possible"));
  EXPECT_FALSE(has(run_guest("read", "/proc/1/root/etc/passwd").output, "possible"));
  Confines named = small_sandbox();
  named.read_only.push_back((folder / "x").parent_path());
  EXPECT_TRUE(has(run_guest("read", folder / "reference.pfm", named).output, "possible"));
}

TEST_F(SandboxTest, writes_nowhere_but_into_the_writable_folders_and_tmp) {
  const test::TemporaryFolder folder("sandbox_read_only");
  const fs::path shown = (folder / "x").parent_path();
  Confines sandbox = small_sandbox();
  sandbox.read_only.push_back(shown);
  for (const std::string& place :
       {shown.string(), fs::path(guest).parent_path().string(), std::string("/usr"), std::string("/dev"),
        std::string("/dev/shm"), std::string("/proc"), std::string("")})
    EXPECT_FALSE(has(run_guest("write", place + "/file", sandbox).output, "possible")) << place;
  EXPECT_TRUE(has(run_guest("write", "/tmp/file", sandbox).output, "possible"));
  EXPECT_TRUE(fs::is_empty(shown));
}

TEST_F(SandboxTest, shows_no_process_of_the_host) {
  const Outcome outcome = run_guest("list", "/proc");
  std::istringstream names(outcome.output);
  int processes = 0;
  for (std::string name; std::getline(names, name);) processes += name[0] >= '1' && name[0] <= '9' ? 1 : 0;
  EXPECT_EQ(processes, 2);  // the first process and the guest
}

TEST_F(SandboxTest, gives_away_neither_environment_nor_open_files_nor_input) {
  const test::TemporaryFolder folder("sandbox_handles");
  write_file(folder / "results", "");
  const int open_file = ::open((folder / "results").c_str(), O_RDWR);  // not to be closed on exec
  ::setenv("SECRET", "seed", 1);
  Confines sandbox = small_sandbox();
  sandbox.environment = {{"GIVEN", "this"}, {"HOME", "/nowhere"}};
  const std::string environment = run_guest("environment", "", sandbox).output;
  EXPECT_FALSE(has(environment, "SECRET"));
  EXPECT_TRUE(has(environment, "GIVEN=this\n"));
  EXPECT_TRUE(has(environment, "HOME=/nowhere\n"));
  // The three streams, and the folder that is being listed.
  EXPECT_EQ(run_guest("list", "/proc/self/fd").output, "0\n1\n2\n3\n");
  EXPECT_EQ(run_guest("input").output, "-1\n");
  ::close(open_file);
}

/// A second program's output goes where the first one's is, and the program chooses the names.
TEST_F(SandboxTest, leaves_behind_what_cannot_have_its_name) {
  const test::TemporaryFolder folder("sandbox_names");
  Confines sandbox = small_sandbox();
  sandbox.writable = {(folder / "x").parent_path()};
  const std::string out = sandbox.writable[0].string();
  fs::create_directories(folder / "picture.png/below");
  write_file(folder / "sub", "a file");
  Outcome outcome;
  ASSERT_NO_THROW(outcome = run_guest("results", out, sandbox));
  EXPECT_TRUE(outcome.succeeded());
  EXPECT_TRUE(fs::is_directory(folder / "picture.png"));
  // Sixteen folders with the longest name are too long a path.
  ASSERT_NO_THROW(outcome = run_guest("deep", out, sandbox));
  EXPECT_TRUE(outcome.succeeded());
}

TEST_F(SandboxTest, refuses_the_system_calls_that_break_out) {
  const Outcome outcome = run_guest("forbidden");
  EXPECT_FALSE(has(outcome.output, "possible")) << outcome.output;
  EXPECT_EQ(std::count(outcome.output.begin(), outcome.output.end(), '\n'), 11);
}

TEST_F(SandboxTest, lets_no_signal_out) {
  const Outcome outcome = run_guest("signals", std::to_string(::getpid()));
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_FALSE(has(outcome.output, "possible")) << outcome.output;
}

TEST_F(SandboxTest, counts_the_processes_of_each_sandbox_alone) {
  Confines sandbox = small_sandbox();
  sandbox.limits.processes = 20;
  std::vector<Outcome> outcomes(4);
  std::vector<std::thread> threads;
  for (Outcome& outcome : outcomes)
    threads.emplace_back([&outcome, &sandbox] { outcome = run_guest("forks", "", sandbox); });
  for (std::thread& thread : threads) thread.join();
  // Of the twenty the guest is one; the first process is another, but when root starts it, it is root's.
  const std::string expected = ::geteuid() == 0 ? "19\n" : "18\n";
  for (const Outcome& outcome : outcomes) EXPECT_EQ(outcome.output, expected);
}

TEST_F(SandboxTest, ends_a_fork_bomb) {
  Confines sandbox = small_sandbox();
  sandbox.limits.wall_seconds = 0.3;
  EXPECT_EQ(run_guest("bomb", own("bomb"), sandbox).limit, Limit::wall);
  EXPECT_FALSE(runs(own("bomb")));
}

TEST_F(SandboxTest, ends_a_program_that_takes_too_much_memory) {
  Confines sandbox = small_sandbox();
  sandbox.limits.memory = 256U << 20U;
  const Outcome outcome = run_guest("memory", "", sandbox);
  EXPECT_EQ(outcome.limit, Limit::memory);
  EXPECT_EQ(outcome.signal, SIGKILL);
  EXPECT_GT(outcome.peak_memory, sandbox.limits.memory);
}

/// Needs a control group that the kernel lets us divide: tests/machines/control_groups makes such a machine.
TEST_F(SandboxTest, ends_a_program_whose_memory_only_the_kernel_counts) {
  if (!memory_group_fault().empty()) GTEST_SKIP() << memory_group_fault();
  Confines sandbox = small_sandbox();
  sandbox.limits.memory = 64U << 20U;
  const Outcome outcome = run_guest("tables", own("tables"), sandbox);
  EXPECT_EQ(outcome.limit, Limit::memory);
  EXPECT_EQ(outcome.signal, SIGKILL);
  EXPECT_FALSE(runs(own("tables")));
}

TEST_F(SandboxTest, has_a_limit_on_the_address_space) {
  Confines sandbox = small_sandbox();
  sandbox.limits.address_space = 128U << 20U;
  EXPECT_EQ(run_guest("memory", "", sandbox).signal, SIGABRT);  // std::bad_alloc
  EXPECT_EQ(run_guest("huge").signal, SIGABRT);
}

TEST_F(SandboxTest, ends_a_program_that_fills_the_disk) {
  const test::TemporaryFolder folder("sandbox_disk");
  Confines sandbox = small_sandbox();
  sandbox.writable = {(folder / "x").parent_path()};
  EXPECT_EQ(run_guest("fill", sandbox.writable[0].string(), sandbox).limit, Limit::disk);
  EXPECT_EQ(run_guest("fill", "/tmp", sandbox).limit, Limit::disk);
}

TEST_F(SandboxTest, ends_a_program_that_makes_too_many_files) {
  Confines sandbox = small_sandbox();
  sandbox.limits.files = 10;
  EXPECT_EQ(run_guest("holes", "/tmp", sandbox).limit, Limit::disk);
}

TEST_F(SandboxTest, does_not_copy_holes_without_end) {
  const test::TemporaryFolder folder("sandbox_holes");
  Confines sandbox = small_sandbox();
  sandbox.writable = {(folder / "x").parent_path()};
  const Outcome outcome = run_guest("holes", sandbox.writable[0].string(), sandbox);  // 20 of 1 MiB
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.limit, Limit::disk);
  EXPECT_EQ(std::distance(fs::directory_iterator(sandbox.writable[0]), {}), 1);
}

TEST_F(SandboxTest, cuts_a_flood_of_output) {
  Confines sandbox = small_sandbox();
  sandbox.limits.output = 4U << 20U;
  sandbox.limits.kept_output = 1000;
  const Outcome outcome = run_guest("flood", "", sandbox);
  EXPECT_EQ(outcome.limit, Limit::output);
  EXPECT_EQ(outcome.output.size(), 1000U);
  EXPECT_GT(outcome.output_bytes, sandbox.limits.output);
}

TEST_F(SandboxTest, ends_an_endless_loop_and_a_sleeper) {
  Confines sandbox = small_sandbox();
  sandbox.limits.wall_seconds = 0.3;
  for (const char* what : {"spin", "sleep"}) {
    const Outcome outcome = run_guest(what, "", sandbox);
    EXPECT_EQ(outcome.limit, Limit::wall);
    EXPECT_EQ(outcome.signal, SIGKILL);
    EXPECT_GE(outcome.wall_seconds, 0.3);
  }
}

TEST_F(SandboxTest, ends_who_takes_too_much_processor_time) {
  Confines sandbox = small_sandbox();
  sandbox.limits.cpu_seconds = 0.2;
  const Outcome outcome = run_guest("ignore", "", sandbox);
  EXPECT_EQ(outcome.limit, Limit::cpu);
  EXPECT_GE(outcome.cpu_seconds, 0.2);
}

TEST_F(SandboxTest, takes_a_daemon_down_with_its_program) {
  EXPECT_EQ(run_guest("daemon", own("daemon")).exit_code, 0);
  EXPECT_FALSE(runs(own("daemon")));
}

TEST_F(SandboxTest, dies_with_its_caller) {
  const std::string sleeper = own("sleeper");
  const pid_t caller = ::fork();
  if (caller == 0) {
    run_guest("sleep", sleeper);
    ::_exit(0);
  }
  EXPECT_TRUE(soon([&] { return runs(sleeper); }));
  ::kill(caller, SIGKILL);
  ::waitpid(caller, nullptr, 0);
  EXPECT_TRUE(soon([&] { return !runs(sleeper); }));
}

TEST_F(SandboxTest, copies_files_out_and_follows_no_link) {
  const test::TemporaryFolder folder("sandbox_results");
  const fs::path out = (folder / "x").parent_path();
  write_file(out / "target", "untouched");
  fs::create_symlink("target", out / "picture.png");  // as an earlier run could have left it
  Confines sandbox = small_sandbox();
  sandbox.writable = {out};
  EXPECT_TRUE(run_guest("results", out.string(), sandbox).succeeded());
  EXPECT_EQ(read_file(out / "picture.png"), "a picture");
  EXPECT_EQ(read_file(out / "sub" / "more.ply"), "a mesh");
  EXPECT_EQ(read_file(out / "target"), "untouched");
  for (const char* name : {"link.png", "folder", "pipe.png"})
    EXPECT_FALSE(fs::exists(fs::symlink_status(out / name))) << name;
}

TEST_F(SandboxTest, throws_when_the_machine_is_at_fault) {
  Confines sandbox = small_sandbox();
  sandbox.read_only.emplace_back("/no/such/folder");
  EXPECT_THROW(run_locked_in(sandbox, {"true"}), Error);
  sandbox = small_sandbox();
  sandbox.working_folder = "/no/such/folder";
  EXPECT_THROW(run_locked_in(sandbox, {"true"}), Error);
  sandbox = small_sandbox();
  sandbox.writable.emplace_back("relative");
  EXPECT_THROW(run_locked_in(sandbox, {"true"}), Error);
  const test::TemporaryFolder closed("sandbox_closed");
  sandbox = small_sandbox();
  sandbox.read_only.push_back((closed / "x").parent_path());
  ASSERT_EQ(::chmod(sandbox.read_only.back().c_str(), 0700), 0);
  if (::geteuid() == 0) {
    EXPECT_THROW(run_locked_in(sandbox, {"true"}), Error);
  }
  EXPECT_THROW(run_locked_in(small_sandbox(), {}), Error);
}

TEST_F(SandboxTest, works_for_a_normal_user_too) {
  if (::geteuid() != 0) GTEST_SKIP() << "this is a normal user already";
  const test::TemporaryFolder folder("sandbox_user");
  const fs::path temporary = (folder / "x").parent_path();
  ASSERT_EQ(::chown(temporary.c_str(), 12345, 12345), 0);
  const std::string as_user =
      "setpriv --reuid 12345 --regid 12345 --clear-groups env TMPDIR=" + temporary.string() + " ";
  const std::string self = fs::read_symlink("/proc/self/exe").string();
  if (test::shell(as_user + "test -x " + test::shell_word(self)).exit_code != 0)
    GTEST_SKIP() << "other users cannot run " << self;
  const test::Result result =
      test::shell(as_user + test::shell_word(self) +
                  " --gtest_filter='-*normal_user*:*RunPlainly*:*memory*:*missing*' 2>&1");
  EXPECT_EQ(result.exit_code, 0) << result.output;
  EXPECT_TRUE(has(result.output, "PASSED")) << result.output;
}

TEST(RunPlainly, limits_time_and_output_and_kills_the_process_group) {
  Confines confines = small_sandbox();
  const auto run_guest_plainly = [&](const char* what, const std::string& where) {
    return run_plainly(confines, {guest, what, where});
  };
  EXPECT_EQ(run_guest_plainly("print", "hello").output, "hello\n");
  EXPECT_EQ(run_guest_plainly("exit", "7").exit_code, 7);
  confines.limits.wall_seconds = 0.2;
  EXPECT_EQ(run_guest_plainly("sleep", own("plain")).limit, Limit::wall);
  EXPECT_TRUE(soon([] { return !runs(own("plain")); }));
  confines.limits.wall_seconds = 20;
  EXPECT_EQ(run_guest_plainly("flood", "").limit, Limit::output);
  confines.limits.cpu_seconds = 1;
  EXPECT_EQ(run_guest_plainly("spin", "").limit, Limit::cpu);
}

TEST(RunPlainly, is_not_what_one_gets_without_bubblewrap) {
  const char* const path = std::getenv("PATH");
  const std::string before = path == nullptr ? "" : path;
  ::setenv("PATH", "/nowhere", 1);
  try {
    run_locked_in({}, {"true"});
    ADD_FAILURE() << "it ran";
  } catch (const Error& error) {
    EXPECT_EQ(error.exit_code(), Exit::failed);
    EXPECT_TRUE(has(error.what(), "bubblewrap")) << error.what();
    EXPECT_TRUE(has(error.what(), "--unsafe")) << error.what();
  }
  ::setenv("PATH", before.c_str(), 1);
}

}  // namespace
}  // namespace texel::sandbox
