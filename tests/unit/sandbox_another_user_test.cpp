// SPDX-License-Identifier: MIT
// Programs that try to do harm, where there are no namespaces: as another user.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <fstream>

#include "../support/picture_files.hpp"
#include "../support/process.hpp"
#include "../support/said.hpp"
#include "core/error.hpp"
#include "core/files.hpp"
#include "sandbox/sandbox.hpp"

namespace texel::sandbox {
namespace {

namespace fs = std::filesystem;
using test::has;

class AnotherUser : public testing::Test {
 protected:
  void SetUp() override {
    if (::geteuid() != 0) GTEST_SKIP() << "needs root";
    ASSERT_EQ(another_user_fault(), "");
    // The tree may lie where only root can read.
    guest_ = (programs_ / "guest").string();
    ::chmod((programs_ / "x").parent_path().c_str(), 0755);
    fs::copy_file(SANDBOX_GUEST, guest_);
    confines_.read_only = {(programs_ / "x").parent_path()};
    confines_.writable = {(folder_ / "x").parent_path()};
    confines_.limits.wall_seconds = 20;
    confines_.limits.disk = 1U << 20U;
    ::chmod(confines_.writable[0].c_str(), 0755);
  }
  [[nodiscard]] Outcome run(const std::string& what, const std::string& where = {}) const {
    return run_as_another_user(confines_, {guest_, what, where});
  }
  [[nodiscard]] fs::path out() const { return confines_.writable[0]; }

  /// Whether a guest with this argument runs still.
  [[nodiscard]] bool runs(const std::string& argument) const {
    for (const fs::directory_entry& entry : fs::directory_iterator("/proc")) {
      std::ifstream file(entry.path() / "cmdline");
      std::string line;
      std::getline(file, line);
      if (line.starts_with(guest_) && has(line, argument)) return true;
    }
    return false;
  }

  test::TemporaryFolder folder_{"another_user"};
  test::TemporaryFolder programs_{"another_user_programs"};
  std::string guest_;
  Confines confines_;
};

TEST_F(AnotherUser, gives_exit_code_output_and_usage) {
  const Outcome outcome = run("exit", "125");
  EXPECT_EQ(outcome.exit_code, 125);
  EXPECT_EQ(outcome.limit, Limit::none);
  EXPECT_EQ(run("print", "$(id) 'a'").output, "$(id) 'a'\n");
  EXPECT_EQ(run("abort").signal, SIGABRT);
}

TEST_F(AnotherUser, has_no_network_and_no_forbidden_system_call) {
  for (const char* what : {"network", "forbidden"}) {
    const Outcome outcome = run(what);
    EXPECT_FALSE(has(outcome.output, "possible")) << outcome.output;
    EXPECT_TRUE(has(outcome.output, "not permitted")) << outcome.output << outcome.errors;
  }
}

TEST_F(AnotherUser, reaches_no_closed_file_and_no_process_of_others) {
  const test::TemporaryFolder closed("another_user_closed");
  write_file(closed / "seed.txt", "secret");
  EXPECT_TRUE(has(run("read", closed / "seed.txt").output, "possible"));
  ASSERT_EQ(::chmod((closed / "x").parent_path().c_str(), 0700), 0);
  EXPECT_FALSE(has(run("read", closed / "seed.txt").output, "possible"));
  EXPECT_FALSE(has(run("write", "/usr/file").output, "possible"));
  EXPECT_FALSE(has(run("signals", std::to_string(::getpid())).output, "possible"));
  const std::string memory = "/proc/" + std::to_string(::getpid()) + "/environ";
  EXPECT_FALSE(has(run("read", memory).output, "possible"));
}

TEST_F(AnotherUser, leaves_files_but_no_links_and_finds_an_empty_folder) {
  write_file(out() / "earlier", "of ours");
  EXPECT_EQ(run("list", out().string()).output, "");
  EXPECT_TRUE(run("results", out().string()).succeeded());
  EXPECT_EQ(read_file(out() / "picture.png"), "a picture");
  EXPECT_EQ(read_file(out() / "sub/more.ply"), "a mesh");
  EXPECT_EQ(read_file(out() / "earlier"), "of ours");
  for (const char* name : {"link.png", "folder", "pipe.png"})
    EXPECT_FALSE(fs::exists(fs::symlink_status(out() / name))) << name;
}

TEST_F(AnotherUser, is_held_to_every_limit) {
  EXPECT_EQ(run("fill", out().string()).limit, Limit::disk);
  confines_.limits.processes = 20;
  EXPECT_EQ(run("forks").output, "19\n");
  confines_.limits.output = 4U << 20U;
  EXPECT_EQ(run("flood").limit, Limit::output);
  confines_.limits.memory = 256U << 20U;
  EXPECT_EQ(run("memory").limit, Limit::memory);
  EXPECT_EQ(run("huge").signal, SIGABRT);
  confines_.limits.cpu_seconds = 0.2;
  EXPECT_EQ(run("ignore").limit, Limit::cpu);
}

TEST_F(AnotherUser, takes_all_its_processes_down) {
  const std::string own = "another" + std::to_string(::getpid());
  EXPECT_EQ(run("daemon", own + "daemon").exit_code, 0);
  EXPECT_FALSE(runs(own + "daemon"));
  confines_.limits.wall_seconds = 0.3;
  EXPECT_EQ(run("bomb", own + "bomb").limit, Limit::wall);
  EXPECT_FALSE(runs(own + "bomb"));
  EXPECT_EQ(run("sleep", own + "sleep").limit, Limit::wall);
}

}  // namespace
}  // namespace texel::sandbox
