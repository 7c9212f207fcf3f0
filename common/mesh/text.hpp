// SPDX-License-Identifier: MIT
#pragma once
#include <bit>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace texel::mesh {

/// The logical lines of a text: ended by LF or CRLF, or all by CR; joined where one ends in '\' (not in a
/// comment; blanks may follow it), a byte order mark skipped. Views are into the text, or for a joined line
/// into a buffer until the next call.
class LineReader {
 public:
  explicit LineReader(std::string_view text);
  /// The next line without its end; false when there is none.
  bool next(std::string_view& line);
  /// The number of the last line, or of its first part when joined; from 1.
  [[nodiscard]] std::uint64_t line_number() const { return line_number_; }
  [[nodiscard]] std::uint64_t lines_read() const { return lines_read_; }
  [[nodiscard]] std::size_t bytes_read() const { return position_; }

 private:
  std::string_view physical_line();

  std::string_view text_;
  char end_of_line_;
  std::size_t position_ = 0;
  std::uint64_t line_number_ = 0;
  std::uint64_t lines_read_ = 0;
  std::string joined_;
};

inline bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

/// Moves `at` to the next word; false at the end and at a word that begins with '#'.
inline bool skip_blanks(const char*& at, const char* end) {
  while (at != end && is_blank(*at)) ++at;
  return at != end && *at != '#';
}

/// Takes the next word off the front of `line`; "" at its end and at a word that begins with '#'.
inline std::string_view take_word(std::string_view& line) {
  std::size_t begin = 0;
  while (begin < line.size() && is_blank(line[begin])) ++begin;
  std::size_t end = begin;
  while (end < line.size() && !is_blank(line[end])) ++end;
  std::string_view word = line.substr(begin, end - begin);
  if (!word.empty() && word[0] == '#') {
    line = {};
    return {};
  }
  line.remove_prefix(end);
  return word;
}

/// What a name means that runs to its line's end: the longest that is `known` of the name and of what is left
/// of it without words from a '#' on, which may be a comment; the name itself if none is.
std::string_view longest_known(std::string_view name, const std::function<bool(std::string_view)>& known);

enum class NumberStatus { ok, repaired, malformed, not_finite };

/// The float32 nearest to the number that is the whole of `word`; a leading '+' is fine. Numbers too small
/// for float32 become 0 or denormal. `repaired`: the sign of an exponent stands before its e (3.1+e2): the
/// number in front of it (3.1), as programs read it that stop at what they do not know; a decimal comma
/// (1,5); Fortran's exponent (1.5D+2). `not_finite`: NaN and infinity in every runtime's spelling (nan(ind),
/// -1.#IND, Infinity), and what is beyond float32; the value is infinity then.
NumberStatus parse_float(std::string_view word, float& value);

/// Takes a number of digits with or without a point, such as -12.345, off the front of [at, end); false, and
/// nothing taken, when there is something else or more digits than fit: then parse_float knows. The nearest
/// float32 as there. Without it a large file takes a fifth longer, and loads less than three times as fast as
/// by tinyobjloader.
inline bool take_plain_number(const char*& at, const char* end, float& value) {
  constexpr std::int64_t largest = std::int64_t{1} << 53;  // integers up to here are doubles, as these powers
  static constexpr double powers[] = {1e0, 1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7, 1e8,
                                      1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16};
  const char* next = at;
  const bool negative = next != end && *next == '-';
  if (negative) ++next;
  const char* const first = next;
  const char* const limit = end - next > 17 ? next + 17 : end;  // 16 digits and a point
  std::int64_t digits = 0;
  const auto take_digits = [&] {
    for (; next != limit && *next >= '0' && *next <= '9'; ++next) digits = 10 * digits + (*next - '0');
  };
  take_digits();
  std::ptrdiff_t behind_point = 0, count = next - first;
  if (next != limit && *next == '.') {
    const char* const point = next++;
    take_digits();
    behind_point = next - point - 1;
    count += behind_point;
  }
  if (count == 0 || count > 16 || digits > largest || (next != end && !is_blank(*next))) return false;
  // The quotient of two exact doubles is the double nearest to the number. It is 0 or 1e-16 and more, where a
  // float has 29 bits less, and each middle between two floats is a double: so the number lies on the same
  // side of it as the quotient and has the same nearest float, unless the quotient is such a middle itself.
  const double quotient = static_cast<double>(digits) / powers[behind_point];
  if ((std::bit_cast<std::uint64_t>(quotient) & 0x1FFFFFFF) == 0x10000000) return false;
  value = static_cast<float>(negative ? -quotient : quotient);
  at = next;
  return true;
}

/// A word for a message: cut to 40 bytes, unprintable ones as '?'.
std::string for_message(std::string_view word);

}  // namespace texel::mesh
