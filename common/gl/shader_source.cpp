// SPDX-License-Identifier: MIT
#include "gl/shader_source.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <sstream>

#include "core/error.hpp"
#include "core/files.hpp"
#include "core/plain_text.hpp"

namespace texel::gl {
namespace {

constexpr int kLinesPerFile = 100000;

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front())) != 0) text.remove_prefix(1);
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())) != 0) text.remove_suffix(1);
  return text;
}

/// The name in `#include "name"`, or "" for any other line.
std::string_view included(std::string_view line) {
  line = trimmed(line);
  if (!line.starts_with('#')) return {};
  line = trimmed(line.substr(1));
  if (!line.starts_with("include")) return {};
  line = trimmed(line.substr(7));
  const std::size_t end = line.size() < 2 ? std::string_view::npos : line.find('"', 1);
  return line.starts_with('"') && end != std::string_view::npos ? line.substr(1, end - 1)
                                                                : std::string_view{};
}

/// Is it an #else, #elif or #endif?
bool ends_branch(std::string_view line) {
  line = trimmed(line);
  if (!line.starts_with('#')) return false;
  line = trimmed(line.substr(1));
  return line.starts_with("else") || line.starts_with("elif") || line.starts_with("endif");
}

}  // namespace

ShaderSource::ShaderSource(const std::filesystem::path& root, const std::filesystem::path& file)
    : root_(root) {
  std::vector<std::filesystem::path> open;
  expand(root / file, read_file(root / file), open);
  check_version();
}

ShaderSource::ShaderSource(const std::filesystem::path& root, const std::string& name,
                           const std::string& text)
    : root_(root) {
  std::vector<std::filesystem::path> open;
  expand(root / name, text, open);
  check_version();
}

std::string ShaderSource::shown_name(const std::filesystem::path& file) const {
  return (root_.filename() / file.lexically_relative(root_)).string();
}

void ShaderSource::check_version() const {
  if (version_.empty())
    throw Error::failed("the shader has no #version", {shown_name(files_.front()), 1},
                        "start it with '#version 330 core'");
}

void ShaderSource::expand(const std::filesystem::path& file, const std::string& text,
                          std::vector<std::filesystem::path>& open) {
  const auto number = files_.size() + 1;
  files_.push_back(file);
  open.push_back(file);
  const auto mark = [&](int line) {
    body_ += fmt::format("#line {}\n", static_cast<int>(number) * kLinesPerFile + line);
  };
  mark(1);
  int line_number = 0;
  // Editors of Windows put a byte-order mark before the first line; a compiler of GLSL does not know it.
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  for (std::size_t start = text.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0;
       start < text.size();) {
    const std::size_t end = std::min(text.find('\n', start), text.size());
    const std::string_view line(text.data() + start, end - start);
    start = end + 1;
    ++line_number;
    if (trimmed(line).starts_with("#version")) {
      version_ = std::string(trimmed(line)) + "\n";
      body_ += '\n';
      continue;
    }
    const std::string_view name = included(line);
    if (name.empty()) {
      body_.append(line).append("\n");
      // In a branch that is left out the compiler skips our #line marks too.
      if (ends_branch(line)) mark(line_number + 1);
      continue;
    }
    const Place place{shown_name(file), line_number};
    std::filesystem::path target = file.parent_path() / name;
    if (!std::filesystem::exists(target)) target = root_ / name;
    if (!std::filesystem::exists(target))
      throw Error::failed(fmt::format("there is no file '{}' to include", name), place,
                          "name a file beside this one or below shaders/");
    if (std::find(open.begin(), open.end(), target) != open.end())
      throw Error::failed(fmt::format("'{}' includes itself", name), place);
    if (std::find(files_.begin(), files_.end(), target) == files_.end())
      expand(target, read_file(target), open);
    mark(line_number + 1);
  }
  open.pop_back();
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
  std::istringstream lines(body_);
  std::size_t shown = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("#line ")) {
      // A new file, or the rest of one after an include.
      const auto file = static_cast<std::size_t>(std::stoi(line.substr(6)) / kLinesPerFile);
      if (file != shown) text += fmt::format("// ---- {}\n", shown_name(files_[file - 1]));
      shown = file;
      continue;
    }
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
    // "0:200012(5): error: …" (Mesa) and "0(200012) : error …" (others): the first number above 100000 is
    // ours.
    bool found = false;
    for (std::size_t at = 0; at < line.size() && !found; ++at) {
      if (std::isdigit(static_cast<unsigned char>(line[at])) == 0 || (at > 0 && is_word(line[at - 1])))
        continue;
      int encoded = 0;
      const char* stop = std::from_chars(line.data() + at, line.data() + line.size(), encoded).ptr;
      const auto file = static_cast<std::size_t>(encoded / kLinesPerFile);
      if (encoded < kLinesPerFile || file > files_.size()) continue;
      std::string_view rest(stop, static_cast<std::size_t>(line.data() + line.size() - stop));
      int column = 0;
      if (rest.starts_with('(')) {  // Mesa's column
        const char* close = std::from_chars(rest.data() + 1, rest.data() + rest.size(), column).ptr;
        rest.remove_prefix(static_cast<std::size_t>(close - rest.data()));
      }
      while (!rest.empty() && (rest.front() == ')' || rest.front() == ':' || rest.front() == ' '))
        rest.remove_prefix(1);
      found = true;
      if (rest.starts_with("warning")) continue;
      result += fmt::format("{}:{}:", shown_name(files_[file - 1]), encoded % kLinesPerFile);
      if (column > 0) result += fmt::format("{}:", column);
      result += fmt::format(" {}\n", rest);
    }
    if (!found) result.append(line).append("\n");
  }
  while (result.ends_with('\n')) result.pop_back();
  return result;
}

}  // namespace texel::gl
