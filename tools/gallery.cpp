// SPDX-License-Identifier: MIT
#include "gallery.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/assets.hpp"
#include "commands.hpp"
#include "core/files.hpp"
#include "core/parallel.hpp"
#include "core/terminal.hpp"
#include "course/batch.hpp"
#include "image/load.hpp"
#include "image/mipmaps.hpp"
#include "image/save.hpp"
#include "processes.hpp"

namespace texel::tools {
namespace {

namespace fs = std::filesystem;

fs::file_time_type newest_below(const fs::path& folder) {
  fs::file_time_type newest = fs::file_time_type::min();
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) newest = std::max(newest, entry.last_write_time());
  return newest;
}

/// A lab whose pictures are to be drawn into `folder`.
struct Work {
  const course::Lab* lab;
  fs::path folder, list, program;
};

Work work_for(const course::Lab& lab, const fs::path& out) {
  const fs::path folder = out / lab.folder;
  return {&lab, folder, folder / "batch.json", program_of(lab)};
}

std::string batch_of(const course::Lab& lab) {
  return course::to_batch(std::vector<course::Case>(lab.looks.begin(), lab.looks.end()));
}

/// Whether every picture was drawn from the same list, and is newer than everything it depends on.
bool is_current(const Work& work, const fs::path& root) {
  if (!fs::exists(work.list) || read_file(work.list) != batch_of(*work.lab)) return false;
  if (!fs::exists(work.program)) return false;
  fs::file_time_type newest = std::max(fs::last_write_time(work.list), fs::last_write_time(work.program));
  for (const char* part : {"shaders/app", "shaders/lib", "assets"})
    newest = std::max(newest, newest_below(root / part));
  newest = std::max(newest, newest_below(root / "shaders" / work.lab->folder));
  return std::all_of(work.lab->looks.begin(), work.lab->looks.end(), [&](const course::Look& look) {
    const fs::path file = work.folder / look.file;
    return fs::exists(file) && fs::last_write_time(file) >= newest;
  });
}

/// Removes looks that need the right answers, if this tree has none, and says so.
void leave_out_errors(std::vector<course::Lab>& labs) {
  std::size_t left_out = 0;
  for (course::Lab& lab : labs) {
    const auto is_error = [](const course::Look& look) { return look.view == course::View::error; };
    if (std::any_of(lab.looks.begin(), lab.looks.end(), is_error) && !knows_truth(lab))
      left_out += std::erase_if(lab.looks, is_error);
  }
  if (left_out > 0)
    fmt::print("  {} error pictures are left out: this tree does not contain the right answers\n", left_out);
}

void say(const course::Lab& lab, const char* what) {
  fmt::print("  lab {:<2} {:<28} {:2} pictures {}\n", lab.number, lab.title, lab.looks.size(), what);
  flush_output();  // a log shows each as it ends
}

/// Draws everything that is not up to date. Throws if a lab fails, after the others have ended.
void draw(const std::vector<Work>& all, const fs::path& root) {
  std::vector<Work> works;
  for (const Work& work : all) {
    if (work.lab->looks.empty()) continue;
    if (is_current(work, root))
      say(*work.lab, "unchanged");
    else
      works.push_back(work);
  }
  std::vector<Command> commands;
  for (const Work& work : works) {
    make_folder(work.folder);
    write_file(work.list, batch_of(*work.lab));
    commands.push_back(
        {work.program, "--assets", root, "--batch", work.list.string(), "--out", work.folder.string()});
  }
  std::string failed;
  const int at_once = static_cast<int>(processors());
  run_all(commands, at_once, [&](std::size_t index, int status) {
    say(*works[index].lab, status == 0 ? "drawn" : "FAILED");
    if (status != 0) failed += (failed.empty() ? "" : ", ") + works[index].lab->program();
  });
  if (!failed.empty())
    throw Error::failed("could not draw the pictures of " + failed, {}, "see its message above");
}

/// The middle of a picture, as large as possible in 3:2: pictures then stand in even rows.
image::Image8 middle(const image::Image8& picture) {
  image::Image8 result(std::min(picture.width, picture.height * 3 / 2),
                       std::min(picture.height, picture.width * 2 / 3), picture.channels);
  const int left = (picture.width - result.width) / 2, below = (picture.height - result.height) / 2;
  const auto row = static_cast<std::ptrdiff_t>(result.width) * result.channels;
  for (int y = 0; y < result.height; ++y) std::copy_n(&picture.at(left, below + y), row, &result.at(0, y));
  return result;
}

void save_heroes(const std::vector<course::Lab>& labs, const GalleryOptions& options) {
  if (options.heroes.empty()) return;
  make_folder(options.heroes);
  for (const course::Lab& lab : labs)
    if (const course::Look* hero = hero_of(lab))
      save_hero(options.out / picture(lab, *hero), options.heroes / (lab.folder + ".png"));
}

/// What drew the first picture, as its text chunk has it.
std::string renderer(const std::vector<course::Lab>& labs, const fs::path& out) {
  for (const course::Lab& lab : labs)
    if (!lab.looks.empty())
      for (const image::Text& text : image::read_png_text(out / picture(lab, lab.looks.front())))
        if (text.key == "Renderer") return text.value;
  return "an unnamed renderer";
}

}  // namespace

const course::Look* hero_of(const course::Lab& lab) {
  const auto hero =
      std::find_if(lab.looks.begin(), lab.looks.end(), [](const course::Look& look) { return look.hero; });
  return hero != lab.looks.end() ? &*hero : nullptr;
}

void save_hero(const fs::path& from, const fs::path& to) {
  const std::vector<image::Image8> levels =
      image::mip_chain(middle(image::load8(from, 3)), image::Encoding::srgb);
  image::save_png(to, levels[std::min<std::size_t>(1, levels.size() - 1)], {}, 9);
}

std::string picture(const course::Lab& lab, const course::Look& look) {
  return lab.folder + "/" + look.file;
}

Exit gallery(const GalleryOptions& options) {
  std::vector<course::Lab> labs = chosen_labs(options.labs);
  leave_out_errors(labs);
  const fs::path root = app::Assets().shader_root().parent_path();
  std::vector<Work> works;
  std::size_t count = 0;
  for (const course::Lab& lab : labs) {
    works.push_back(work_for(lab, options.out));
    count += lab.looks.size();
  }
  draw(works, root);
  save_heroes(labs, options);
  make_folder(options.out);
  const fs::path page = options.out / "index.html";
  write_file(page, gallery_page(labs, renderer(labs, options.out)));
  fmt::print("{} pictures of {} labs: {}\n", count, labs.size(), page.string());
  return Exit::holds;
}

}  // namespace texel::tools
