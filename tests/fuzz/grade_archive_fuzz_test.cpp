// SPDX-License-Identifier: MIT
// Thousands of spoilt archives: whatever the bytes, unpacking ends with files of the allowed names or a
// fault. The mutations come from a hash of their number, so that a failure repeats.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "../support/archives.hpp"
#include "../support/picture_files.hpp"
#include "../support/spoilt.hpp"
#include "core/files.hpp"
#include "grade/submission.hpp"

namespace texel::grade {
namespace {

using test::Format;
using test::Random;

/// A few changes of bytes, and often a signature or number that the formats look for.
std::string spoilt(const std::string& archive, Random& random) {
  using namespace std::string_literals;
  static const std::vector<std::string> pieces = {
      "PK\x03\x04", "PK\x01\x02", "PK\x05\x06", "PK\x07\x08",  "\xFF\xFF\xFF\xFF",
      "\0\0\0\0"s,  "../",        "/",          "ustar",       "77777777777",
      "x",          "L",          "S",          "11 path=/a\n"};
  std::string bytes = test::mutated(archive, random);
  const std::string& piece = pieces[random.below(pieces.size())];
  if (random.below(2) == 0 && bytes.size() > piece.size())
    bytes.replace(random.below(bytes.size() - piece.size()), piece.size(), piece);
  return bytes;
}

TEST(ArchiveFuzz, gives_allowed_files_or_a_fault_when_bytes_are_spoilt) {
  const test::TemporaryFolder folder;
  const std::vector<std::string> step_files = {"labs/05_normal_map/lab.cpp", "shaders/lib/light.glsl"};
  const std::vector<test::Packed> files = {{"work/labs/05_normal_map/lab.cpp", std::string(3000, 'x')},
                                           {"work/shaders/lib/light.glsl", "short"},
                                           {std::string(150, 'n'), "a long name"},
                                           {"work/link", "", AE_IFLNK, "/etc/passwd"}};
  const std::string zip = test::pack(Format::zip, files);
  const std::string tar = test::pack(Format::tar, files);
  int whole = 0;
  int faults = 0;
  for (std::uint64_t i = 0; i < 3000; ++i) {
    Random random(i);
    const bool is_zip = i % 2 == 0;
    SCOPED_TRACE(i);
    Entry entry;
    entry.kind = is_zip ? Entry::Kind::zip : Entry::Kind::tar;
    entry.path = folder / ("spoilt" + std::to_string(i));
    write_file(entry.path, spoilt(is_zip ? zip : tar, random));
    const Submission submission = unpack(entry, step_files, [](const std::string&) { return std::string(); });
    std::filesystem::remove(entry.path);
    EXPECT_TRUE(submission.fault.empty() || submission.files.empty());
    for (const auto& [path, bytes] : submission.files) {
      EXPECT_TRUE(std::find(step_files.begin(), step_files.end(), path) != step_files.end()) << path;
      EXPECT_LE(bytes.size(), 1U << 20U);
    }
    whole += submission.files.size() == step_files.size() ? 1 : 0;
    faults += submission.fault.empty() ? 0 : 1;
  }
  // Neither side may be empty, or the mutations would test nothing.
  EXPECT_GT(whole, 300);
  EXPECT_GT(faults, 300);
}

}  // namespace
}  // namespace texel::grade
