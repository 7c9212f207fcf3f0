// SPDX-License-Identifier: MIT
// Programs that try to do harm, locked in, and where there are no namespaces: as another user. Where a way
// cannot work its tests are skipped, and say why.
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
#include <functional>
#include <iterator>
#include <span>
#include <sstream>
#include <thread>

#include "../support/picture_files.hpp"
#include "../support/said.hpp"
#include "core/error.hpp"
#include "core/files.hpp"

namespace texel::sandbox {
namespace {

namespace fs = std::filesystem;
using test::has;

/// Waits for what happens soon; whether it did.
template <class Condition>
bool soon(Condition condition) {
  for (int i = 0; i < 1000; ++i) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

using Way = Run;  // testing::Test has a Run of its own

/// A guest, run in a way, with limits small enough for a test.
class Guest : public testing::Test {
 protected:
  explicit Guest(Way way) : way_(way) {
    confines_.read_only = {guest_.parent_path()};
    confines_.writable = {out_};
    confines_.limits.wall_seconds = 20;
    confines_.limits.disk = 1U << 20U;
  }
  void SetUp() override {
    if (way_ == run_as_another_user && ::geteuid() != 0) GTEST_SKIP() << "needs root";
    const std::string fault = way_ == run_locked_in         ? sandbox_fault()
                              : way_ == run_as_another_user ? another_user_fault()
                                                            : "";
    if (!fault.empty()) GTEST_SKIP() << "cannot work here: " << fault;
    for (const fs::path& folder : {guest_.parent_path(), out_}) ASSERT_EQ(::chmod(folder.c_str(), 0755), 0);
    fs::copy_file(SANDBOX_GUEST, guest_);  // the tree may lie where only root can read
  }

  Outcome run(const std::string& what, const std::string& where = {}) const {
    return way_(confines_, {guest_.string(), what, where});
  }
  /// Whether it says that something was possible.
  [[nodiscard]] bool can(const std::string& what, const std::string& where = {}) const {
    return has(run(what, where).output, "possible");
  }
  /// Whether a guest runs on this machine.
  [[nodiscard]] bool runs() const {
    for (const fs::directory_entry& entry : fs::directory_iterator("/proc")) {
      std::ifstream file(entry.path() / "cmdline");
      std::string line;
      std::getline(file, line);  // nothing of a process that ends meanwhile, where an iterator would throw
      if (line.starts_with(guest_.string())) return true;
    }
    return false;
  }

  Way way_;
  test::TemporaryFolder folder_, programs_;
  const fs::path guest_ = programs_ / "guest", out_ = folder_.path();
  Confines confines_;
};

class EveryWay : public Guest, public testing::WithParamInterface<std::string> {
 protected:
  EveryWay() : Guest(GetParam() == "locked_in" ? run_locked_in : run_as_another_user) {}
};
INSTANTIATE_TEST_SUITE_P(Sandbox, EveryWay, testing::Values("locked_in", "as_another_user"),
                         [](const testing::TestParamInfo<std::string>& way) { return way.param; });

class SandboxTest : public Guest {
 protected:
  SandboxTest() : Guest(run_locked_in) {}
};

class RunPlainly : public Guest {
 protected:
  RunPlainly() : Guest(run_plainly) {}
};

TEST_P(EveryWay, gives_exit_code_output_and_usage) {
  const Outcome outcome = run("exit", "125");
  EXPECT_EQ(outcome.exit_code, 125);
  EXPECT_EQ(outcome.signal, 0);
  EXPECT_EQ(outcome.limit, Limit::none);
  EXPECT_FALSE(outcome.succeeded());
  EXPECT_GT(outcome.peak_memory, 100'000U);
  EXPECT_GT(outcome.wall_seconds, 0);
  const std::string hostile = "$(touch x) `id` ; 'a' \"b\" --help \n *";
  const Outcome printed = run("print", hostile);
  EXPECT_TRUE(printed.succeeded());
  EXPECT_EQ(printed.output, hostile + "\n");
  EXPECT_EQ(printed.output_bytes, hostile.size() + 1);
  const Outcome aborted = run("abort");
  EXPECT_EQ(aborted.exit_code, 128 + SIGABRT);
  EXPECT_EQ(aborted.signal, SIGABRT);
}

TEST_P(EveryWay, has_no_network_and_no_system_call_that_breaks_out) {
  for (const auto& [what, calls] : {std::pair{"network", 7}, {"forbidden", 11}}) {
    const Outcome outcome = run(what);
    EXPECT_FALSE(has(outcome.output, "possible")) << outcome.output;
    EXPECT_EQ(std::count(outcome.output.begin(), outcome.output.end(), '\n'), calls) << outcome.errors;
  }
}

TEST_P(EveryWay, reaches_no_closed_file_and_no_process_of_others) {
  const test::TemporaryFolder closed;
  write_file(closed / "seed.txt", "secret");
  ASSERT_EQ(::chmod(closed.path().c_str(), 0700), 0);
  EXPECT_FALSE(can("read", closed / "seed.txt"));
  EXPECT_FALSE(can("read", "/proc/" + std::to_string(::getpid()) + "/environ"));
  EXPECT_FALSE(can("write", "/usr/file"));
  const Outcome signals = run("signals", std::to_string(::getpid()));
  EXPECT_EQ(signals.exit_code, 0);
  EXPECT_FALSE(has(signals.output, "possible")) << signals.output;
}

TEST_P(EveryWay, finds_an_empty_folder_and_leaves_files_but_no_links) {
  write_file(out_ / "earlier", "of ours");
  fs::create_symlink("earlier", out_ / "picture.png");  // as an earlier run could have left it
  EXPECT_EQ(run("list", out_).output, "");
  EXPECT_TRUE(run("results", out_).succeeded());
  EXPECT_EQ(read_file(out_ / "picture.png"), "a picture");
  EXPECT_EQ(read_file(out_ / "sub/more.ply"), "a mesh");
  EXPECT_EQ(read_file(out_ / "earlier"), "of ours");
  for (const char* name : {"link.png", "folder", "pipe.png"})
    EXPECT_FALSE(fs::exists(fs::symlink_status(out_ / name))) << name;
}

TEST_P(EveryWay, is_held_to_every_limit_with_all_its_processes) {
  const auto wall = [](ProcessLimits& limits) { limits.wall_seconds = 0.3; };
  // The signal is 0 where it tells nothing.
  const std::tuple<const char*, std::function<void(ProcessLimits&)>, Limit, int> rows[] = {
      {"fill", [](ProcessLimits&) {}, Limit::disk, 0},
      {"flood", [](ProcessLimits& limits) { limits.output = 4U << 20U; }, Limit::output, 0},
      {"ignore", [](ProcessLimits& limits) { limits.cpu_seconds = 0.2; }, Limit::cpu, 0},
      {"team", [](ProcessLimits& limits) { limits.cpu_seconds = 0.5; }, Limit::cpu, 0},
      {"spin", wall, Limit::wall, SIGKILL},
      {"sleep", wall, Limit::wall, SIGKILL},
      {"bomb", wall, Limit::wall, 0},
      {"daemon", [](ProcessLimits&) {}, Limit::none, 0},
      {"huge", [](ProcessLimits&) {}, Limit::none, SIGABRT}};  // std::bad_alloc
  const ProcessLimits before = confines_.limits;
  for (const auto& [what, set, limit, signal] : rows) {
    SCOPED_TRACE(what);
    set(confines_.limits);
    const Outcome outcome = run(what, out_);
    EXPECT_EQ(outcome.limit, limit);
    if (signal != 0) {
      EXPECT_EQ(outcome.signal, signal);
    }
    if (limit == Limit::wall) {
      EXPECT_GE(outcome.wall_seconds, 0.3);
    }
    EXPECT_FALSE(runs());
    confines_.limits = before;
  }
}

TEST_P(EveryWay, ends_a_program_that_takes_too_much_memory) {
  confines_.limits.memory = 256U << 20U;
  const Outcome outcome = run("memory");
  EXPECT_EQ(outcome.limit, Limit::memory);
  EXPECT_EQ(outcome.signal, SIGKILL);
  EXPECT_GT(outcome.peak_memory, confines_.limits.memory);
}

TEST_P(EveryWay, counts_the_processes_of_each_sandbox_alone) {
  confines_.limits.processes = 20;
  std::vector<Outcome> outcomes(way_ == run_locked_in ? 4 : 1);  // the others share a folder
  std::vector<std::thread> threads;
  for (Outcome& outcome : outcomes) threads.emplace_back([&] { outcome = run("forks"); });
  for (std::thread& thread : threads) thread.join();
  // Of the twenty the guest is one; the first process is another, but when root starts it, it is root's.
  const std::string expected = ::geteuid() == 0 ? "19\n" : "18\n";
  for (const Outcome& outcome : outcomes) EXPECT_EQ(outcome.output, expected);
}

TEST_F(SandboxTest, gives_127_for_a_missing_program) {
  EXPECT_EQ(run_locked_in(confines_, {"/no/such/program"}).exit_code, 127);
}

TEST_F(SandboxTest, takes_a_static_constructor_that_leaves_for_an_exit_code_only) {
  confines_.environment = {{"GUEST_LEAVES", "1"}};
  EXPECT_EQ(run("results", out_).exit_code, 0);
  EXPECT_TRUE(fs::is_empty(out_));
}

/// The filter refuses sockets; the namespace would give them nothing to reach.
TEST_F(SandboxTest, shares_no_namespace_with_the_grader) {
  const std::string inside = run("namespaces").output;
  for (const char* name : {"net", "ipc", "pid", "uts", "mnt"}) {
    EXPECT_TRUE(has(inside, std::string(name) + ":[")) << inside;
    EXPECT_FALSE(has(inside, fs::read_symlink(std::string("/proc/self/ns/") + name).string())) << name;
  }
}

/// What lies in the kernel's buffers is counted by no limit. Sockets, which have large ones, are refused
/// above.
TEST_F(SandboxTest, holds_little_in_pipes) {
  const Outcome outcome = run("pipes");
  ASSERT_TRUE(outcome.succeeded()) << outcome.errors;
  // The kernel gives an account without rights 64 MiB, and a page for each pipe beyond.
  EXPECT_LT(std::stoll(outcome.output), 80LL << 20U);
}

TEST_F(SandboxTest,
       shows_no_file_that_is_not_named_and_writes_nowhere_but_into_the_writable_folders_and_tmp) {
  const test::TemporaryFolder other;
  const fs::path shown = other.path(), secret = other / "reference.pfm";
  write_file(secret, "secret");
  ASSERT_EQ(::chmod(secret.c_str(), 0644), 0);
  for (const fs::path& file : std::vector<fs::path>{secret, "/etc/passwd", "/proc/1/root" + secret.string()})
    EXPECT_FALSE(can("read", file)) << file;
  confines_.read_only.push_back(shown);
  EXPECT_TRUE(can("read", secret));
  for (const fs::path& place :
       std::vector<fs::path>{shown, guest_.parent_path(), "/usr", "/dev", "/dev/shm", "/proc", "/"})
    EXPECT_FALSE(can("write", place / "file")) << place;
  EXPECT_TRUE(can("write", "/tmp/file"));
  EXPECT_EQ(run("room", "/tmp").output, "1048576\n") << "no more than the limit on the disk";
  EXPECT_EQ(run("room", out_).output, "1048576\n");
}

TEST_F(SandboxTest, gives_away_neither_processes_nor_environment_nor_open_files_nor_input) {
  std::istringstream names(run("list", "/proc").output);
  int processes = 0;
  for (std::string name; std::getline(names, name);) processes += name[0] >= '1' && name[0] <= '9' ? 1 : 0;
  EXPECT_EQ(processes, 2);  // the first process and the guest
  write_file(folder_ / "results", "");
  const int open_file = ::open((folder_ / "results").c_str(), O_RDWR);  // not to be closed on exec
  ::setenv("SECRET", "seed", 1);
  confines_.environment = {{"GIVEN", "this"}, {"HOME", "/nowhere"}};
  const std::string environment = run("environment").output;
  EXPECT_FALSE(has(environment, "SECRET"));
  EXPECT_TRUE(has(environment, "GIVEN=this\n"));
  EXPECT_TRUE(has(environment, "HOME=/nowhere\n"));
  // The three streams, and the folder that is being listed.
  EXPECT_EQ(run("list", "/proc/self/fd").output, "0\n1\n2\n3\n");
  EXPECT_EQ(run("input").output, "-1\n");
  ::close(open_file);
}

/// A second program's output goes where the first one's is, and the program chooses the names.
TEST_F(SandboxTest, leaves_behind_what_cannot_have_its_name) {
  fs::create_directories(out_ / "picture.png/below");
  write_file(out_ / "sub", "a file");
  // Sixteen folders with the longest name are too long a path.
  for (const char* what : {"results", "deep"}) {
    Outcome outcome;
    ASSERT_NO_THROW(outcome = run(what, out_)) << what;
    EXPECT_TRUE(outcome.succeeded()) << what;
  }
  EXPECT_TRUE(fs::is_directory(out_ / "picture.png"));
}

/// Needs a control group that the kernel lets us divide: tests/machines/control_groups makes such a machine.
TEST_F(SandboxTest, ends_a_program_whose_memory_only_the_kernel_counts) {
  if (!memory_group_fault().empty()) GTEST_SKIP() << memory_group_fault();
  confines_.limits.memory = 64U << 20U;
  const Outcome outcome = run("tables");
  EXPECT_EQ(outcome.limit, Limit::memory);
  EXPECT_EQ(outcome.signal, SIGKILL);
  EXPECT_FALSE(runs());
}

TEST_F(SandboxTest, has_a_limit_on_the_address_space_on_tmp_and_on_files) {
  EXPECT_EQ(run("fill", "/tmp").limit, Limit::disk);
  const Outcome holes = run("holes", out_);  // 20 of 1 MiB
  EXPECT_EQ(holes.exit_code, 0);
  EXPECT_EQ(holes.limit, Limit::disk);
  EXPECT_EQ(std::distance(fs::directory_iterator(out_), {}), 1) << "holes are not copied without end";
  confines_.limits.files = 10;
  EXPECT_EQ(run("holes", "/tmp").limit, Limit::disk);
  confines_.limits.address_space = 128U << 20U;
  EXPECT_EQ(run("memory").signal, SIGABRT);  // std::bad_alloc
}

TEST_F(SandboxTest, cuts_a_flood_of_output) {
  confines_.limits.output = 4U << 20U;
  confines_.limits.kept_output = 1000;
  const Outcome outcome = run("flood");
  EXPECT_EQ(outcome.output.size(), 1000U);
  EXPECT_GT(outcome.output_bytes, confines_.limits.output);
}

TEST_F(SandboxTest, dies_with_its_caller) {
  const pid_t caller = ::fork();
  if (caller == 0) {
    run("sleep");
    ::_exit(0);
  }
  EXPECT_TRUE(soon([&] { return runs(); }));
  ::kill(caller, SIGKILL);
  ::waitpid(caller, nullptr, 0);
  EXPECT_TRUE(soon([&] { return !runs(); }));
}

TEST_F(SandboxTest, throws_when_the_machine_is_at_fault) {
  const test::TemporaryFolder closed;
  const fs::path folder = closed.path();
  ASSERT_EQ(::chmod(folder.c_str(), 0700), 0);
  const std::function<void(Confines&)> faults[] = {
      [](Confines& confines) { confines.read_only.emplace_back("/no/such/folder"); },
      [](Confines& confines) { confines.working_folder = "/no/such/folder"; },
      [](Confines& confines) { confines.writable.emplace_back("relative"); },
      [&](Confines& confines) { confines.read_only.push_back(folder); }};  // for root: others cannot read it
  for (const auto& fault : std::span(faults).first(::geteuid() == 0 ? 4 : 3)) {
    Confines confines = confines_;
    fault(confines);
    EXPECT_THROW(run_locked_in(confines, {"true"}), Error);
  }
  EXPECT_THROW(run_locked_in(confines_, {}), Error);
}

TEST_F(SandboxTest, works_for_a_normal_user_too) {
  if (::geteuid() != 0) GTEST_SKIP() << "this is a normal user already";
  ASSERT_EQ(::chown(out_.c_str(), 12345, 12345), 0);
  const auto as_user = [&](const std::vector<std::string>& command) {
    std::vector<std::string> words = {"setpriv", "--reuid",        "12345", "--regid",
                                      "12345",   "--clear-groups", "env",   "TMPDIR=" + out_.string()};
    words.insert(words.end(), command.begin(), command.end());
    return run_program(words, true);
  };
  const std::string self = fs::read_symlink("/proc/self/exe").string();
  if (as_user({"test", "-x", self}).exit_code != 0) GTEST_SKIP() << "other users cannot run " << self;
  const Ran result = as_user({self, "--gtest_filter=-*normal_user*:*RunPlainly*:*memory*:*missing*"});
  EXPECT_EQ(result.exit_code, 0) << result.output;
  EXPECT_TRUE(has(result.output, "PASSED")) << result.output;
}

TEST_F(RunPlainly, limits_time_and_output_and_kills_the_process_group) {
  EXPECT_EQ(run("print", "hello").output, "hello\n");
  EXPECT_EQ(run("exit", "7").exit_code, 7);
  confines_.limits.wall_seconds = 0.2;
  EXPECT_EQ(run("sleep").limit, Limit::wall);
  EXPECT_TRUE(soon([&] { return !runs(); }));
  confines_.limits.wall_seconds = 20;
  EXPECT_EQ(run("flood").limit, Limit::output);
  confines_.limits.cpu_seconds = 1;
  EXPECT_EQ(run("spin").limit, Limit::cpu);
}

TEST_F(RunPlainly, is_not_what_one_gets_without_bubblewrap) {
  const char* const path = std::getenv("PATH");
  const std::string before = path == nullptr ? "" : path;
  ::setenv("PATH", "/nowhere", 1);
  const std::string message = test::error_of([] { run_locked_in({}, {"true"}); });
  ::setenv("PATH", before.c_str(), 1);
  EXPECT_TRUE(has(message, "bubblewrap")) << message;
  EXPECT_TRUE(has(message, "--unsafe")) << message;
}

}  // namespace
}  // namespace texel::sandbox
