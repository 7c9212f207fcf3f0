// SPDX-License-Identifier: MIT
#include "core/files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <stdlib.h>  // mkdtemp
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "core/error.hpp"
#include "core/stages.hpp"

namespace texel {
namespace {

/// The size of a file that was opened. Throws Error (exit 3) when it could not be, or is none.
std::size_t size_of_regular(const std::filesystem::path& path, const Descriptor& file) {
  const Place place{path.string()};
  if (!file.is_open())
    throw Error::failed(fmt::format("cannot open: {}", std::strerror(errno)), place,
                        "check the path's spelling");
  struct stat status {};
  if (::fstat(file.get(), &status) != 0) throw Error::failed(std::strerror(errno), place);
  if (!S_ISREG(status.st_mode))
    throw Error::failed("is not a regular file", place, "name a file, not a folder");
  return static_cast<std::size_t>(status.st_size);
}

}  // namespace

int Descriptor::close() {
  const int fd = std::exchange(fd_, -1);
  return fd < 0 ? 0 : ::close(fd);
}

std::string read_file(const std::filesystem::path& path) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  std::string bytes(size_of_regular(path, file), '\0');
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t got = ::read(file.get(), bytes.data() + done, bytes.size() - done);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw Error::failed(fmt::format("cannot read: {}", std::strerror(errno)), {path.string()});
    if (got == 0) break;  // it became shorter while we read
    done += static_cast<std::size_t>(got);
  }
  bytes.resize(done);
  return bytes;
}

void write_file(const std::filesystem::path& path, std::string_view bytes) {
  const Stage stage("write");
  std::error_code ignored;
  const std::filesystem::path target =
      std::filesystem::is_symlink(path, ignored) ? std::filesystem::weakly_canonical(path, ignored) : path;
  const std::filesystem::file_status status = std::filesystem::status(target, ignored);
  const bool in_place = std::filesystem::exists(status) && !std::filesystem::is_regular_file(status);
  const std::string beside =
      in_place ? target.string() : fmt::format("{}.{}.part", target.string(), ::getpid());
  const auto fail = [&](const char* doing, int error) {
    if (!in_place) ::unlink(beside.c_str());
    return Error::failed(fmt::format("cannot {}: {}", doing, std::strerror(error)), {path.string()},
                         "check that the folder exists, is writable and has free space");
  };
  Descriptor file(::open(beside.c_str(), O_WRONLY | O_CLOEXEC | (in_place ? 0 : O_CREAT | O_TRUNC), 0666));
  if (!file.is_open()) throw fail("write", errno);
  while (!bytes.empty()) {
    const ssize_t put = ::write(file.get(), bytes.data(), bytes.size());
    if (put < 0 && errno == EINTR) continue;
    if (put < 0) throw fail("write", errno);
    bytes.remove_prefix(static_cast<std::size_t>(put));
  }
  if (file.close() != 0) throw fail("write", errno);
  if (!in_place && std::rename(beside.c_str(), target.c_str()) != 0) throw fail("rename into place", errno);
}

void make_folder(const std::filesystem::path& folder, const std::string& remedy) {
  if (folder.empty()) return;  // of a file that lies here
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    throw Error::failed(fmt::format("cannot make the folder: {}", error.message()), {folder.string()},
                        remedy);
}

MappedFile::MappedFile(const std::filesystem::path& path) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  const std::size_t size = size_of_regular(path, file);
  if (size == 0) return;
  void* mapped = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file.get(), 0);
  if (mapped == MAP_FAILED)
    throw Error::failed(fmt::format("cannot map: {}", std::strerror(errno)), {path.string()});
  bytes_ = {static_cast<const char*>(mapped), size};
}

MappedFile::~MappedFile() {
  if (!bytes_.empty()) ::munmap(const_cast<char*>(bytes_.data()), bytes_.size());
}

Descriptor lock_file(const std::filesystem::path& file, bool at_once) {
  Descriptor lock(::open(file.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0644));
  if (!lock.is_open())
    throw Error::failed(fmt::format("cannot be opened: {}", std::strerror(errno)), {file.string()},
                        "name a writable folder");
  if (::flock(lock.get(), LOCK_EX | (at_once ? LOCK_NB : 0)) != 0)
    throw Error::failed("another process works here", {file.string()}, "wait for its end");
  return lock;
}

ScratchFolder::ScratchFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "texel_XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr)
    throw Error::failed("cannot make a temporary folder", {name},
                        "check that this folder is writable and has free space");
  path_ = name;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;  // a destructor cannot report it
  std::filesystem::remove_all(path_, ignored);
}

std::vector<std::filesystem::path> Watcher::changed(const std::vector<std::filesystem::path>& files) {
  std::vector<std::filesystem::path> result;
  for (const std::filesystem::path& file : files) {
    std::error_code error;
    Stamp stamp;
    stamp.time = std::filesystem::last_write_time(file, error);
    if (!error && !std::filesystem::is_directory(file)) stamp.size = std::filesystem::file_size(file, error);
    if (error) stamp = {};  // missing for the moment between an editor's delete and rename
    const auto [known, is_new] = stamps_.try_emplace(file, stamp);
    if (!is_new && std::exchange(known->second, stamp) != stamp) result.push_back(file);
  }
  return result;
}

}  // namespace texel
