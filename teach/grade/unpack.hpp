// SPDX-License-Identifier: MIT
// The steps of unpack().
#pragma once
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "grade/submission.hpp"

namespace texel::grade {

/// A file of a submission; folders are not listed.
struct Item {
  std::string path;          ///< text with '/', without '.' and empty parts; as it is when refused
  std::string refused = {};  ///< why it can never be taken, or ""
  std::size_t position = 0;  ///< in an archive, among all of its entries
  std::string place = {};    ///< in a folder, the path from there, in the disk's own bytes
  std::uint64_t size = 0;    ///< bytes, by the word of the disk or the archive
};

struct Listing {
  std::vector<Item> items;
  std::string fault;  ///< why the submission cannot be taken at all, or ""
};

/// What is in a submission.
Listing list(const Entry& entry, const UnpackLimits& limits);

using Take = std::function<void(const Item& item, std::string bytes)>;

/// Gives the bytes of these items of the submission's list, one after the other. What turned out too large is
/// ignored by `submission`; its fault is set when the archive is broken.
void read(const Entry& entry, const std::set<const Item*>& wanted, const UnpackLimits& limits,
          Submission& submission, const Take& take);

// --- Older files -------------------------------------------------------------------------------------------
// Those that held steps in starters before steps lay in labs and shaders alone. Students may still hand them
// in.

/// The older files of which a step lies in one of these files now.
std::set<std::string> older_files(const std::vector<std::string>& allowed);

/// The steps that a student began in the text of an allowed or older file: those whose markers the text has
/// and whose code is not the starter's. One without a marker may be another file of that name.
std::set<std::string> begun_steps(const std::string& file, const std::string& text,
                                  const FirstText& first_text);

/// Takes the steps that were begun in older files into the files that have them now, and the older files out
/// of `files`. What is begun in a file of today stays. Says in `ignored` what became of each older file.
void take_older_steps(Submission& submission, const std::vector<std::string>& allowed,
                      const FirstText& first_text);

}  // namespace texel::grade
