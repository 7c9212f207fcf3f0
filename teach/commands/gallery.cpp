// SPDX-License-Identifier: MIT
// What docs and README have of the gallery.

#include <fmt/format.h>

#include <algorithm>

#include "commands.hpp"
#include "core/files.hpp"
#include "course_commands.hpp"
#include "image/load.hpp"
#include "image/mipmaps.hpp"
#include "image/save.hpp"

namespace texel::commands {
namespace {

namespace fs = std::filesystem;

/// The middle of a picture, as large as possible in 3:2: pictures then stand in even rows.
image::Image8 middle(const image::Image8& picture) {
  image::Image8 result(std::min(picture.width, picture.height * 3 / 2),
                       std::min(picture.height, picture.width * 2 / 3), picture.channels);
  const int left = (picture.width - result.width) / 2, below = (picture.height - result.height) / 2;
  const auto row = static_cast<std::ptrdiff_t>(result.width) * result.channels;
  for (int y = 0; y < result.height; ++y) std::copy_n(&picture.at(left, below + y), row, &result.at(0, y));
  return result;
}

/// Saves a picture at half its size, averaged in linear light.
void save_small(const fs::path& to, const image::Image8& picture) {
  const std::vector<image::Image8> levels = image::mip_chain(picture, image::Encoding::srgb);
  image::save_png(to, levels[std::min<std::size_t>(1, levels.size() - 1)], {}, 9);
}

constexpr const char* kSourcePictures = "source_pictures";  // in docs, beside the heroes' folder

/// The name of the small picture of a look of the sources.
std::string source_picture(const course::Lab& lab, const course::Look& look) {
  return fmt::format("{}/{}_{}.png", kSourcePictures, lab.folder, look.name);
}

}  // namespace

void save_heroes(const tools::GalleryOptions& gallery, const fs::path& folder) {
  const fs::path docs = fs::absolute(folder).parent_path();
  make_folder(folder), make_folder(docs / kSourcePictures);
  for (const course::Lab& lab : tools::chosen_labs(gallery.labs)) {
    const auto drawn = [&](const course::Look& look) {
      return image::load8(gallery.out / lab.folder / look.file, 3);
    };
    const auto hero = std::ranges::find(lab.looks, true, &course::Look::hero);
    if (hero != lab.looks.end()) save_small(folder / (lab.folder + ".png"), middle(drawn(*hero)));
    for (const course::Look& look : lab.looks)
      if (!look.source.empty()) save_small(docs / source_picture(lab, look), drawn(look));
  }
}

}  // namespace texel::commands
