// SPDX-License-Identifier: MIT
#include "looks.hpp"

#include <algorithm>
#include <filesystem>

#include "app/settings.hpp"
#include "core/error.hpp"
#include "window/gui.hpp"

namespace texel::window {

Looks::Looks(app::AnyLab& lab, const app::Assets& assets) {
  const std::filesystem::path file =
      assets.shader_root().parent_path() / "labs" / lab.info().folder() / "lab.toml";
  if (!std::filesystem::exists(file)) return;
  try {
    for (course::Look& look : course::read_lab(file).looks)
      if (std::ranges::count(lab.views(), look.view) > 0) entries.push_back({std::move(look), {}, false, {}});
  } catch (const Error& error) {
    fault = error.what();
  }
  std::stable_partition(entries.begin(), entries.end(), [](const Entry& entry) { return entry.look.hero; });
}

std::size_t Looks::drawn() const {
  return static_cast<std::size_t>(std::ranges::count(entries, true, &Entry::is_drawn));
}

void Looks::forget() {
  for (Entry& entry : entries) entry.is_drawn = false;
}

bool Looks::draw_next(gl::Context& context, const app::Assets& assets, app::AnyLab& lab) {
  const auto next = std::ranges::find(entries, false, &Entry::is_drawn);
  if (next == entries.end()) return false;
  next->is_drawn = true;
  next->fault.clear();
  const app::KeptValues before(lab.parameters());
  try {
    app::View view{};
    choose(next->look, lab, view);
    app::Canvas canvas(context, assets, lab);  // the window's own keeps its picture
    canvas.draw(view, kSize, 4);
    next->picture = picture_texture(canvas.read8());
  } catch (const Error& error) {
    next->fault = error.what();
  }
  return true;
}

void choose(const course::Case& look, app::AnyLab& lab, app::View& view) {
  app::check_settings(lab.parameters(), look.settings);
  lab.parameters().reset();
  for (const auto& [parameter, value] : look.settings) lab.parameters().at(parameter).set(value);
  view = look.view;
}

}  // namespace texel::window
