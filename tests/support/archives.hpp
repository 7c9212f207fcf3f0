// SPDX-License-Identifier: MIT
// Zips and tarballs made in memory, sound and hostile ones.
#pragma once
#include <archive.h>
#include <archive_entry.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace texel::test {

struct Packed {
  std::string path, content;
  unsigned type = AE_IFREG;
  std::string link = {};  ///< where a symbolic link points, or which file a hard link is (with AE_IFREG)
};

enum class Format { zip, tar, tar_gz };

inline std::string pack(Format format, const std::vector<Packed>& files, const std::string& password = {}) {
  const std::unique_ptr<archive, int (*)(archive*)> writer(::archive_write_new(), &::archive_write_free);
  archive* const a = writer.get();
  if (format == Format::zip) {
    ::archive_write_set_format_zip(a);
    if (!password.empty()) {
      ::archive_write_set_options(a, "zip:encryption=zipcrypt");
      ::archive_write_set_passphrase(a, password.c_str());
    }
  } else {
    ::archive_write_set_format_pax_restricted(a);
    if (format == Format::tar_gz) ::archive_write_add_filter_gzip(a);
  }
  ::archive_write_set_bytes_in_last_block(a, 1);  // no zeros behind the end
  std::string bytes;
  const auto append = [](archive*, void* to, const void* data, std::size_t size) {
    static_cast<std::string*>(to)->append(static_cast<const char*>(data), size);
    return static_cast<la_ssize_t>(size);
  };
  if (::archive_write_open(a, &bytes, nullptr, append, nullptr) != ARCHIVE_OK)
    throw std::runtime_error("cannot make an archive");
  for (const Packed& file : files) {
    const std::unique_ptr<archive_entry, void (*)(archive_entry*)> entry(::archive_entry_new(),
                                                                         &::archive_entry_free);
    ::archive_entry_set_pathname(entry.get(), file.path.c_str());
    ::archive_entry_set_filetype(entry.get(), file.type);
    ::archive_entry_set_perm(entry.get(), 0644);
    ::archive_entry_set_size(entry.get(), static_cast<la_int64_t>(file.content.size()));
    if (file.type == AE_IFLNK) ::archive_entry_set_symlink(entry.get(), file.link.c_str());
    if (file.type == AE_IFREG && !file.link.empty())
      ::archive_entry_set_hardlink(entry.get(), file.link.c_str());
    // A warning is of a name that the locale cannot spell.
    if (::archive_write_header(a, entry.get()) < ARCHIVE_WARN)
      throw std::runtime_error(::archive_error_string(a));
    ::archive_write_data(a, file.content.data(), file.content.size());
  }
  ::archive_write_close(a);
  return bytes;
}

/// Sets the flag that says that a zip's names are UTF-8 (APPNOTE.TXT 4.4.4, bit 11).
inline std::string with_utf8_flag(std::string zip) {
  for (const auto& [head, flags] : {std::pair("PK\x03\x04", 7), {"PK\x01\x02", 9}})
    for (std::size_t at = zip.find(head); at != zip.npos; at = zip.find(head, at + 4))
      zip[at + static_cast<std::size_t>(flags)] =
          static_cast<char>(zip[at + static_cast<std::size_t>(flags)] | 8);
  return zip;
}

}  // namespace texel::test
