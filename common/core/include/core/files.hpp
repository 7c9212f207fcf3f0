// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace texel {

/// A whole file as bytes. Throws Error (exit 3) that says whether it is missing, a folder or unreadable.
std::string read_file(const std::filesystem::path& path);

/// Writes a whole file under a temporary name beside it, then renames it. There is never a half file,
/// and an existing file survives a failure. Links are followed. Devices and pipes are written to directly.
/// Throws Error (exit 3) when the folder is missing or the disk full.
void write_file(const std::filesystem::path& path, std::string_view bytes);

/// A file's bytes, mapped read-only into memory. A small file is read instead: that takes half the time.
class MappedFile {
 public:
  explicit MappedFile(const std::filesystem::path& path);
  ~MappedFile();
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;
  [[nodiscard]] std::string_view bytes() const {
    return data_ != nullptr ? std::string_view(data_, size_) : std::string_view(read_);
  }

 private:
  static constexpr std::size_t most_read = 16384;  // bytes
  std::string read_;
  const char* data_ = nullptr;
  std::size_t size_ = 0;
};

}  // namespace texel
