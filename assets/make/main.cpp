// SPDX-License-Identifier: MIT
// Makes everything in assets/ that is not a program: pictures, normal maps, cube maps and models.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>

#include "check.hpp"
#include "core/scratch_folder.hpp"
#include "core/terminal.hpp"
#include "cube_maps.hpp"
#include "models.hpp"
#include "textures.hpp"

namespace {

namespace fs = std::filesystem;

void make_all(const fs::path& folder) {
  const auto progress = [](const fs::path& file) {
    fmt::print("making {}\n", file.string());
    texel::flush_output();
  };
  texel::assets::make_textures(folder, progress);
  texel::assets::make_normal_maps(folder, progress);
  texel::assets::make_cube_maps(folder, progress);
  progress("models");
  texel::assets::make_models(folder / "models");
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Makes the pictures, normal maps, cube maps and models of the labs.");
  std::string folder = "assets";
  bool is_check = false;
  app.add_option("--out", folder, "the asset folder to write, or to compare with")->capture_default_str();
  app.add_flag("--check", is_check,
               "write nothing there; exit 1 if what would be made differs from what is there");
  return texel::run_main("make_assets", [&] {
    try {
      app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
      return app.exit(error) == 0 ? texel::Exit::holds : texel::Exit::usage;
    }
    if (!is_check) {
      make_all(folder);
      return texel::Exit::holds;
    }
    const texel::ScratchFolder fresh;
    make_all(fresh.path());
    return texel::assets::same_files(fresh.path(), folder) ? texel::Exit::holds : texel::Exit::differs;
  });
}
