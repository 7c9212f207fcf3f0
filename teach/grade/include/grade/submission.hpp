// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "store/class_results.hpp"

/// What students hand in: found in a class folder, opened without trust, and laid over a tree that is
/// trusted.
namespace texel::grade {

/// One student's entry in a class folder.
struct Entry {
  enum class Kind { folder, zip, tar, other };

  std::filesystem::path path;  ///< a folder, or a file
  Kind kind = Kind::other;     ///< `other`: cannot be unpacked, but its student is not forgotten
  std::string id;  ///< unique in the class; a-z, 0-9, '-' and '_', begins with a letter or digit, at most 100
  std::string name;    ///< the student's name as text: UTF-8 without control characters, to be escaped as any
  std::string number;  ///< the student's number in the LMS (Canvas's user, Moodle's participant), or ""
};

/// The entries of a class folder, in the order of their names' bytes: every folder and file whose name does
/// not begin with a point.
///
/// | file name                                              | name           | number | id                |
/// |--------------------------------------------------------|----------------|--------|-------------------|
/// | `doejane_12345_678_labs.zip` (Canvas)                  | `doejane`      | 12345  | `doejane-12345`   |
/// | `doejane_LATE_12345_678_labs.zip` (Canvas)             | `doejane`      | 12345  | `doejane-12345`   |
/// | `Jane Doe_1234_assignsubmission_file` (Moodle, folder) | `Jane Doe`     | 1234   | `jane-doe-1234`   |
/// | `Jane Doe_1234_assignsubmission_file_labs.zip`         | `Jane Doe`     | 1234   | `jane-doe-1234`   |
/// | `jane.tar.gz` or any other                             | `jane`         |        | `jane`            |
///
/// In an id capitals are made small and all but a-z, 0-9, '-' and '_' becomes '-'. Where that loses something
/// and there is no number, and where two entries would get the same id, eight hexadecimal digits follow: a
/// hash of the file name. So an id depends on nothing but the entry's own name, unless one student has two.
///
/// A folder with nothing but one archive in it, as Moodle makes them, counts as that archive. Throws Error
/// (exit 3) when the class folder cannot be read.
std::vector<Entry> read_class(const std::filesystem::path& folder);

/// What a submission may cost. Sizes are in bytes.
struct UnpackLimits {
  std::uint64_t archive = 256U << 20U;   ///< of the archive itself
  std::uint64_t unpacked = 512U << 20U;  ///< of all that is in an archive, by its own word
  std::uint64_t ratio = 200;             ///< unpacked to packed, for archives of more than 16 MiB unpacked
  std::uint64_t file = 1U << 20U;        ///< of a file that is taken
  std::size_t entries = 10'000;          ///< files and folders
};

/// The text of an allowed file in the starter.
using FirstText = std::function<std::string(const std::string& file)>;

struct Submission {
  std::map<std::string, std::string> files;    ///< by path in the tree: what was taken
  std::vector<store::Ignored> ignored;         ///< in the submission's order
  std::map<std::string, std::uint64_t> sizes;  ///< of the files of `ignored`, by their own word
  /// The folder of the submission that stands for the tree's root, as text; "" for the top.
  std::string root;
  std::vector<store::Ignored> copies;  ///< folders with another copy of the labs, which was not taken
  std::string fault;      ///< why nothing was taken (empty, broken, a bomb, too large, no step), or ""
  bool is_empty = false;  ///< no file was handed in
};

/// Takes the allowed files out of a submission, into memory. Whatever the bytes, this ends with a Submission:
/// what is wrong with them is `fault` or the reason of an ignored file. Throws Error (exit 3) only when the
/// entry cannot be read from the disk.
///
/// **Root.** Students pack the tree, the folder around it, or only a lab's folder. Below a root, a file
/// stands for an allowed one when its path is the last part of that one's path and of no other's:
/// `labs/05_normal_map/lab.cpp` below the whole tree, `05_normal_map/lab.cpp` below `labs`, `fresnel.glsl`
/// alone. The root is the folder with the most steps begun in such files, as `first_text` tells where several
/// files stand for one; of several the one with the most such files, then the least deep, then the first by
/// bytes. What stands for a file alone in the whole submission is taken wherever it lies. Of several below
/// the root the longer path is taken, and of equal paths the later, as tar does. Each other copy of the labs
/// is in `copies`, with the number of its steps begun.
///
/// **Names** may be in any encoding, and the locale does not matter: bytes that are no UTF-8 become U+FFFD in
/// the text of a path. Files with steps have ASCII names.
///
/// **Older starters** had steps in other files too: in `common/mesh` and `shaders/lib`. Such a file is read,
/// and its steps are taken into the files that have them now; `ignored` says so.
///
/// **Never taken**: links, devices, encrypted files, paths that are absolute or contain `..`, names with
/// control characters, files over the limit, hidden folders, archives in the archive. Capitals do not matter
/// where one file alone is meant. Each that is not taken is in `ignored`. Nothing is followed. In a folder, a
/// hard link is a file as any other.
Submission unpack(const Entry& entry, const std::vector<std::string>& allowed, const FirstText& first_text,
                  const UnpackLimits& limits = {});

/// Makes the tree `to` out of the trusted tree with the files laid over it. The trusted files are hard links
/// where the file system can, else copies: mount `to` read-only. The trusted tree must be a starter, never a
/// solution, so that what a student left out earns nothing. Throws Error (exit 3) when `to` holds something
/// already, when the trusted tree has links or devices, when a path of `files` leaves the tree, and when
/// writing fails.
void overlay(const std::filesystem::path& trusted_tree, const std::map<std::string, std::string>& files,
             const std::filesystem::path& to);

/// Makes the folder `root`, in which a lab's program finds shaders and assets: the trusted tree's, with those
/// of the files that are shaders laid over it. Throws as overlay.
void make_root(const std::filesystem::path& trusted_tree, const std::map<std::string, std::string>& files,
               const std::filesystem::path& root);

}  // namespace texel::grade
