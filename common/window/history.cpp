// SPDX-License-Identifier: MIT
#include "history.hpp"

namespace texel::window {

SavedLook save_look(const params::Set& parameters, app::View view, std::optional<std::size_t> look) {
  SavedLook saved{{}, view, look};
  for (const params::Parameter& p : parameters) saved.values.push_back(p.name == "turn" ? "" : p.text());
  return saved;
}

void restore(const SavedLook& look, params::Set& parameters) {
  auto value = look.values.begin();
  for (params::Parameter& p : parameters) {
    if (p.name != "turn") p.set(*value);
    ++value;
  }
}

void History::note(SavedLook look) {
  if (!looks_.empty() && look == looks_[present_]) return;
  if (!looks_.empty()) looks_.resize(present_ + 1);  // what was undone is gone
  looks_.push_back(std::move(look));
  if (looks_.size() > kMost) looks_.erase(looks_.begin());
  present_ = looks_.size() - 1;
}

const SavedLook* History::undo() {
  return present_ == 0 ? nullptr : &looks_[--present_];
}

const SavedLook* History::redo() {
  return present_ + 1 >= looks_.size() ? nullptr : &looks_[++present_];
}

}  // namespace texel::window
