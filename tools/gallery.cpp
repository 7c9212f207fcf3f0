// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <mutex>

#include "commands.hpp"
#include "core/files.hpp"
#include "core/json.hpp"
#include "core/parallel.hpp"
#include "core/pattern.hpp"
#include "core/process.hpp"
#include "core/terminal.hpp"
#include "course/batch.hpp"
#include "embedded.hpp"
#include "image/save.hpp"

namespace texel::tools {
namespace {

namespace fs = std::filesystem;

fs::file_time_type newest_below(const fs::path& folder) {
  fs::file_time_type newest = fs::file_time_type::min();
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) newest = std::max(newest, entry.last_write_time());
  return newest;
}

/// The list of pictures from which a lab's were drawn, in their folder.
constexpr const char* kList = "batch.json";

std::string batch_of(const course::Lab& lab) {
  return course::to_batch(std::vector<course::Case>(lab.looks.begin(), lab.looks.end()));
}

/// Whether every picture in `folder` was drawn from the same list, and is newer than everything it depends
/// on.
bool is_current(const course::Lab& lab, const fs::path& folder, const fs::path& root) {
  const fs::path list = folder / kList, program = program_of(lab);
  if (!fs::exists(list) || read_file(list) != batch_of(lab)) return false;
  fs::file_time_type newest = std::max(fs::last_write_time(list), fs::last_write_time(program));
  for (const fs::path& part :
       {root / "shaders/app", root / "shaders/lib", root / "assets", root / "shaders" / lab.folder})
    newest = std::max(newest, newest_below(part));
  return std::ranges::all_of(lab.looks, [&](const course::Look& look) {
    return fs::exists(folder / look.file) && fs::last_write_time(folder / look.file) >= newest;
  });
}

void say(const course::Lab& lab, const char* what) {
  fmt::print("  lab {:<2} {:<28} {:2} pictures {}\n", lab.number, lab.title, lab.looks.size(), what);
  flush_output();  // a log shows each as it ends
}

/// Draws everything that is not up to date. Throws if a lab fails, after the others have ended.
void draw(const std::vector<course::Lab>& labs, const fs::path& out) {
  const fs::path root = course_root();
  std::vector<const course::Lab*> changed;
  for (const course::Lab& lab : labs) {
    if (lab.looks.empty()) continue;
    if (!fs::exists(program_of(lab)))
      throw Error::failed("is missing", {program_of(lab).string()}, "build it with ./run build");
    if (is_current(lab, out / lab.folder, root))
      say(lab, "unchanged");
    else
      changed.push_back(&lab);
  }
  std::string failed;
  std::mutex mutex;
  in_parallel(processors(), changed.size(), [&](std::size_t index) {
    const course::Lab& lab = *changed[index];
    const fs::path folder = out / lab.folder, list = folder / kList;
    make_folder(folder);
    write_file(list, batch_of(lab));
    const int status = run_into({program_of(lab), "--assets", root, "--batch", list, "--out", folder},
                                STDOUT_FILENO, STDERR_FILENO);
    const std::scoped_lock lock(mutex);
    say(lab, status == 0 ? "drawn" : "FAILED");
    if (status != 0) failed += (failed.empty() ? "" : ", ") + lab.program();
  });
  if (!failed.empty())
    throw Error::failed("could not draw the pictures of " + failed, {}, "see its message above");
}

/// What a picture's text chunk says, or "".
std::string text_of(const fs::path& picture, const char* key) {
  for (const image::Text& text : image::read_png_text(picture))
    if (text.key == key) return text.value;
  return {};
}

Json described(const course::Lab& lab, const fs::path& out) {
  Json looks = Json::array();
  for (const course::Look& look : lab.looks) {
    const std::string legend = text_of(out / lab.folder / look.file, "Legend");  // of a data view
    looks.push_back({{"name", look.name},
                     {"file", look.file},
                     {"caption", look.caption},
                     {"source", look.source},
                     {"hero", look.hero},
                     {"view", name_of(look.view)},
                     {"width", look.size.width},
                     {"height", look.size.height},
                     {"set", course::to_json(look.settings)},
                     {"legend", legend.empty() ? Json() : parse_json(legend)},
                     {"command", course::command(lab, look)}});
  }
  return {{"number", lab.number},
          {"folder", lab.folder},
          {"title", lab.title},
          {"lesson", lab.lesson},
          {"looks", looks}};
}

/// The page as HTML. It names the pictures by their place below its own folder, and nothing else outside of
/// itself.
std::string page_of(const std::vector<course::Lab>& labs, const fs::path& out) {
  Json drawn = {{"renderer", "an unnamed renderer"}, {"labs", Json::array()}};
  for (const course::Lab& lab : labs) {
    drawn["labs"].push_back(described(lab, out));
    if (!lab.looks.empty())
      drawn["renderer"] = text_of(out / lab.folder / lab.looks.front().file, "Renderer");
  }
  const auto escaped = [](const Pattern::Groups&) { return "\\u003c"; };  // no </script>
  const std::string json = Pattern("<").replace(to_text(drawn), escaped);
  std::string page = kGalleryPage;
  constexpr std::string_view kPlace = "{{drawn}}";
  return page.replace(page.find(kPlace), kPlace.size(), json);
}

}  // namespace

Exit gallery(const std::vector<int>& numbers, const fs::path& out) {
  std::vector<course::Lab> labs = chosen_labs(numbers);
  // Errors need the right answers, which only the course's own tree has.
  const bool has_answers = MoreCommands::make != nullptr;
  for (course::Lab& lab : labs)
    std::erase_if(lab.looks, [&](auto& look) { return look.view == course::View::error && !has_answers; });
  draw(labs, out);
  make_folder(out);
  const fs::path page = out / "index.html";
  write_file(page, page_of(labs, out));
  std::size_t count = 0;
  for (const course::Lab& lab : labs) count += lab.looks.size();
  fmt::print("{} pictures of {} labs: {}\n", count, labs.size(), page.string());
  return Exit::holds;
}

}  // namespace texel::tools
