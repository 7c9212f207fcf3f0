// SPDX-License-Identifier: MIT
#include "core/files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
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

/// A file descriptor that is closed at the end of its scope.
class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  [[nodiscard]] int get() const { return fd_; }
  [[nodiscard]] int close() {
    const int result = ::close(fd_);
    fd_ = -1;
    return result;
  }

 private:
  int fd_;
};

std::size_t open_regular(const std::filesystem::path& path, Descriptor& file) {
  const Place place{path.string()};
  if (file.get() < 0)
    throw Error::failed(fmt::format("cannot open: {}", std::strerror(errno)), place,
                        "check the path's spelling");
  struct stat status {};
  if (::fstat(file.get(), &status) != 0) throw Error::failed(std::strerror(errno), place);
  if (!S_ISREG(status.st_mode))
    throw Error::failed("is not a regular file", place, "name a file, not a folder");
  return static_cast<std::size_t>(status.st_size);
}

std::string read_all(const std::filesystem::path& path, const Descriptor& file, std::size_t size) {
  std::string bytes(size, '\0');
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

}  // namespace

std::string read_file(const std::filesystem::path& path) {
  Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  const std::size_t size = open_regular(path, file);
  return read_all(path, file, size);
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
  if (file.get() < 0) throw fail("write", errno);
  while (!bytes.empty()) {
    const ssize_t put = ::write(file.get(), bytes.data(), bytes.size());
    if (put < 0 && errno == EINTR) continue;
    if (put < 0) throw fail("write", errno);
    bytes.remove_prefix(static_cast<std::size_t>(put));
  }
  if (file.close() != 0) throw fail("write", errno);
  if (!in_place && std::rename(beside.c_str(), target.c_str()) != 0) throw fail("rename into place", errno);
}

MappedFile::MappedFile(const std::filesystem::path& path) {
  Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  size_ = open_regular(path, file);
  if (size_ <= most_read) {
    read_ = read_all(path, file, size_);
    return;
  }
  void* mapped = ::mmap(nullptr, size_, PROT_READ, MAP_PRIVATE, file.get(), 0);
  if (mapped == MAP_FAILED)
    throw Error::failed(fmt::format("cannot map: {}", std::strerror(errno)), {path.string()});
  data_ = static_cast<const char*>(mapped);
}

MappedFile::~MappedFile() {
  if (data_ != nullptr) ::munmap(const_cast<char*>(data_), size_);
}

}  // namespace texel
