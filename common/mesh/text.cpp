// SPDX-License-Identifier: MIT
#include "text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "core/plain_text.hpp"

namespace texel::mesh {

LineReader::LineReader(std::string_view text)
    : text_(text), end_of_line_(text.find('\n') == std::string_view::npos ? '\r' : '\n') {
  if (text_.starts_with("\xEF\xBB\xBF")) position_ = 3;
}

std::string_view LineReader::physical_line() {
  const std::size_t end = std::min(text_.find(end_of_line_, position_), text_.size());
  std::string_view line = text_.substr(position_, end - position_);
  while (line.ends_with('\r')) line.remove_suffix(1);
  position_ = std::min(end + 1, text_.size());
  ++lines_read_;
  return line;
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

std::string_view longest_known(std::string_view name, const std::function<bool(std::string_view)>& known) {
  if (known(name)) return name;
  for (std::size_t i = name.size(); i-- > 0;)
    if (name[i] == '#' && (i == 0 || is_blank(name[i - 1])))
      if (const std::string_view cut = trimmed(name.substr(0, i)); known(cut)) return cut;
  return name;
}

namespace {

/// parse_float of a number in C's spelling, without a '+'.
NumberStatus parse_usual(std::string_view word, float& value) {
  const char* end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  const bool repaired =
      end - stop > 1 && (*stop == '+' || *stop == '-') && (stop[1] == 'e' || stop[1] == 'E');
  if (error == std::errc::invalid_argument || (stop != end && !repaired)) return NumberStatus::malformed;
  // Too large becomes infinity, and too small 0 or a denormal.
  if (error == std::errc::result_out_of_range)
    value = std::strtof(std::string(word.data(), stop).c_str(), nullptr);
  if (!std::isfinite(value)) return NumberStatus::not_finite;
  return repaired ? NumberStatus::repaired : NumberStatus::ok;
}

/// NaN and infinity as only some runtimes print them; of Microsoft's 1.#QNAN and 1.#INF also what is left
/// when they were rounded to fewer digits.
bool names_not_finite(std::string_view word) {
  if (word.starts_with('-')) word.remove_prefix(1);
  const std::string text = lower_case(word);
  return text.starts_with("1.#") || text == "nanq" || text == "nans" || text == "\xE2\x88\x9E";
}

}  // namespace

NumberStatus parse_float(std::string_view word, float& value) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  NumberStatus status = parse_usual(word, value);
  if (status == NumberStatus::malformed && names_not_finite(word)) status = NumberStatus::not_finite;
  if (status == NumberStatus::malformed) {
    std::string usual(word);
    for (char& c : usual) c = c == ',' ? '.' : c == 'd' || c == 'D' ? 'e' : c;
    status = parse_usual(usual, value);
    if (status == NumberStatus::ok) status = NumberStatus::repaired;
  }
  if (status == NumberStatus::not_finite) value = std::numeric_limits<float>::infinity();
  return status;
}

std::string for_message(std::string_view word) {
  std::string text = "'";
  for (const char c : word.substr(0, 40)) text += c >= ' ' && c < '\x7f' ? c : '?';
  return text + (word.size() > 40 ? "…'" : "'");
}

}  // namespace texel::mesh
