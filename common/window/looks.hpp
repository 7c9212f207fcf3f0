// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "app/canvas.hpp"
#include "course/lab_file.hpp"
#include "gl/objects.hpp"

namespace texel::window {

/// The gallery's looks of a lab (labs/NN_name/lab.toml), hero first, with small pictures of them.
struct Looks {
  static constexpr glm::ivec2 kSize{240, 160};  ///< of a small picture, in pixels

  struct Entry {
    course::Look look;
    gl::Texture picture;  ///< bottom row first
    std::string fault;    ///< why it could not be drawn, or ""
  };
  std::vector<Entry> entries;
  std::size_t drawn = 0;  ///< so many small pictures are there; 0 has all drawn again
  std::string fault;      ///< why the lab's file cannot be read, or ""

  /// None where the lab's file is missing; those with a view that this tree does not have are left out.
  Looks(app::AnyLab& lab, const app::Assets& assets);

  [[nodiscard]] bool are_drawn() const { return drawn == entries.size(); }
  /// Draws the next small picture that is missing; the lab keeps its parameters.
  void draw_next(gl::Context& context, const app::Assets& assets, app::AnyLab& lab);
};

/// The value right of the line of an opening; none of another look.
std::optional<app::Canvas::Split> split_of(const course::Look& look);
/// Sets the look's parameters and view. Throws Error (usage) when the lab does not have them.
void choose(const course::Case& look, app::AnyLab& lab, app::View& view);

}  // namespace texel::window
