// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/error.hpp"

namespace texel::web {

/// The files with steps of a tree, as a student has them: with one text between a step's markers. In the
/// course's tree they become such files.
class StudentFiles {
 public:
  explicit StudentFiles(std::filesystem::path tree);

  /// What stands between the markers of a step.
  struct Text {
    std::string now, first;  ///< where it is written in several places, with lines kNextPlace between them
    std::string file;        ///< in the tree
    int line = 0;            ///< of the text's first line
  };
  [[nodiscard]] Text text(const std::string& step) const;
  /// Puts a text between the markers of a step that is written in a shader. Gives the whole file, which is
  /// not written yet. Throws Error where the text has markers, or too few or many places.
  [[nodiscard]] std::string with(const std::string& step, const std::string& text) const;

  /// Where a step begins. Throws Error where there is no such step.
  [[nodiscard]] const Place& place(const std::string& step) const;
  [[nodiscard]] std::string read(const std::string& path) const;
  /// Replaces a whole file. Throws Error where its markers are not those of the course's file.
  void write(const std::string& path, const std::string& text) const;

  [[nodiscard]] static bool is_shader(const std::string& file) { return file.starts_with("shaders/"); }
  /// Between the parts of a step that is written in several places.
  static constexpr const char* kNextPlace = "//@next";

 private:
  [[nodiscard]] const std::string& known(const std::string& path) const;

  std::filesystem::path tree_;
  std::vector<std::string> files_;
  std::map<std::string, Place> places_;
};

}  // namespace texel::web
