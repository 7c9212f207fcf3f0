// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>
#include <string_view>

namespace texel::mesh {

/// The logical lines of a text: ended by LF, CRLF or CR, joined where one ends in '\' (not in a comment), a
/// byte order mark skipped. Views are into the text, or for a joined line into a buffer until the next call.
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
  std::size_t position_ = 0;
  std::uint64_t line_number_ = 0;
  std::uint64_t lines_read_ = 0;
  std::string joined_;
};

inline bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\v' || c == '\f';
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

/// The rest of a line without blanks around it and without a comment.
std::string_view rest_of_line(std::string_view line);

enum class NumberStatus { ok, malformed, not_finite, too_large };

/// The float32 nearest to the number that is the whole of `word`; a leading '+' is fine. Numbers too small
/// for float32 become 0 or denormal.
NumberStatus parse_float(std::string_view word, float& value);

/// A word for a message: cut to 40 bytes, unprintable ones as '?'.
std::string for_message(std::string_view word);

}  // namespace texel::mesh
