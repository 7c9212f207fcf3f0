// SPDX-License-Identifier: MIT
#include "sandbox/descriptor.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>

namespace texel::sandbox {

Descriptor open_in(const Descriptor& folder, const std::string& name) {
  return Descriptor(::openat(folder.get(), name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
}

std::vector<std::string> names_in(const Descriptor& folder, std::size_t most) {
  std::vector<std::string> names;
  const int fd = ::openat(folder.get(), ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  DIR* entries = fd < 0 ? nullptr : ::fdopendir(fd);
  if (entries == nullptr) return names;
  while (const dirent* entry = names.size() < most ? ::readdir(entries) : nullptr) {
    const std::string name = entry->d_name;
    if (name != "." && name != "..") names.push_back(name);
  }
  ::closedir(entries);
  std::sort(names.begin(), names.end());
  return names;
}

std::string read_some(const Descriptor& file, std::size_t most) {
  constexpr std::size_t step = 16384;
  std::string bytes;
  std::size_t done = 0;
  while (done < most) {
    bytes.resize(std::min(most, std::max(2 * done, step)));  // most files are far smaller than `most`
    const ssize_t got = ::read(file.get(), bytes.data() + done, bytes.size() - done);
    if (got <= 0) break;
    done += static_cast<std::size_t>(got);
  }
  bytes.resize(done);
  return bytes;
}

}  // namespace texel::sandbox
