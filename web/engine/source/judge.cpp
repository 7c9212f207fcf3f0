// SPDX-License-Identifier: MIT
#include "judge.hpp"

#include <fmt/format.h>

#include "core/files.hpp"
#include "core/plain_text.hpp"
#include "coverage.hpp"
#include "gl/context.hpp"
#include "image/load.hpp"
#include "image/save.hpp"
#include "mesh/ply.hpp"

namespace texel::web {

namespace fs = std::filesystem;

Judge::Judge(fs::path tree, gl::Context& context, const app::Assets& assets,
             std::function<Opened&(const course::Lab&)> opened)
    : tree_(std::move(tree)), context_(context), assets_(assets), opened_(std::move(opened)) {}

check::Drawn Judge::draw(const course::Lab& lab, const std::vector<course::Case>& cases,
                         const fs::path& out) {
  Opened& one = opened_(lab);
  const Aside aside(one);
  check::Drawn drawn;
  drawn.renderer = context_.name();
  fs::create_directories(out);
  for (const course::Case& it : cases) try {
      one.start.set(it.settings);
      if (it.is_mesh()) {
        mesh::write_ply(out / it.file, *one.lab.mesh(assets_));
        continue;
      }
      const glm::ivec2 size(it.size.width, it.size.height);
      const std::string reference = read_file(check::expected_folder(tree_, lab) / it.file);
      if (it.view == app::View::color)
        image::save_png(out / it.file, image::without_alpha(with_coverage_of(
                                           image::parse_png(reference, it.file, size.x, size.y), it,
                                           one.canvas, [&] { return one.canvas.read8(); })));
      else
        image::save_pfm(out / it.file, with_coverage_of(image::parse_pfm(reference, it.file), it, one.canvas,
                                                        [&] { return one.canvas.read_float(); }));
    } catch (const Error& error) {
      const Place& place = error.place();
      const std::string file = fs::path(place.file).filename();
      drawn.faults[it.file] = plain_lines(error.what());
      drawn.refused[it.file] = place.line > 0 ? fmt::format("{}:{}", file, place.line) : file;
    }
  return drawn;
}

const judge::LabResult& Judge::check(const course::Lab& lab, const std::string& step) {
  const check::Draws draws = [this](const course::Lab& of, const std::vector<course::Case>& cases,
                                    const fs::path& out) { return draw(of, cases, out); };
  const check::OwnTree tree{tree_, kBuild};
  checked_ =
      step.empty() ? check::check(tree, {lab}, draws).front() : check::check_step(tree, lab, step, draws);
  return checked_;
}

const judge::CaseResult* Judge::drawn(const std::string& name) const {
  for (const judge::StepResult& step : checked_.steps)
    for (const judge::CaseResult& one : step.cases)
      if (one.name == name && !one.is_mesh() && !one.picture.empty()) return &one;
  return nullptr;
}

}  // namespace texel::web
