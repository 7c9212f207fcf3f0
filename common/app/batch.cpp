// SPDX-License-Identifier: MIT
#include "app/batch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <future>
#include <set>

#include "core/error.hpp"
#include "core/files.hpp"
#include "core/parallel.hpp"
#include "core/stopwatch.hpp"
#include "course/batch.hpp"
#include "image/save.hpp"
#include "mesh/ply.hpp"

namespace texel::app {
namespace {

course::Drawing not_drawn(const course::Case& one, const Error& fault) {
  // Without the folder: the same file lies elsewhere for everybody.
  const Place& place = fault.place();
  const std::string file = std::filesystem::path(place.file).filename();
  return {one.file, false, fault.what(), place.line > 0 ? fmt::format("{}:{}", file, place.line) : file,
          {},       0};
}

}  // namespace

void check_ending(const std::filesystem::path& file, View view) {
  const std::string ending = file.extension().string();
  if (ending == ".pfm" && view == View::color)
    throw Error::usage("a .pfm is for a data view, not for colours",
                       "add --view with a data view, or write a .png");
  if (ending != ".png" && ending != ".pfm")
    throw Error::usage(fmt::format("cannot write a picture to '{}'", file.string()),
                       "end the name in .png or .pfm");
}

std::function<void()> take_snapshot(const Canvas& canvas, AnyLab& lab, View view, glm::ivec2 size,
                                    const std::filesystem::path& file) {
  if (file.extension() == ".pfm")
    return [file, values = canvas.read_float()] { image::save_pfm(file, image::without_alpha(values)); };
  std::vector<image::Text> texts{{"Lab", lab.info().folder()},
                                 {"Parameters", lab.parameters().key()},
                                 {"View", name_of(view)},
                                 {"Size", fmt::format("{}x{}", size.x, size.y)},
                                 {"Renderer", canvas.context().name()}};
  if (const Legend legend = canvas.legend(view); !legend.title.empty())
    texts.push_back({"Legend", to_json(legend)});
  if (const ErrorFigures* figures = canvas.error_figures())
    texts.push_back({"Error", lab.answer()->report(lab, *figures)});
  // Alpha is no part of the picture.
  return [file, colors = canvas.read8(), texts = std::move(texts)] {
    image::save_png(file, image::without_alpha(colors), texts);
  };
}

Batch read_batch(AnyLab& lab, const std::filesystem::path& list) {
  const std::string text = read_file(list);
  try {
    Batch batch = course::parse_batch(text);
    for (std::size_t i = 0; i < batch.size(); ++i) try {
        if (!batch[i].is_mesh()) {
          find_view(lab, name_of(batch[i].view));
          check_ending(batch[i].file, batch[i].view);
        }
        check_settings(lab.parameters(), batch[i].settings);
      } catch (const Error& error) {
        throw Error::usage(fmt::format("entry {}: {}", i + 1, error.what()));
      }
    return batch;
  } catch (const Error& error) {
    throw Error::usage(fmt::format("{}: {}", list.string(), error.what()));
  }
}

double pixels_per_program(const Batch& batch, const params::Set& parameters) {
  double pixels = 0;
  std::set<std::set<std::string>> programs;  // each by its constants
  for (const course::Case& one : batch) {
    if (one.is_mesh()) continue;
    pixels += static_cast<double>(one.size.width) * one.size.height;
    std::set<std::string> constants = {name_of(one.view)};
    for (const auto& [name, value] : one.settings)
      if (parameters.find(name)->is_constant()) constants.insert(name + "=" + value);
    programs.insert(std::move(constants));
  }
  return pixels / static_cast<double>(std::max<std::size_t>(programs.size(), 1));
}

void write_mesh(AnyLab& lab, const Assets& assets, const std::filesystem::path& file) {
  ++present_frame;
  const mesh::Mesh* mesh = lab.mesh(assets);
  if (mesh == nullptr) throw Error::usage("this lab has no mesh to write", "labs 3, 4 and 5 do");
  write_file(file, mesh::to_ply(*mesh));
}

void draw_batch(Canvas& canvas, AnyLab& lab, const Assets& assets, const Batch& batch,
                const std::filesystem::path& folder, int samples) {
  make_folder(folder);
  // A picture is compressed while the next is drawn, or at once.
  const bool in_turn = processors() == 1;
  const KeptValues start(lab.parameters());
  const auto draw = [&](const course::Case& one) {
    const std::filesystem::path file = folder / one.file;
    const Stopwatch stopwatch;
    std::function<void()> write = [] {};
    try {
      start.set(one.settings);
      if (one.is_mesh()) {
        write_mesh(lab, assets, file);
      } else {
        canvas.draw(one.view, pixels(one.size), samples);
        write = take_snapshot(canvas, lab, one.view, pixels(one.size), file);
      }
    } catch (const Error& fault) {
      write = [fault] { throw fault; };
    }
    course::Drawing drawing{one.file, true, {}, {}, canvas.context().name(), stopwatch.milliseconds()};
    return std::async(in_turn ? std::launch::deferred : std::launch::async,
                      [&one, drawing = std::move(drawing), write = std::move(write)] {
                        try {
                          write();
                          return drawing;
                        } catch (const Error& fault) {
                          return not_drawn(one, fault);
                        }
                      });
  };

  const std::filesystem::path list = folder / course::kDrawingsFile;
  std::vector<course::Drawing> drawings;
  write_file(list, course::to_json(drawings));
  const auto finish = [&](std::future<course::Drawing> written) {
    if (!written.valid()) return;
    const course::Drawing& last = drawings.emplace_back(written.get());
    if (!last.is_drawn) fmt::print(stderr, "{}: {}\n", last.file, last.message);
    write_file(list, course::to_json(drawings));
  };
  std::future<course::Drawing> before;
  for (const course::Case& one : batch) {
    std::future<course::Drawing> drawn = draw(one);
    finish(std::move(before));
    before = std::move(drawn);
    if (in_turn) finish(std::move(before));
  }
  finish(std::move(before));
  const auto faults = std::ranges::count_if(drawings, [](auto& one) { return !one.is_drawn; });
  if (faults > 0)
    throw Error::failed(fmt::format("{} of {} entries could not be drawn", faults, batch.size()));
}

}  // namespace texel::app
