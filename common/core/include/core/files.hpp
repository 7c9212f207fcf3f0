// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace texel {

/// A whole file as bytes. Throws Error (exit 3) that says whether it is missing, a folder or unreadable.
std::string read_file(const std::filesystem::path& path);

/// Writes a whole file under a temporary name beside it, then renames it. There is never a half file,
/// and an existing file survives a failure. Links are followed. Devices and pipes are written to directly.
/// Throws Error (exit 3) when the folder is missing or the disk full.
void write_file(const std::filesystem::path& path, std::string_view bytes);

/// Makes a folder that is missing, with those above it. Throws Error (exit 3), with the remedy.
void make_folder(const std::filesystem::path& folder,
                 const std::string& remedy = "check that it is writable and the disk has free space");

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
  /// 0 if it went well.
  int close();

 private:
  int fd_;
};

/// A file's bytes, mapped read-only into memory.
class MappedFile {
 public:
  explicit MappedFile(const std::filesystem::path& path);
  ~MappedFile();
  MappedFile& operator=(MappedFile&&) = delete;
  [[nodiscard]] std::string_view bytes() const { return bytes_; }

 private:
  std::string_view bytes_;
};

/// Keeps other processes out as long as what it returns lives. The file stays. Waits for its turn; with
/// `at_once` throws Error (exit 3) when another has it.
[[nodiscard]] Descriptor lock_file(const std::filesystem::path& file, bool at_once = false);

/// A new empty folder among the system's temporary files. The destructor removes it with its content.
/// Throws Error (exit 3) when it cannot be made.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder& operator=(ScratchFolder&&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// Notices edited files by their time and size, and folders in which a file appeared or vanished. Also
/// works with editors that write another file and rename it.
class Watcher {
 public:
  /// Which of `files` changed since the last call. A file seen for the first time is not changed.
  std::vector<std::filesystem::path> changed(const std::vector<std::filesystem::path>& files);

 private:
  struct Stamp {
    std::filesystem::file_time_type time;
    std::uintmax_t size = 0;
    bool operator==(const Stamp&) const = default;
  };
  std::map<std::filesystem::path, Stamp> stamps_;
};

}  // namespace texel
