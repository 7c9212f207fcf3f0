// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"

namespace texel::gl {

/// `#define name value`, put behind the #version line. `origin` says where it comes from, for people.
struct Define {
  std::string name, value, origin = {};
};

/// One shader with its includes expanded: the text for the compiler, and the files that it came from.
///
/// `#include "lib/light.glsl"` names a file beside the including file, or below the folder `shaders/`. Each
/// file is taken once, and once more where the first time was in a branch of #if. Mesa rejects file names in
/// #line and forgets source numbers in semantic errors, so the line directives carry file * 100000 + line,
/// which locate() decodes.
class ShaderSource {
 public:
  /// Throws Error (exit 3) when the file or its #version is missing.
  ShaderSource(const std::filesystem::path& root, const std::filesystem::path& file);
  /// The same for a text that is in no file; messages call it `name`.
  ShaderSource(const std::filesystem::path& root, const std::string& name, const std::string& text);

  /// The text with `defines` behind its #version line. Throws Error (exit 3) for an include of a file that is
  /// missing or includes itself: files() has all others, so that one sees when it is mended.
  [[nodiscard]] std::string text(const std::vector<Define>& defines) const;
  /// The same for people: each constant and uniform has a comment that says where it comes from, and comments
  /// name the files in place of line marks. `origin` knows a uniform by its name.
  [[nodiscard]] std::string readable(const std::vector<Define>& defines,
                                     const std::function<std::string(const std::string&)>& origin) const;
  /// Is `token` used anywhere in it, as a whole word?
  [[nodiscard]] bool mentions(std::string_view token) const { return words_.contains(token); }
  [[nodiscard]] const std::vector<std::filesystem::path>& files() const { return files_; }
  /// A compiler's log with our encoded lines turned into `shaders/file:line: message`, as editors open
  /// it in the tree. Warnings are left out. Asks whether a ';' is missing where one may be.
  [[nodiscard]] std::string locate(std::string_view log) const;

 private:
  struct Reading;
  void expand(Reading& reading, std::size_t file, std::string_view text, bool may_be_left_out);
  void include(Reading& reading, std::string_view rest, const Place& place, bool may_be_left_out);
  /// "shaders/05_normal_map/normal_map.frag".
  [[nodiscard]] std::string shown_name(const std::filesystem::path& file) const;
  std::filesystem::path root_;
  std::vector<std::filesystem::path> files_;
  std::optional<Error> fault_;  ///< of its includes, the first
  std::string version_, body_;
  std::set<std::string, std::less<>> words_;  ///< of the body
};

}  // namespace texel::gl
