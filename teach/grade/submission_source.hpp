// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "grade/submission.hpp"

namespace texel::grade {

/// A file of a submission; folders are not listed.
struct Item {
  std::string path;        ///< text with '/', without '.' and empty parts; as it is when refused
  std::string refused;     ///< why it can never be taken, or ""
  std::size_t position;    ///< among all that was listed, folders too
  std::string place = {};  ///< of a file in a folder: its path from there, in the disk's own bytes
  std::uint64_t size = 0;  ///< bytes, by the word of the disk or the archive
};

struct Listing {
  std::vector<Item> items;
  std::string fault;  ///< why the submission cannot be taken at all, or ""
};

/// What is in a submission.
Listing list(const Entry& entry, const UnpackLimits& limits);

/// Gives the bytes of the items at these positions, one after the other. What turned out too large is
/// ignored by `submission`; its fault is set when the archive is broken.
void read(const Entry& entry, const std::set<std::size_t>& wanted, const UnpackLimits& limits,
          Submission& submission, const std::function<void(std::size_t, std::string)>& take);

}  // namespace texel::grade
