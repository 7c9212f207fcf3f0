// SPDX-License-Identifier: MIT
#include "app/assets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "core/error.hpp"
#include "core/parallel.hpp"
#include "core/stages.hpp"
#include "image/load.hpp"

namespace texel::app {
namespace {

namespace fs = std::filesystem;

bool is_root(const fs::path& path) {
  return fs::is_directory(path / "shaders") && fs::is_directory(path / "assets");
}

fs::path find_root(const fs::path& given) {
  const char* variable = std::getenv("TEXEL_ROOT");
  const fs::path named = given.empty() && variable != nullptr ? variable : given;
  if (!named.empty()) {
    if (is_root(named)) return named;
    throw Error::failed("does not contain the folders assets/ and shaders/", {named.string()},
                        given.empty() ? "correct TEXEL_ROOT" : "correct --assets");
  }
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  const fs::path installed = program.parent_path().parent_path() / "share" / "texel-labs";
  if (!error && is_root(installed)) return installed;
  if (is_root(TEXEL_SOURCE_DIR)) return TEXEL_SOURCE_DIR;
  throw Error::failed("cannot find the folders assets/ and shaders/", {},
                      "give --assets DIR or set TEXEL_ROOT");
}

/// "brick" is bundled, "./brick.png" and "photos/brick" are not.
bool is_bundled_name(const std::string& name) {
  return name.find_first_of("./\\") == std::string::npos;
}

/// OpenGL would read other faces as black and say nothing.
void check_cube_faces(const std::array<image::Image8, 6>& faces, const std::string& folder) {
  constexpr const char* kNames[] = {"+X", "-X", "+Y", "-Y", "+Z", "-Z"};
  for (std::size_t i = 0; i < 6; ++i)
    if (faces[i].width != faces[i].height || faces[i].width != faces[0].width)
      throw Error::failed(
          fmt::format("the cube map's face {} has {}x{} texels, and face +X has {}x{}", kNames[i],
                      faces[i].width, faces[i].height, faces[0].width, faces[0].height),
          {folder}, "use six square pictures of the same size");
}

}  // namespace

Assets::Assets(const fs::path& root) : root_(find_root(root)) {}

fs::path Assets::find(const char* folder, const std::string& name, const char* ending) const {
  if (!is_bundled_name(name)) return name;
  const fs::path place = root_ / "assets" / folder;
  const fs::path file = place / (name + ending);
  if (fs::exists(file)) return file;
  std::vector<std::string> names;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(place, error))
    names.push_back(entry.path().stem().string());
  throw Error::failed(fmt::format("there is no '{}' among the bundled {}", name, folder), {},
                      did_you_mean(name, names, "write a path with a '/' or its file extension"));
}

void Assets::remember(const fs::path& path) const {
  if (std::find(files_.begin(), files_.end(), path) == files_.end()) files_.push_back(path);
}

image::Image8 Assets::load(const fs::path& path, int channels) const {
  const Stage stage("decode");
  remember(path);
  return image::load8(path, channels);
}

image::Image8 Assets::texture(const std::string& name) const {
  return load(find("textures", name, ".png"), 0);
}

image::Image8 Assets::normal_map(const std::string& name) const {
  return load(find("normal_maps", name, ".png"), 3);
}

std::array<image::Image8, 6> Assets::cube_map(const std::string& name) const {
  static constexpr const char* kFaces[] = {"px.png", "nx.png", "py.png", "ny.png", "pz.png", "nz.png"};
  const fs::path folder = find("cube_maps", name, "");
  std::array<image::Image8, 6> faces;
  for (const char* face : kFaces) remember(folder / face);
  const Stage stage("decode");
  in_parallel(processors(), 6, [&](std::size_t i) {
    // The loader puts the bottom row first; cube maps want the top row.
    faces[i] = image::flipped(image::load8(folder / kFaces[i], 3));
  });
  check_cube_faces(faces, folder.string());
  return faces;
}

fs::path Assets::mesh(const std::string& name) const {
  const fs::path read = root_ / "assets" / "models" / (name + ".ply");
  if (!is_bundled_name(name) || !fs::exists(read)) return model(name);
  remember(read);
  return read;
}

fs::path Assets::model(const std::string& name) const {
  fs::path path = find("models", name, ".obj");
  remember(path);
  return path;
}

}  // namespace texel::app
