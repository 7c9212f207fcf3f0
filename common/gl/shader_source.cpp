// SPDX-License-Identifier: MIT
#include "gl/shader_source.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <sstream>

#include "core/files.hpp"
#include "core/plain_text.hpp"

namespace texel::gl {
namespace {

constexpr int kLinesPerFile = 100000;

/// A line with a blank for each mark of a comment in it. `in_comment` is whether it begins in a comment of
/// several lines, and afterwards whether it ends in one.
std::string without_comments(std::string_view line, bool& in_comment) {
  std::string code;
  for (std::size_t at = 0; at < line.size(); ++at) {
    const std::string_view two = line.substr(at, 2);
    if (two == (in_comment ? "*/" : "/*")) {
      in_comment = !in_comment;
      code += ' ';
      ++at;
    } else if (!in_comment) {
      if (two == "//") break;
      code += line[at];
    }
  }
  return code;
}

/// A directive's name and the rest of its line, such as "include" and "\"lib/light.glsl\"". The name is empty
/// for any other line.
std::pair<std::string_view, std::string_view> directive(std::string_view code) {
  code = trimmed(code);
  if (!code.starts_with('#')) return {};
  code = trimmed(code.substr(1));
  const auto end =
      static_cast<std::size_t>(std::find_if_not(code.begin(), code.end(), is_word) - code.begin());
  return {code.substr(0, end), trimmed(code.substr(end))};
}

/// Defined where a file was taken, with its number behind it.
constexpr std::string_view kTaken = "TEXEL_INCLUDED_";
/// Each may be taken in several branches, in which others are too: so many are no shader.
constexpr int kMostIncludes = 1000;

/// The first number in a line of a compiler's log that is one of ours, and where it ends: "0:200012(5):
/// error: …" (Mesa) and "0(200012) : error …" (others). 0 where there is none.
std::pair<int, std::size_t> first_mark(std::string_view line) {
  for (std::size_t at = 0; at < line.size(); ++at) {
    if (at > 0 && is_word(line[at - 1])) continue;
    int number = 0;
    const char* end = std::from_chars(line.data() + at, line.data() + line.size(), number).ptr;
    if (number >= kLinesPerFile) return {number, static_cast<std::size_t>(end - line.data())};
  }
  return {};
}

/// Compilers find a missing ';' at the next token. Mesa and NVIDIA say "syntax error, unexpected RETURN,
/// expecting ',' or ';'", and ANGLE "'return' : syntax error".
bool may_lack_semicolon(std::string_view message) {
  const auto has = [&](std::string_view text) { return message.find(text) != std::string_view::npos; };
  return has("syntax error") && (has("';'") || !has("expecting"));
}
constexpr const char* kLacksSemicolon = " (is a ';' missing at the end of the line before?)";

}  // namespace

struct ShaderSource::Reading {
  std::vector<std::size_t> open;  ///< the files that include each other, from the outermost on
  std::vector<bool> taken;        ///< by file: whether its text stands above, and not in a branch of #if
  int includes = 0;
};

ShaderSource::ShaderSource(const std::filesystem::path& root, const std::filesystem::path& file)
    : ShaderSource(root, file.string(), read_file(root / file)) {}

ShaderSource::ShaderSource(const std::filesystem::path& root, const std::string& name,
                           const std::string& text)
    : root_(root.lexically_normal()) {
  Reading reading;
  files_.push_back((root_ / name).lexically_normal());
  reading.taken.push_back(true);
  expand(reading, 0, text, false);
  if (version_.empty())
    throw Error::failed("the shader has no #version", {shown_name(files_.front()), 1},
                        "start it with '#version 330 core'");
  for (auto end = body_.cbegin(); end != body_.cend();) {
    const auto begin = std::find_if(end, body_.cend(), is_word);
    end = std::find_if_not(begin, body_.cend(), is_word);
    words_.emplace(begin, end);
  }
}

std::string ShaderSource::shown_name(const std::filesystem::path& file) const {
  return (root_.filename() / file.lexically_relative(root_)).lexically_normal().string();
}

void ShaderSource::expand(Reading& reading, std::size_t file, std::string_view text, bool may_be_left_out) {
  reading.open.push_back(file);
  const auto mark = [&](int line) {
    body_ += fmt::format("#line {}\n", (static_cast<int>(file) + 1) * kLinesPerFile + line);
  };
  mark(1);
  // Editors of Windows put a byte-order mark before the first line; a compiler of GLSL does not know it.
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  int branches = 0, number = 0;  // of #if that are open; of the line
  bool in_comment = false;
  for (const std::string& line : lines_of(text)) {
    ++number;
    const std::string code = without_comments(line, in_comment);
    const auto [name, rest] = directive(code);
    if (name == "include") {
      include(reading, rest, {shown_name(files_[file]), number}, may_be_left_out || branches > 0);
      mark(number + 1);
    } else if (name == "version" || name == "line") {
      if (name == "version" && version_.empty()) version_ = fmt::format("#version {}\n", rest);
      body_ += '\n';
    } else {
      // Only our marks may begin so, even in a comment.
      body_.append(line.starts_with("#line ") ? " " : "").append(line).append("\n");
    }
    if (name.starts_with("if")) ++branches;
    if (name == "endif") --branches;
    // In a branch that is left out the compiler skips our #line marks too.
    if (name == "else" || name == "elif" || name == "endif") mark(number + 1);
  }
  reading.open.pop_back();
}

void ShaderSource::include(Reading& reading, std::string_view rest, const Place& place,
                           bool may_be_left_out) {
  const auto fault = [&](const std::string& what, const std::string& remedy = {}) {
    if (!fault_) fault_ = Error::failed(what, place, remedy);
  };
  const std::size_t end = rest.find('"', 1);
  if (!rest.starts_with('"') || end == std::string_view::npos)
    return fault("this #include names no file", "write it like '#include \"lib/light.glsl\"'");
  const std::string name(rest.substr(1, end - 1));
  std::filesystem::path target = (files_[reading.open.back()].parent_path() / name).lexically_normal();
  if (!std::filesystem::is_regular_file(target)) target = (root_ / name).lexically_normal();
  if (!std::filesystem::is_regular_file(target))
    return fault(fmt::format("there is no file '{}' to include", name),
                 "name a file beside this one or below shaders/");
  const auto file =
      static_cast<std::size_t>(std::find(files_.begin(), files_.end(), target) - files_.begin());
  if (std::find(reading.open.begin(), reading.open.end(), file) != reading.open.end())
    return fault(fmt::format("'{}' includes itself", name));
  if (file == files_.size()) files_.push_back(target), reading.taken.push_back(false);

  if (reading.taken[file]) return;
  if (++reading.includes > kMostIncludes)
    throw Error::failed(fmt::format("more than {} files are included", kMostIncludes), place);
  reading.taken[file] = !may_be_left_out;
  const std::string guard = fmt::format("{}{}", kTaken, file);
  body_ += fmt::format("#ifndef {0}\n#define {0}\n", guard);
  expand(reading, file, read_file(target), may_be_left_out);
  body_ += fmt::format("#endif  // {}\n", guard);
}

std::string ShaderSource::text(const std::vector<Define>& defines) const {
  if (fault_) throw *fault_;
  std::string text = version_;
  for (const Define& define : defines) text += fmt::format("#define {} {}\n", define.name, define.value);
  return text + body_;
}

std::string ShaderSource::readable(const std::vector<Define>& defines,
                                   const std::function<std::string(const std::string&)>& origin) const {
  std::string text = version_;
  for (const Define& define : defines)
    if (mentions(define.name))
      text += fmt::format("#define {} {}  // {}\n", define.name, define.value, define.origin);
  std::size_t shown = 0;
  for (std::string& line : lines_of(body_)) {
    if (line.starts_with("#line ")) {
      // A new file, or the rest of one after an include.
      const auto file = static_cast<std::size_t>(std::stoi(line.substr(6)) / kLinesPerFile);
      if (file != shown) text += fmt::format("// ---- {}\n", shown_name(files_[file - 1]));
      shown = file;
      continue;
    }
    if (line.find(kTaken) != std::string::npos) continue;
    std::istringstream words(line);
    std::string first, type, name;
    words >> first >> type >> name;
    if (first == "uniform") line += "  // " + origin(name.substr(0, name.find_first_of(";[")));
    text += line + "\n";
  }
  return text;
}

std::string ShaderSource::locate(std::string_view log) const {
  constexpr std::string_view kEnds("\n\0", 2);  // drivers end their log with a zero
  std::string result;
  for (std::size_t start = 0; start < log.size();) {
    const std::size_t end = std::min(log.find_first_of(kEnds, start), log.size());
    const std::string_view line = log.substr(start, end - start);
    start = end + 1;
    if (trimmed(line).empty()) continue;
    const auto [number, behind] = first_mark(line);
    const auto file = static_cast<std::size_t>(number / kLinesPerFile);
    if (file == 0 || file > files_.size()) {
      result.append(line).append("\n");
      continue;
    }
    std::string_view rest = line.substr(behind);
    int column = 0;
    if (rest.starts_with('(')) {  // Mesa's column
      const char* close = std::from_chars(rest.data() + 1, rest.data() + rest.size(), column).ptr;
      rest.remove_prefix(static_cast<std::size_t>(close - rest.data()));
    }
    rest.remove_prefix(std::min(rest.find_first_not_of("): "), rest.size()));
    if (rest.starts_with("warning")) continue;
    result += fmt::format("{}:{}:", shown_name(files_[file - 1]), number % kLinesPerFile);
    if (column > 0) result += fmt::format("{}:", column);
    result += fmt::format(" {}{}\n", rest, may_lack_semicolon(rest) ? kLacksSemicolon : "");
  }
  while (result.ends_with('\n')) result.pop_back();
  return result;
}

}  // namespace texel::gl
