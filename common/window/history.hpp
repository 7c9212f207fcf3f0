// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <utility>
#include <vector>

#include "app/canvas.hpp"
#include "course/case.hpp"

namespace texel::window {

/// Every parameter, the view, what is compared and the gallery's look they began with, to go back to. How far
/// the model has turned is left out: it turns by itself.
struct SavedLook {
  std::vector<course::Setting> settings;
  app::View view = app::View::color;
  std::optional<app::Canvas::Split> split;
  std::optional<std::size_t> look;  ///< its number in the gallery
  bool operator==(const SavedLook&) const = default;
};

/// Undo and redo: the looks that the window has had, one after the other.
class History {
 public:
  /// Takes note of the present look. Call it where the user is not in the middle of a change.
  void note(SavedLook look) {
    if (!looks_.empty() && look == looks_[present_]) return;
    if (!looks_.empty()) looks_.resize(present_ + 1);  // what was undone is gone
    looks_.push_back(std::move(look));
    present_ = looks_.size() - 1;
  }
  /// The look before the present one, which it now is; null when there is none.
  const SavedLook* undo() { return present_ == 0 ? nullptr : &looks_[--present_]; }
  /// The look that the last undo left; null when there is none.
  const SavedLook* redo() { return present_ + 1 >= looks_.size() ? nullptr : &looks_[++present_]; }

 private:
  std::vector<SavedLook> looks_;
  std::size_t present_ = 0;  ///< which of them the window shows
};

}  // namespace texel::window
