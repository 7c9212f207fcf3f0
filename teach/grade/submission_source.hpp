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

}  // namespace texel::grade
