// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <map>
#include <mutex>
#include <string>
#include <utility>

#include "image/image.hpp"

/// Case pictures as data URLs. Students' files are read by common/image and written anew, so that nothing of
/// their bytes reaches a browser.
namespace texel::reports {

/// A picture that stands in a page.
struct Picture {
  std::string problem;  ///< why there is none, as a sentence, or ""
  int width = 0, height = 0;
  std::string url = {};  ///< an RGB PNG: as one sees it
  /// Of a data view, its numbers: a grey PNG of 3 x channels planes one below the other, for each channel the
  /// upper, middle and lower byte of `upper24`. "" for colour pictures, whose numbers the PNG has.
  std::string values = {};
  int channels = 0;  ///< of the numbers
};

/// How much of a picture a page shows: with its numbers, to be compared; as a picture; in half its size.
enum class Shown { with_numbers, plain, small, not_at_all };

/// The upper 24 of a float's 32 bits, rounded to nearest: 16 digits of mantissa, so that a number is at most
/// 2^-16 of itself off, and a direction 0.001 degrees, 50 times less than the smallest limit. NaN stays NaN
/// and infinity infinity. The lowest byte is noise, which would make a page half as large again.
std::uint32_t upper24(float value);

/// Reads pictures of a results' folder. May be used by several threads.
class Pictures {
 public:
  explicit Pictures(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// The picture at a path relative to the folder. Beyond 1024 pixels a side it is only said to be too large.
  [[nodiscard]] Picture read(const std::string& path, const std::string& view,
                             Shown shown = Shown::with_numbers) const;
  /// Of two vertex streams the first, with a mark at each vertex that the other one does not have.
  [[nodiscard]] Picture stream(const std::string& path, const std::string& other) const;
  /// As read, kept for the next student.
  const Picture& reference(const std::string& path, const std::string& view,
                           Shown shown = Shown::with_numbers);

 private:
  struct Reference {
    std::once_flag once;
    Picture picture;
  };

  std::filesystem::path folder_;
  std::mutex mutex_;  ///< of references_
  std::map<std::pair<std::string, Shown>, Reference> references_;
};

}  // namespace texel::reports
