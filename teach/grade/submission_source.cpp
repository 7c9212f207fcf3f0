// SPDX-License-Identifier: MIT
#include <archive.h>
#include <archive_entry.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <locale.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <map>
#include <memory>
#include <string_view>

#include "core/error.hpp"
#include "core/files.hpp"
#include "core/plain_text.hpp"
#include "sandbox/descriptor.hpp"
#include "unpack.hpp"

namespace texel::grade {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_path = 1000;
constexpr int deepest = 32;

std::string too_large(const UnpackLimits& limits) {
  return fmt::format("is larger than {} KiB", limits.file >> 10U);
}

std::string too_many(const UnpackLimits& limits) {
  return fmt::format("contains more than {} files; hand in only the labs' sources and shaders",
                     limits.entries);
}

/// Whether there are control characters of ASCII in it, which no encoding has for anything else.
bool has_controls(std::string_view name) {
  return std::any_of(name.begin(), name.end(), [](char c) { return (c >= 0 && c < 0x20) || c == 0x7f; });
}

/// Why nothing of that name is ever taken, or "". Else '\' becomes '/', as archives from Windows have it, and
/// '.' and empty parts go. The names of the course are ASCII, which every encoding has in common: what is no
/// UTF-8 becomes U+FFFD, so folders around them may be called anything.
std::string refuse_or_clean(std::string& path) {
  if (path.empty()) return "has no name";
  if (path.size() > longest_path) return "has a name that is too long";
  if (has_controls(path)) return "has a name with control characters";
  path = plain_text(path);
  std::string slashed = path;
  std::ranges::replace(slashed, '\\', '/');
  if (slashed[0] == '/' || (slashed.size() > 1 && slashed[1] == ':')) return "has an absolute path";
  fs::path clean;
  for (const fs::path& part : fs::path(slashed)) {
    if (part == "..") return "has a path with ..";
    if (part.empty() || part == ".") continue;
    if (part.native().starts_with('.') || part == "__MACOSX") return "is hidden or belongs to the system";
    clean /= part;
  }
  if (clean.empty()) return "has no name";
  path = clean.string();
  return {};
}

// --- Folders -----------------------------------------------------------------------------------------------

Descriptor open_folder(const Entry& entry) {
  Descriptor folder(::open(entry.path.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
  if (!folder.is_open())
    throw Error::failed(fmt::format("cannot open: {}", std::strerror(errno)), {entry.path.string()},
                        "check its read permission");
  return folder;
}

std::string refuse_kind(const struct stat& status, const UnpackLimits& limits) {
  if (S_ISLNK(status.st_mode)) return "is a symbolic link";
  if (!S_ISREG(status.st_mode)) return "is a device, pipe or socket";
  return static_cast<std::uint64_t>(status.st_size) > limits.file ? too_large(limits) : "";
}

/// Lists a folder in the order of names. `prefix` is its path as text, `place` as the disk has it; both are
/// "" or end in '/'. `room`: for so many more files and folders.
void list_folder(const Descriptor& folder, const std::string& prefix, const std::string& place, int depth,
                 const UnpackLimits& limits, std::size_t& room, Listing& listing) {
  for (const std::string& name : sandbox::names_in(folder, limits.entries + 1)) {
    if (room == 0) listing.fault = too_many(limits);
    if (!listing.fault.empty()) return;
    --room;
    Item item{.path = prefix + name, .place = place + name};
    struct stat status {};
    const bool is_known = ::fstatat(folder.get(), name.c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0;
    item.refused = refuse_or_clean(item.path);
    if (is_known && S_ISDIR(status.st_mode) && item.refused.empty()) {
      if (depth < deepest) {
        list_folder(sandbox::open_in(folder, name), item.path + '/', item.place + '/', depth + 1, limits,
                    room, listing);
        continue;
      }
      item.refused = "is in too many nested folders";
    }
    if (item.refused.empty()) item.refused = is_known ? refuse_kind(status, limits) : "cannot be read";
    item.size = static_cast<std::uint64_t>(status.st_size);
    listing.items.push_back(std::move(item));
  }
}

void read_folder(const Entry& entry, const std::set<const Item*>& wanted, std::size_t most,
                 Submission& submission, const Take& take) {
  for (const Item* item : wanted) {
    Descriptor file = open_folder(entry);
    // Part by part, so that no link on the way is followed.
    for (const fs::path& part : fs::path(item->place)) file = sandbox::open_in(file, part.string());
    struct stat status {};
    if (::fstat(file.get(), &status) != 0 || !S_ISREG(status.st_mode))
      submission.ignored.push_back({item->path, "changed while it was read"});
    else
      take(*item, sandbox::read_some(file, most));
  }
}

// --- Archives ----------------------------------------------------------------------------------------------

/// UTF-8 for this thread, whatever the machine's locale is: libarchive loses names that the locale cannot
/// spell.
class Utf8 {
 public:
  Utf8() : locale_(::newlocale(LC_CTYPE_MASK, "C.UTF-8", nullptr)) {
    if (locale_ == nullptr) throw Error::failed("this machine has no locale C.UTF-8");
    before_ = ::uselocale(locale_);
  }
  ~Utf8() {
    ::uselocale(before_);
    ::freelocale(locale_);
  }
  Utf8& operator=(Utf8&&) = delete;

 private:
  locale_t locale_, before_ = nullptr;
};

bool is_gzip(std::string_view bytes) {
  return bytes.starts_with("\x1f\x8b");
}

/// A zip's first entry, or its directory where it has none.
bool begins_as_zip(std::string_view bytes) {
  return bytes.starts_with("PK\x03\x04") || bytes.starts_with("PK\x05\x06");
}

/// Which of the two formats it has: its content says more than its name.
bool is_zip(const Entry& entry, std::string_view bytes) {
  return begins_as_zip(bytes) || (entry.kind == Entry::Kind::zip && !is_gzip(bytes));
}

/// An archive in memory, read from its beginning.
class Archive {
 public:
  Archive(const Entry& entry, std::string_view bytes) : archive_(::archive_read_new(), &::archive_read_free) {
    archive* const reader = archive_.get();
    if (reader == nullptr) throw Error::failed("no memory to read it", {entry.path.string()});
    // Only these formats: the fewer parsers, the fewer ways in.
    const bool is_supported = is_zip(entry, bytes)
                                  ? ::archive_read_support_format_zip_seekable(reader) == ARCHIVE_OK
                                  : ::archive_read_support_format_tar(reader) == ARCHIVE_OK &&
                                        ::archive_read_support_filter_gzip(reader) == ARCHIVE_OK;
    if (!is_supported) throw Error::failed("this machine's libarchive cannot read zip or tar.gz");
    is_open_ = ::archive_read_open_memory(reader, bytes.data(), bytes.size()) == ARCHIVE_OK;
  }

  /// The next entry, or nullptr at the end and when the archive is broken.
  archive_entry* next() {
    archive_entry* entry = nullptr;
    const int result = is_open_ ? ::archive_read_next_header(archive_.get(), &entry) : ARCHIVE_FATAL;
    if (result == ARCHIVE_EOF) return nullptr;
    // A warning is of a name in another encoding than it says.
    if (result != ARCHIVE_OK && result != ARCHIVE_WARN) {
      fault_ = "is a broken archive: " + error();
      return nullptr;
    }
    return entry;
  }

  /// The current entry's first `most` bytes. Sets the fault when they are broken.
  std::string data(std::size_t most) {
    std::string bytes(most, '\0');
    const la_ssize_t got = ::archive_read_data(archive_.get(), bytes.data(), bytes.size());
    if (got < 0) fault_ = "is a broken archive: " + error();
    bytes.resize(static_cast<std::size_t>(std::max<la_ssize_t>(got, 0)));
    return bytes;
  }

  [[nodiscard]] std::uint64_t unpacked() const {
    return static_cast<std::uint64_t>(std::max<la_int64_t>(::archive_filter_bytes(archive_.get(), 0), 0));
  }
  [[nodiscard]] const std::string& fault() const { return fault_; }

 private:
  [[nodiscard]] std::string error() const {
    const char* text = ::archive_error_string(archive_.get());
    if (text == nullptr) return "unknown";
    const std::string_view line(text);  // some end with a newline
    return plain_text(line.substr(0, line.find('\n')));
  }

  Utf8 utf8_;
  std::unique_ptr<archive, int (*)(archive*)> archive_;
  bool is_open_ = false;
  std::string fault_;
};

/// The bytes of the name; "" where the archive has none.
std::string name_of(archive_entry* entry) {
  const char* name = ::archive_entry_pathname_utf8(entry);
  if (name == nullptr) name = ::archive_entry_pathname(entry);
  return name == nullptr ? "" : name;
}

std::uint64_t size_of(archive_entry* entry) {
  return static_cast<std::uint64_t>(std::max<la_int64_t>(::archive_entry_size(entry), 0));
}

std::string refuse_kind(archive_entry* entry, const UnpackLimits& limits) {
  if (::archive_entry_hardlink(entry) != nullptr) return "is a hard link";
  if (::archive_entry_filetype(entry) == AE_IFLNK) return "is a symbolic link";
  if (::archive_entry_filetype(entry) != AE_IFREG) return "is a device, pipe or socket";
  if (::archive_entry_is_encrypted(entry) != 0) return "is encrypted";
  return size_of(entry) > limits.file ? too_large(limits) : "";
}

/// libarchive reads a zip's whole directory before it gives the first entry, so that a huge one must be seen
/// before. Archives in the archive that are not compressed are counted too.
bool has_too_many_entries(std::string_view zip, const UnpackLimits& limits) {
  constexpr std::string_view directory_entry("PK\x01\x02");
  std::size_t count = 0;
  for (std::size_t at = zip.find(directory_entry); at != std::string_view::npos && count <= limits.entries;
       at = zip.find(directory_entry, at + directory_entry.size()))
    ++count;
  return count > limits.entries;
}

bool is_bomb(std::uint64_t packed, std::uint64_t unpacked, const UnpackLimits& limits) {
  constexpr std::uint64_t harmless = 16U << 20U;
  return unpacked > limits.unpacked || (unpacked > harmless && unpacked / limits.ratio > packed);
}

Listing list_archive(const Entry& entry, std::string_view bytes, const UnpackLimits& limits) {
  Listing listing;
  if (is_zip(entry, bytes) && has_too_many_entries(bytes, limits)) {
    listing.fault = too_many(limits);
    return listing;
  }
  Archive archive(entry, bytes);
  std::uint64_t unpacked = 0;
  std::size_t position = 0;
  // Sizes are added before the next header, for which a compressed tar must unpack what is between.
  while (archive_entry* found = archive.next()) {
    Item item{.path = name_of(found), .position = position++};
    const std::uint64_t size = size_of(found);
    if (position > limits.entries) listing.fault = too_many(limits);
    if (size > limits.unpacked || is_bomb(bytes.size(), unpacked += size, limits) ||
        is_bomb(bytes.size(), archive.unpacked(), limits))
      listing.fault =
          fmt::format("unpacks to far more than its {} KiB; is it a zip bomb?", (bytes.size() >> 10U) + 1);
    if (!listing.fault.empty()) return listing;
    if (::archive_entry_filetype(found) == AE_IFDIR) continue;
    item.refused = refuse_or_clean(item.path);
    if (item.refused.empty()) item.refused = refuse_kind(found, limits);
    item.size = size;
    listing.items.push_back(std::move(item));
  }
  listing.fault = archive.fault();
  // libarchive before 3.8 calls a zip without files broken.
  if (position == 0 && bytes.starts_with("PK\x05\x06"))
    listing.fault.clear();
  else if (position == 0 && !begins_as_zip(bytes) && !is_gzip(bytes))
    listing.fault = "is a broken archive, or none: hand in a folder, a .zip or a .tar.gz";
  return listing;
}

void read_archive(const Entry& entry, std::string_view bytes, const std::set<const Item*>& wanted,
                  std::size_t most, Submission& submission, const Take& take) {
  Archive archive(entry, bytes);
  std::map<std::size_t, const Item*> missing;
  for (const Item* item : wanted) missing[item->position] = item;
  for (std::size_t position = 0; !missing.empty() && archive.next() != nullptr; ++position) {
    const auto found = missing.extract(position);
    if (found.empty()) continue;
    std::string content = archive.data(most);
    if (!archive.fault().empty()) break;
    take(*found.mapped(), std::move(content));
  }
  submission.fault = archive.fault();
}

/// Why a file is no archive that we open, or "".
std::string refuse_archive(const Entry& entry, const UnpackLimits& limits) {
  if (fs::is_symlink(entry.path))
    return "is a symbolic link, which is not followed: put the folder or the archive itself there";
  if (entry.kind == Entry::Kind::other) return "is not a folder, a .zip or a .tar.gz file";
  std::error_code error;
  const std::uintmax_t size = fs::file_size(entry.path, error);
  if (error) throw Error::failed(fmt::format("cannot open: {}", error.message()), {entry.path.string()});
  if (size > limits.archive)
    return fmt::format("is larger than {} MiB; hand in only the labs' sources and shaders",
                       limits.archive >> 20U);
  return {};
}

}  // namespace

Listing list(const Entry& entry, const UnpackLimits& limits) {
  if (entry.kind == Entry::Kind::folder) {
    Listing listing;
    std::size_t room = limits.entries;
    list_folder(open_folder(entry), "", "", 0, limits, room, listing);
    return listing;
  }
  if (const std::string fault = refuse_archive(entry, limits); !fault.empty()) return {{}, fault};
  if (fs::is_empty(entry.path)) return {};
  return list_archive(entry, MappedFile(entry.path).bytes(), limits);
}

void read(const Entry& entry, const std::set<const Item*>& wanted, const UnpackLimits& limits,
          Submission& submission, const Take& take) {
  // A file may be larger than the disk or a zip said.
  const auto take_small = [&](const Item& item, std::string bytes) {
    if (bytes.size() > limits.file)
      submission.ignored.push_back({item.path, too_large(limits)});
    else
      take(item, std::move(bytes));
  };
  if (entry.kind == Entry::Kind::folder)
    read_folder(entry, wanted, limits.file + 1, submission, take_small);
  else
    read_archive(entry, MappedFile(entry.path).bytes(), wanted, limits.file + 1, submission, take_small);
}

}  // namespace texel::grade
