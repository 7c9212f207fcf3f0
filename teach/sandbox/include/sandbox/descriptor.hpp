// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace texel::sandbox {

/// A file descriptor that is closed at the end of its scope; -1 for none.
class Descriptor {
 public:
  explicit Descriptor(int fd = -1) : fd_(fd) {}
  ~Descriptor() { close(); }
  Descriptor(Descriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(fd_, other.fd_);
    return *this;
  }
  [[nodiscard]] int get() const { return fd_; }
  [[nodiscard]] bool is_open() const { return fd_ >= 0; }
  void close();

 private:
  int fd_;
};

/// Opens what is called `name` in a folder for reading, without following a link and without waiting for a
/// pipe; not open when it cannot.
Descriptor open_in(const Descriptor& folder, const std::string& name);

/// The names in a folder in the order of their bytes, at most `most` of them; none when it cannot be read.
std::vector<std::string> names_in(const Descriptor& folder, std::size_t most);

/// The first `most` bytes of an open file, or all when it has fewer.
std::string read_some(const Descriptor& file, std::size_t most);

}  // namespace texel::sandbox
