// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "process.hpp"

namespace texel::sandbox {
namespace {

constexpr int deepest = 16;
constexpr std::size_t most_copied = 1'000'000;  // the sandbox was ended long before

Error cannot_write(const std::filesystem::path& path) {
  return Error::failed(fmt::format("cannot write: {}", std::strerror(errno)), {path.string()},
                       "check that the folder is writable and the disk has free space");
}

/// Whether the name is why it cannot be written: too long a path, or a file where a folder was.
bool is_by_its_name() {
  return errno == ENAMETOOLONG || errno == ENOTDIR || errno == EISDIR || errno == EEXIST;
}

void copy_file(const Descriptor& from, const std::filesystem::path& to, mode_t mode) {
  // A new file, never through a link that an earlier program left here.
  ::unlink(to.c_str());
  const Descriptor file(::open(to.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode));
  if (!file.is_open() && is_by_its_name()) return;
  if (!file.is_open()) throw cannot_write(to);
  std::vector<char> block(1U << 16U);
  while (true) {
    const ssize_t got = ::read(from.get(), block.data(), block.size());
    if (got <= 0) return;
    if (::write(file.get(), block.data(), static_cast<std::size_t>(got)) != got) throw cannot_write(to);
  }
}

bool copy_folder(const Descriptor& from, const std::filesystem::path& to, std::uint64_t& room, int depth) {
  bool all = true;
  for (const std::string& name : names_in(from, most_copied)) {
    const Descriptor entry = open_in(from, name);
    struct stat status {};
    if (!entry.is_open() || ::fstat(entry.get(), &status) != 0) continue;
    if (S_ISDIR(status.st_mode) && depth < deepest) {
      if (::mkdir((to / name).c_str(), 0755) != 0 && errno != EEXIST) {
        if (is_by_its_name()) continue;
        throw cannot_write(to / name);
      }
      all = copy_folder(entry, to / name, room, depth + 1) && all;
    }
    if (!S_ISREG(status.st_mode)) continue;
    const auto size = static_cast<std::uint64_t>(status.st_size);
    if (size > room) {
      all = false;
      continue;
    }
    room -= size;
    copy_file(entry, to / name, (status.st_mode & S_IXUSR) != 0 ? 0755 : 0644);
  }
  return all;
}

}  // namespace

bool copy_results(const Descriptor& from, const std::filesystem::path& to, std::uint64_t limit) {
  return copy_folder(from, to, limit, 0);
}

}  // namespace texel::sandbox
