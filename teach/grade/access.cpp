// SPDX-License-Identifier: MIT
#include "access.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "store/store.hpp"

namespace texel::grade {
namespace {

namespace fs = std::filesystem;

constexpr fs::perms kOwn = fs::perms::owner_all;
constexpr fs::perms kEntered = kOwn | fs::perms::group_exec | fs::perms::others_exec;

/// Folders that only the grader may enter.
std::vector<fs::path> own_folders(const GradeOptions& options) {
  return {options.out / "pictures", options.out / "references", options.cache / "references",
          options.cache / "solutions"};
}

}  // namespace

void restrict_access(const GradeOptions& options) {
  try {
    for (const fs::path& folder : own_folders(options)) {
      fs::create_directories(folder);
      fs::permissions(folder, kOwn);
    }
    for (const fs::path& folder : {options.out, options.out / "work", options.cache,
                                   options.cache / "programs", options.cache / "objects"}) {
      fs::create_directories(folder);
      fs::permissions(folder, kEntered);
    }
    { const store::Store made(store_file(options.out)); }
    fs::permissions(store_file(options.out), fs::perms::owner_read | fs::perms::owner_write);
  } catch (const fs::filesystem_error& error) {
    throw Error::failed("cannot be closed to other users: " + error.code().message(),
                        {error.path1().string()});
  }
}

void check_access(const GradeOptions& options) {
  std::vector<fs::path> secret = own_folders(options);
  for (const char* path : {"labs", "common", "shaders", "tests", ".git"})
    secret.push_back(options.course / path);
  secret.push_back(options.build / "bin");
  secret.push_back(store_file(options.out));
  secret.push_back(options.seed_file.empty() ? options.out / "seed.txt" : options.seed_file);
  std::vector<std::string> words = {"/bin/sh", "-c",
                                    "until [ \"$1\" = -- ]; do if [ -r \"$1\" ] || [ -x \"$1\" ]; then echo "
                                    "\"$1\"; fi; shift; done; shift; "
                                    "for f; do if [ -w \"$f\" ]; then echo \"$f\"; fi; done",
                                    "sh"};
  for (const fs::path& path : secret) words.push_back(fs::absolute(path).string());
  words.insert(words.end(), {"--", "/tmp", "/var/tmp", "/dev/shm", "/dev/mqueue", "/run/lock"});
  const Outcome outcome = sandbox::run_as_another_user({}, words);
  if (!outcome.succeeded()) throw Error::failed("cannot try what is open to other users: " + outcome.errors);
  if (outcome.output.empty()) return;
  std::string open = outcome.output;
  open.pop_back();
  std::replace(open.begin(), open.end(), '\n', ' ');
  throw Error::failed(
      "with --walls user, a student's programs could read the course or leave files in: " + open, {},
      "type chmod go-rwx for what is read, and chmod go-w for what is written");
}

}  // namespace texel::grade
