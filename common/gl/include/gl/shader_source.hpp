// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"

namespace texel::gl {

/// `#define name value`, put behind the #version line. `origin` says where it comes from, for people.
struct Define {
  std::string name, value, origin = {};
};

/// Compilers find a missing `;` at the next token. Where that begins a line, this names the line before it,
/// after which the `;` is missing, with its text. `log` is the compiler's, and `text` what it read, as
/// ShaderSource::text has it. All other lines of the log stay as they are.
std::string at_missing_semicolons(std::string_view log, std::string_view text);

/// One shader with its includes expanded: the text for the compiler, and the files that it came from.
///
/// `#include "lib/light.glsl"` names a file beside the including file, or below the folder `shaders/`. Each
/// file is taken once, and once more in a branch of #if when it was in another one. An include that cannot be
/// followed is an error where the compiler comes to it; in a comment it is none. Mesa rejects file names in
/// #line and forgets source numbers in semantic errors, so the line directives carry file * 100000 + line,
/// which locate() decodes.
class ShaderSource {
 public:
  /// Throws Error (exit 3) when the file or its #version is missing.
  ShaderSource(const std::filesystem::path& root, const std::filesystem::path& file);
  /// The same for a text that is in no file; messages call it `name`.
  ShaderSource(const std::filesystem::path& root, const std::string& name, const std::string& text);

  /// The text with `defines` behind its #version line.
  [[nodiscard]] std::string text(const std::vector<Define>& defines) const;
  /// The same for people: each constant and uniform has a comment that says where it comes from, and comments
  /// name the files in place of line marks. `origin` knows a uniform by its name.
  [[nodiscard]] std::string readable(const std::vector<Define>& defines,
                                     const std::function<std::string(const std::string&)>& origin) const;
  /// Is `token` used anywhere in it, as a whole word?
  [[nodiscard]] bool mentions(std::string_view token) const;
  [[nodiscard]] const std::vector<std::filesystem::path>& files() const { return files_; }
  /// A compiler's log with our encoded lines turned into `shaders/file:line: message`, as editors open
  /// it in the tree. Warnings are left out.
  [[nodiscard]] std::string locate(std::string_view log) const;
  /// The same as an error (exit 3); `defines` are those of text(). Where the compiler came to an include of a
  /// file that is missing, or that includes itself, it says so instead.
  [[nodiscard]] Error error(std::string_view log, const std::vector<Define>& defines) const;

 private:
  struct Reading;
  void expand(Reading& reading, std::size_t file, std::string_view text, bool may_be_left_out);
  void include(Reading& reading, const std::string& name, const Place& place, bool may_be_left_out);
  /// "shaders/05_normal_map/normal_map.frag".
  [[nodiscard]] std::string shown_name(const std::filesystem::path& file) const;
  std::filesystem::path root_;
  std::vector<std::filesystem::path> files_;
  std::vector<Error> faults_;  ///< of its includes
  std::string version_, body_;
};

}  // namespace texel::gl
