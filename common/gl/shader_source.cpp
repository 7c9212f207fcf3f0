// SPDX-License-Identifier: MIT
#include "gl/shader_source.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <iterator>
#include <sstream>

#include "core/files.hpp"
#include "core/plain_text.hpp"

namespace texel::gl {
namespace {

constexpr int kLinesPerFile = 100000;

enum class Comment { none, line, block };

/// A line with a blank for each comment. `open` is the comment in which it begins, and afterwards the one in
/// which it ends.
std::string without_comments(std::string_view line, Comment& open) {
  std::string code;
  while (!line.empty() && open != Comment::line) {
    const bool is_name = line.starts_with('"') && trimmed(code).starts_with('#');  // "a//b.glsl"
    std::size_t end = 1;
    if (open == Comment::block) {
      end = line.find("*/");
      if (end == std::string_view::npos) break;
      end += 2;
      open = Comment::none;
      code += ' ';
    } else if (line.starts_with("/*") || line.starts_with("//")) {
      end = 2;
      open = line[1] == '*' ? Comment::block : Comment::line;
    } else {
      if (is_name) end = std::min(line.find('"', 1), line.size() - 1) + 1;
      code += line.substr(0, end);
    }
    line.remove_prefix(end);
  }
  return code;
}

/// A directive's name and the rest of its line, such as "include" and "\"lib/light.glsl\"". The name is empty
/// for any other line.
struct Directive {
  std::string_view name, rest;
};
Directive directive(std::string_view code) {
  code = trimmed(code);
  if (!code.starts_with('#')) return {};
  code = trimmed(code.substr(1));
  const auto end = static_cast<std::size_t>(std::ranges::find_if_not(code, is_word) - code.begin());
  return {code.substr(0, end), trimmed(code.substr(end))};
}

/// The file that an #include names in quotes or in <>, with '/' between its folders; "" where it names none.
std::string included(std::string_view rest) {
  const std::size_t end =
      rest.size() < 2 ? std::string_view::npos : rest.find(rest.front() == '<' ? '>' : '"', 1);
  if (end == std::string_view::npos || (rest.front() != '<' && rest.front() != '"')) return {};
  std::string name(rest.substr(1, end - 1));
  std::replace(name.begin(), name.end(), '\\', '/');
  return name;
}

/// What the compiler says when it comes to an #include that cannot be followed, with the fault's number
/// behind it. Only the compiler knows which branches it takes.
constexpr std::string_view kFault = "texel_include_";
/// Defined where a file was taken, with its number behind it.
constexpr std::string_view kTaken = "TEXEL_INCLUDED_";
/// Each may be taken in several branches, in which others are too: so many are no shader.
constexpr int kMostIncludes = 1000;

/// The first number in a line of a compiler's log that is one of ours, and where it ends: "0:200012(5):
/// error: …" (Mesa) and "0(200012) : error …" (others). 0 where there is none.
struct Mark {
  int number = 0;
  std::size_t end = 0;
};
Mark first_mark(std::string_view line) {
  for (std::size_t at = 0; at < line.size(); ++at) {
    if (at > 0 && is_word(line[at - 1])) continue;
    int number = 0;
    const char* end = std::from_chars(line.data() + at, line.data() + line.size(), number).ptr;
    if (number >= kLinesPerFile) return {number, static_cast<std::size_t>(end - line.data())};
  }
  return {};
}

/// A line with code, without comments. `number` is what the compiler calls it.
struct CodeLine {
  int number = 0;
  std::string text;
};

std::vector<CodeLine> code_lines(std::string_view text) {
  constexpr std::string_view kMark = "#line ";
  std::vector<CodeLine> all;
  Comment comment = Comment::none;
  int next = 1;
  for (const std::string& line : lines_of(text)) {
    const int number = next++;
    std::string code = without_comments(line, comment);
    if (comment == Comment::line) comment = Comment::none;
    if (line.starts_with(kMark))
      std::from_chars(line.data() + kMark.size(), line.data() + line.size(), next);
    else if (!trimmed(code).empty() && !trimmed(code).starts_with('#'))
      all.push_back({number, std::move(code)});
  }
  return all;
}

/// Whether a statement may end here, and does not by itself.
bool wants_semicolon(std::string_view code) {
  if (code.empty()) return false;
  for (const std::string_view head : {"if", "for", "while", "else", "do", "switch"})
    if (code.starts_with(head) && (code.size() == head.size() || !is_word(code[head.size()])) &&
        (code.ends_with(')') || code == head))
      return false;
  return is_word(code.back()) || code.ends_with(')') || code.ends_with(']') || code.ends_with('}') ||
         code.ends_with("++") || code.ends_with("--");
}

/// Of one line of the log.
std::string at_missing_semicolon(const std::string& line, const std::vector<CodeLine>& code) {
  // Mesa: "0:500012(3): error: syntax error, unexpected RETURN, expecting ',' or ';'". NVIDIA: "0(500012) :
  // error C0000: syntax error, unexpected '}', expecting ',' or ';' at token "}"". ANGLE: "ERROR: 0:500012:
  // '}' : syntax error".
  if (line.find("syntax error") == line.npos) return line;
  const bool says_what = line.find("expecting") != line.npos;
  if (says_what && (line.find("';'") == line.npos || line.find("'{'", line.find("expecting")) != line.npos))
    return line;
  const auto [number, behind] = first_mark(line);
  const auto found = std::ranges::find(code, number, &CodeLine::number);
  if (found == code.begin() || found == code.end()) return line;
  // What was not expected must be the line's first: Mesa gives a column, from 0 or 1, and the others the
  // token.
  bool is_first = false;
  if (line[behind] == '(') {
    std::size_t column = 0;
    std::from_chars(line.data() + behind + 1, line.data() + line.size(), column);
    is_first = found->text.find_first_not_of(" \t\v\f") + 1 >= column;
  } else {
    const std::size_t token = line.find("at token \"");
    const std::size_t from = token != line.npos ? token + 10 : line.find('\'', behind) + 1;
    const std::size_t to = line.find(token != line.npos ? '"' : '\'', from);
    is_first = from != 0 && to != line.npos && to > from &&
               trimmed(found->text).starts_with(line.substr(from, to - from));
  }
  const CodeLine& before = *std::prev(found);
  if (!is_first || !wants_semicolon(trimmed(before.text))) return line;
  return fmt::format("0:{}: error: a ';' is missing at the end of this line: {}", before.number,
                     trimmed(before.text));
}

}  // namespace

struct ShaderSource::Reading {
  std::vector<std::size_t> open;  ///< the files that include each other, from the outermost on
  std::vector<bool> taken;        ///< by file: it stands above, in no branch of #if that may be left out
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
  int branches = 0;         // of #if that are open
  std::string lines, code;  // of a directive, which goes on behind a backslash and in a comment of many lines
  int first = 1, next = 1;
  Comment comment = Comment::none;
  const std::vector<std::string> all = lines_of(text);
  for (std::string_view line : all) {
    ++next;
    // Only ours may begin so, even in a comment.
    lines.append(line.starts_with("#line ") ? " " : "").append(line).append("\n");
    const bool goes_on = line.ends_with('\\');
    if (goes_on) line.remove_suffix(1);
    code += without_comments(line, comment);
    if (comment == Comment::line && !goes_on) comment = Comment::none;
    if ((goes_on || comment != Comment::none) && next <= static_cast<int>(all.size())) continue;

    const auto [name, rest] = directive(code);
    if (name == "include") {
      include(reading, included(rest), {shown_name(files_[file]), first}, may_be_left_out || branches > 0);
      mark(next);
    } else if (name == "version" || name == "line") {
      if (name == "version" && version_.empty()) version_ = fmt::format("#version {}\n", rest);
      body_.append(static_cast<std::size_t>(next - first), '\n');
    } else {
      body_ += lines;
    }
    if (name.starts_with("if")) ++branches;
    if (name == "endif") --branches;
    // In a branch that is left out the compiler skips our #line marks too.
    if (name == "else" || name == "elif" || name == "endif") mark(next);
    lines.clear();
    code.clear();
    first = next;
  }
  reading.open.pop_back();
}

void ShaderSource::include(Reading& reading, const std::string& name, const Place& place,
                           bool may_be_left_out) {
  const auto fault = [&](const std::string& what, const std::string& remedy = {}) {
    body_ += fmt::format("#error {}{}\n", kFault, faults_.size());
    faults_.push_back(Error::failed(what, place, remedy));
  };
  if (name.empty())
    return fault("this #include names no file", "write it like '#include \"lib/light.glsl\"'");
  std::filesystem::path target = (files_[reading.open.back()].parent_path() / name).lexically_normal();
  if (!std::filesystem::is_regular_file(target)) target = (root_ / name).lexically_normal();
  if (!std::filesystem::is_regular_file(target))
    return fault(fmt::format("there is no file '{}' to include", name),
                 "name a file beside this one or below shaders/");
  const auto file = static_cast<std::size_t>(std::ranges::find(files_, target) - files_.begin());
  if (std::ranges::count(reading.open, file) > 0) return fault(fmt::format("'{}' includes itself", name));
  if (file == files_.size()) files_.push_back(target), reading.taken.push_back(false);
  if (reading.taken[file]) return;
  if (++reading.includes > kMostIncludes)
    throw Error::failed(fmt::format("more than {} files are included", kMostIncludes), place);
  reading.taken[file] = !may_be_left_out;
  body_ += fmt::format("#ifndef {0}{1}\n#define {0}{1}\n", kTaken, file);
  expand(reading, file, read_file(target), may_be_left_out);
  body_ += fmt::format("#endif  // {}{}\n", kTaken, file);
}

std::string at_missing_semicolons(std::string_view log, std::string_view text) {
  const std::vector<CodeLine> code = code_lines(text);
  std::string result;
  for (const std::string& line : lines_of(log)) result += at_missing_semicolon(line, code) + "\n";
  return result;
}

Error ShaderSource::error(std::string_view log, const std::vector<Define>& defines) const {
  const std::size_t at = log.find(kFault);
  std::size_t fault = faults_.size();
  if (at != std::string_view::npos)
    std::from_chars(log.data() + at + kFault.size(), log.data() + log.size(), fault);
  return fault < faults_.size() ? faults_[fault]
                                : Error::failed(locate(at_missing_semicolons(log, text(defines))));
}

std::string ShaderSource::text(const std::vector<Define>& defines) const {
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

bool ShaderSource::mentions(std::string_view token) const {
  for (std::size_t at = body_.find(token); at != std::string::npos; at = body_.find(token, at + 1)) {
    const bool starts = at == 0 || !is_word(body_[at - 1]);
    const bool ends = at + token.size() >= body_.size() || !is_word(body_[at + token.size()]);
    if (starts && ends) return true;
  }
  return false;
}

std::string ShaderSource::locate(std::string_view log) const {
  constexpr std::string_view kEnds("\n\0", 2);  // drivers end their log with a zero
  std::string result;
  for (std::size_t start = 0; start < log.size();) {
    const std::size_t end = std::min(log.find_first_of(kEnds, start), log.size());
    const std::string_view line = log.substr(start, end - start);
    start = end + 1;
    if (trimmed(line).empty()) continue;
    const Mark mark = first_mark(line);
    const auto file = static_cast<std::size_t>(mark.number / kLinesPerFile);
    if (file == 0 || file > files_.size()) {
      result.append(line).append("\n");
      continue;
    }
    std::string_view rest = line.substr(mark.end);
    int column = 0;
    if (rest.starts_with('(')) {  // Mesa's column
      const char* close = std::from_chars(rest.data() + 1, rest.data() + rest.size(), column).ptr;
      rest.remove_prefix(static_cast<std::size_t>(close - rest.data()));
    }
    rest.remove_prefix(std::min(rest.find_first_not_of("): "), rest.size()));
    if (rest.starts_with("warning")) continue;
    result += fmt::format("{}:{}:", shown_name(files_[file - 1]), mark.number % kLinesPerFile);
    if (column > 0) result += fmt::format("{}:", column);
    result += fmt::format(" {}\n", rest);
  }
  while (result.ends_with('\n')) result.pop_back();
  return result;
}

}  // namespace texel::gl
