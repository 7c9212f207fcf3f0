// SPDX-License-Identifier: MIT
#include "text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>

namespace texel::mesh {

LineReader::LineReader(std::string_view text) : text_(text) {
  if (text_.starts_with("\xEF\xBB\xBF")) position_ = 3;
}

std::string_view LineReader::physical_line() {
  const std::size_t begin = position_;
  if (newline_ < begin || begin == 0) newline_ = std::min(text_.find('\n', begin), text_.size());
  // Lines of CR alone lie many before one '\n': that is why it is remembered.
  const std::size_t end =
      begin + std::min(text_.substr(begin, newline_ - begin).find('\r'), newline_ - begin);
  position_ = end;
  if (position_ < text_.size()) {
    const bool crlf = text_[end] == '\r' && end + 1 < text_.size() && text_[end + 1] == '\n';
    position_ += crlf ? 2 : 1;
  }
  ++lines_read_;
  return text_.substr(begin, end - begin);
}

bool LineReader::next(std::string_view& line) {
  if (position_ >= text_.size()) return false;
  line = physical_line();
  line_number_ = lines_read_;
  const auto goes_on = [](std::string_view part) {
    while (!part.empty() && is_blank(part.back())) part.remove_suffix(1);
    return !part.empty() && part.back() == '\\';
  };
  if (!goes_on(line)) return true;
  // Only here, for the rare long line: a comment that happens to end in '\' does not go on.
  std::string_view copy = line;
  if (take_word(copy).empty()) return true;
  joined_.assign(line);
  while (goes_on(joined_)) {
    joined_[joined_.rfind('\\')] = ' ';
    if (position_ >= text_.size()) break;
    joined_.append(physical_line());
  }
  line = joined_;
  return true;
}

std::string_view rest_of_line(std::string_view line) {
  while (!line.empty() && is_blank(line.front())) line.remove_prefix(1);
  while (!line.empty() && is_blank(line.back())) line.remove_suffix(1);
  return line;
}

std::string_view without_comment(std::string_view name) {
  for (std::size_t i = name.size(); i-- > 0;)
    if (name[i] == '#' && (i == 0 || is_blank(name[i - 1]))) return rest_of_line(name.substr(0, i));
  return name;
}

std::string lower(std::string_view word) {
  std::string text(word);
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

namespace {

/// Whether the number that is all of `word` lies below 1, told from the place of its first digit that is not
/// 0.
bool is_below_one(std::string_view word) {
  const std::size_t exponent_at = std::min(word.find_first_of("eE"), word.size());
  const std::string_view digits = word.substr(0, exponent_at);
  const auto point = static_cast<std::int64_t>(std::min(digits.find('.'), digits.size()));
  const std::size_t found = digits.find_first_of("123456789");
  if (found == std::string_view::npos) return true;
  const auto first = static_cast<std::int64_t>(found);
  const std::int64_t power = first < point ? point - first - 1 : point - first;  // of ten, of that digit
  std::string_view text = word.substr(std::min(exponent_at + 1, word.size()));
  const bool negative = text.starts_with('-');
  if (negative || text.starts_with('+')) text.remove_prefix(1);
  std::int64_t exponent = 0;
  if (!text.empty() && std::from_chars(text.data(), text.data() + text.size(), exponent).ec != std::errc{})
    return negative;  // larger than any file is long
  return negative ? power < exponent : power < -exponent;
}

/// NaN and infinity as the runtimes of C, C++, .NET, Java and others print them; of Microsoft's 1.#QNAN and
/// 1.#INF also what is left when they were rounded to fewer digits. `word` is without a '+'.
bool names_not_finite(std::string_view word) {
  if (word.starts_with('-')) word.remove_prefix(1);
  if (word.starts_with("1.#")) return true;
  // The names begin with none of these; numbers with exponents are common.
  if (word.empty() || word[0] == '.' || (word[0] >= '0' && word[0] <= '9')) return false;
  const std::string text = lower(word);
  const auto is = [&text](const char* name) { return text == name; };
  return text.starts_with("nan(") || is("nan") || is("nanq") || is("nans") || is("inf") || is("infinity") ||
         is("\xE2\x88\x9E");  // the sign of infinity
}

/// parse_float of a number in C's spelling, without a '+'.
NumberStatus parse_usual(std::string_view word, float& value) {
  const char* end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  const bool repaired =
      end - stop > 1 && (*stop == '+' || *stop == '-') && (stop[1] == 'e' || stop[1] == 'E');
  if (error == std::errc::invalid_argument || (stop != end && !repaired)) return NumberStatus::malformed;
  if (error == std::errc::result_out_of_range) {
    // Too large or too small: the wider type tells which, and rounds to 0 or a denormal.
    long double wide = 0.0L;
    if (std::from_chars(word.data(), stop, wide).ec != std::errc{}) {
      if (!is_below_one(word.substr(0, static_cast<std::size_t>(stop - word.data()))))
        return NumberStatus::not_finite;
      wide = word[0] == '-' ? -0.0L : 0.0L;
    }
    value = static_cast<float>(wide);
  }
  if (!std::isfinite(value)) return NumberStatus::not_finite;
  return repaired ? NumberStatus::repaired : NumberStatus::ok;
}

}  // namespace

NumberStatus parse_float(std::string_view word, float& value) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  if (names_not_finite(word)) return NumberStatus::not_finite;
  const NumberStatus status = parse_usual(word, value);
  if (status != NumberStatus::malformed) return status;
  std::string usual(word);
  for (char& c : usual) c = c == ',' ? '.' : c == 'd' || c == 'D' ? 'e' : c;
  const NumberStatus repaired = parse_usual(usual, value);
  return repaired == NumberStatus::ok ? NumberStatus::repaired : repaired;
}

std::string for_message(std::string_view word) {
  std::string text = "'";
  for (const char c : word.substr(0, 40)) text += c >= ' ' && c < '\x7f' ? c : '?';
  return text + (word.size() > 40 ? "…'" : "'");
}

}  // namespace texel::mesh
