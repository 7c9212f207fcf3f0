// SPDX-License-Identifier: MIT
// What docs and README have of the gallery.

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <regex>

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

/// A '|' would end a table's cell, also inside of code.
std::string cell(const std::string& text) {
  return std::regex_replace(text, std::regex("\\|"), "\\|");
}

constexpr const char* kSourcesHead =
    "# The sources' pictures\n\n"
    "The labs implement three [sources](student.md#the-sources). Each picture that these show is drawn by "
    "one command,\n"
    "typed in the project's root; the faulty ones too. `texel gallery --list` prints this page from the "
    "labs' `lab.toml`,\n"
    "and a test holds it to that.\n";

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

Exit list_sources() {
  std::map<std::string, std::string> rows;  // document -> its pictures, in the labs' order
  for (const course::Lab& lab : tools::course_labs())
    for (const course::Look& look : lab.looks) {
      if (look.source.empty()) continue;
      const std::size_t comma = look.source.find(", ");
      const std::string place = comma == std::string::npos ? "" : look.source.substr(comma + 2);
      rows[look.source.substr(0, comma)] +=
          fmt::format("| ![]({}) | {}: {}<br>`{}` |\n", source_picture(lab, look), cell(place),
                      cell(look.caption), cell(course::command(lab, look)));
    }
  fmt::print("{}", kSourcesHead);
  for (const auto& [document, table] : rows)
    fmt::print("\n## {}\n\n| picture | where, what it shows, and its command |\n|---|---|\n{}", document,
               table);
  return Exit::holds;
}

}  // namespace texel::commands
