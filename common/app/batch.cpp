// SPDX-License-Identifier: MIT
#include "app/batch.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>
#include <future>
#include <optional>
#include <set>

#include "app/snapshot.hpp"
#include "core/error.hpp"
#include "core/files.hpp"
#include "core/parallel.hpp"
#include "core/stopwatch.hpp"
#include "course/batch.hpp"
#include "mesh/ply.hpp"

namespace texel::app {
namespace {

void check(AnyLab& lab, const course::Case& one) {
  if (!one.is_mesh()) {
    find_view(lab, name_of(one.view));
    check_ending(one.file, one.view);
  }
  check_settings(lab.parameters(), one.settings);
}

/// What became of the cases so far, also in the folder's file.
class Drawings {
 public:
  Drawings(const std::filesystem::path& folder, std::string drawn_by)
      : file_(folder / course::kDrawingsFile), drawn_by_(std::move(drawn_by)) {
    save();
  }

  void add(const course::Case& one, double milliseconds) {
    add({one.file, true, {}, {}, drawn_by_, milliseconds});
  }
  void add(const course::Case& one, const Error& fault) {
    ++faults_;
    std::fprintf(stderr, "%s: %s\n", one.file.c_str(), fault.what());
    // Without the folder: the same file lies elsewhere for everybody.
    const Place& place = fault.place();
    const std::string file = std::filesystem::path(place.file).filename();
    add({one.file,
         false,
         fault.what(),
         place.line > 0 ? fmt::format("{}:{}", file, place.line) : file,
         {},
         0});
  }
  [[nodiscard]] std::size_t faults() const { return faults_; }

 private:
  void add(course::Drawing drawing) {
    all_.push_back(std::move(drawing));
    save();
  }
  void save() const { write_file(file_, course::to_json(all_)); }

  std::filesystem::path file_;
  std::string drawn_by_;
  std::vector<course::Drawing> all_;
  std::size_t faults_ = 0;
};

}  // namespace

Batch read_batch(AnyLab& lab, const std::filesystem::path& list) {
  const std::string text = read_file(list);
  try {
    Batch batch = course::parse_batch(text);
    for (std::size_t i = 0; i < batch.size(); ++i) try {
        check(lab, batch[i]);
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
  std::set<std::string> programs;
  for (const course::Case& one : batch) {
    if (one.is_mesh()) continue;
    pixels += static_cast<double>(one.size.width) * one.size.height;
    std::set<std::string> constants = {name_of(one.view)};
    for (const auto& [name, value] : one.settings) {
      const params::Parameter::Type type = parameters.find(name)->type;
      if (type == params::Parameter::Type::choice || type == params::Parameter::Type::toggle)
        constants.insert(name + "=" + value);
    }
    programs.insert(fmt::format("{}", fmt::join(constants, " ")));
  }
  return pixels / static_cast<double>(std::max<std::size_t>(programs.size(), 1));
}

void write_mesh(AnyLab& lab, const Assets& assets, const std::filesystem::path& file) {
  ++present_frame;
  const mesh::Mesh* mesh = lab.mesh(assets);
  if (mesh == nullptr) throw Error::usage("this lab has no mesh to write", "labs 3, 4 and 5 do");
  mesh::write_ply(file, *mesh);
}

void draw_batch(Canvas& canvas, AnyLab& lab, const Assets& assets, const Batch& batch,
                const std::filesystem::path& folder, int samples) {
  const bool at_once = processors() > 1;  // a picture is compressed while the next is drawn
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    throw Error::failed(fmt::format("cannot make the folder: {}", error.message()), {folder.string()});
  const StartValues start(lab.parameters());
  Drawings drawings(folder, canvas.context().name());
  const course::Case* before = nullptr;  // the one that is being written
  double milliseconds = 0;               // that drawing it took
  std::future<void> written;
  const auto finish_writing = [&] {
    if (written.valid()) try {
        written.get();
        drawings.add(*before, milliseconds);
      } catch (const Error& fault) {
        drawings.add(*before, fault);
      }
  };
  for (const course::Case& one : batch) {
    std::optional<Snapshot> snapshot;
    std::optional<Error> fault;
    const Stopwatch stopwatch;
    try {
      start.set(one.settings);
      const std::filesystem::path file = folder / one.file;
      if (one.is_mesh()) {
        write_mesh(lab, assets, file);
      } else {
        canvas.draw(one.view, pixels(one.size), samples);
        snapshot = take_snapshot(canvas, lab, one.view, pixels(one.size), file);
      }
    } catch (const Error& thrown) {
      fault = thrown;
    }
    const double own_milliseconds = stopwatch.milliseconds();
    finish_writing();
    if (fault)
      drawings.add(one, *fault);
    else if (!snapshot)
      drawings.add(one, own_milliseconds);
    if (!snapshot) continue;
    before = &one, milliseconds = own_milliseconds;
    written = std::async([taken = std::move(*snapshot)] { taken.write(); });
    if (!at_once) finish_writing();
  }
  finish_writing();
  if (drawings.faults() > 0)
    throw Error::failed(fmt::format("{} of {} entries could not be drawn", drawings.faults(), batch.size()));
}

}  // namespace texel::app
