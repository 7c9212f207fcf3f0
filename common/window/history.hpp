// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "app/lab.hpp"

namespace texel::window {

/// Every parameter, the view and the gallery's look they began with, to go back to. How far the model has
/// turned is left out: it turns by itself.
struct SavedLook {
  std::vector<std::string> values;  ///< in declaration order
  app::View view = app::View::color;
  std::optional<std::size_t> look;  ///< its number in the gallery
  bool operator==(const SavedLook&) const = default;
};
SavedLook save_look(const params::Set& parameters, app::View view, std::optional<std::size_t> look);
/// Sets the parameters; the model stays turned as it is.
void restore(const SavedLook& look, params::Set& parameters);

/// Undo and redo: the looks that the window has had, one after the other.
class History {
 public:
  /// Takes note of the present look. Call it where the user is not in the middle of a change.
  void note(SavedLook look);
  /// The look before the present one, which it now is; null when there is none.
  const SavedLook* undo();
  /// The look that the last undo left; null when there is none.
  const SavedLook* redo();

 private:
  static constexpr std::size_t kMost = 200;
  std::vector<SavedLook> looks_;
  std::size_t present_ = 0;  ///< which of them the window shows
};

}  // namespace texel::window
