// SPDX-License-Identifier: MIT
// A small class with all that a report must show, and its pictures.
#pragma once
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "core/files.hpp"
#include "image/image.hpp"
#include "image/save.hpp"
#include "mesh/ply.hpp"
#include "mesh/primitives.hpp"
#include "store/class_results.hpp"

namespace texel::test {

/// Text that does harm where it is not escaped: in HTML, attributes, scripts, JUnit's attachments.
inline constexpr const char* kHostile =
    "</script><!--<script>document.title='harmed'</script><img src=x onerror=\"document.title='harmed'\">"
    "' \" & ]]> [[ATTACHMENT|/etc/passwd]]";

/// The normals of a ball, (0, 0, 0) beside it; with `flipped` as a student sees it who turns green round.
inline image::ImageF ball(int size, bool flipped) {
  image::ImageF normals(size, size, 3);
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const float nx = (static_cast<float>(2 * x + 1) / static_cast<float>(size) - 1) / 0.8F;
      const float ny = (static_cast<float>(2 * y + 1) / static_cast<float>(size) - 1) / 0.8F;
      const float rest = 1 - nx * nx - ny * ny;
      if (rest <= 0) continue;
      normals.at(x, y, 0) = nx;
      normals.at(x, y, 1) = flipped ? -ny : ny;
      normals.at(x, y, 2) = std::sqrt(rest);
    }
  return normals;
}

/// The ball, lit from the upper left.
inline image::Image8 lit(const image::ImageF& normals) {
  image::Image8 picture(normals.width, normals.height, 3);
  for (int y = 0; y < normals.height; ++y)
    for (int x = 0; x < normals.width; ++x) {
      const float n = -0.5F * normals.at(x, y, 0) + 0.6F * normals.at(x, y, 1) + 0.62F * normals.at(x, y, 2);
      for (int c = 0; c < 3; ++c)
        picture.at(x, y, c) = static_cast<std::uint8_t>(std::lround(
            normals.at(x, y, 2) > 0 ? 40 + 200 * std::max(0.0F, n) : 56 + 4.0F * static_cast<float>(c)));
    }
  return picture;
}

/// Writes right and wrong of .png, .pfm and .ply into `folder`/pictures, where they are missing.
inline void write_pictures(const std::filesystem::path& folder) {
  const std::filesystem::path pictures = folder / "pictures";
  std::filesystem::create_directories(pictures);
  for (const bool wrong : {false, true}) {
    const std::filesystem::path file = pictures / (wrong ? "wrong" : "right");
    if (std::filesystem::exists(file.string() + ".png")) continue;
    const image::ImageF normals = ball(64, wrong);
    image::save_png(file.string() + ".png", lit(normals));
    image::save_pfm(file.string() + ".pfm", normals);
    mesh::Mesh square = mesh::quad(1);  // to the left s is wrong
    for (std::size_t i = 0; wrong && i < square.vertex_count(); ++i)
      if (square.positions[i].x < 0) square.texcoords[i].x = 0.5F;
    write_file(file.string() + ".ply", mesh::to_ply(square));
  }
}

inline course::Lab lab(int number, const std::string& folder, const std::string& title,
                       const std::vector<course::Step>& steps) {
  course::Lab made;
  made.number = number, made.folder = folder, made.title = title, made.steps = steps;
  return made;
}

inline std::vector<course::Lab> demo_labs() {
  return {
      lab(3, "03_obj_texcoords", "Texture coordinates of an OBJ file",
          {{"3.1", "Read the texture coordinates", 2, {}, {"Which of the three in `v/vt/vn` is it?"}}}),
      lab(5, "05_normal_map", "Normal map",
          {{"5.1", "Decode the map's colour", 2, {}, {"What does a grey of 128 stand for?"}},
           {"5.2", "Build the tangent frame", 4, {"5.1"}, {"T, B and N are the columns of a matrix."}},
           {"5.3", "Light the normal", 1, {}, {"Which of the two normals does the light see?"}}}),
      lab(9, "09_bump", "Bump mapping",
          {{"9.1", "Take the slope of the height", 3, {}, {"Two texels apart."}}}),
  };
}

/// A case with one of the demo's pictures.
inline judge::CaseResult demo_case(const std::string& lab, const std::string& step, const std::string& name,
                                   const std::string& view, bool hidden, bool passed) {
  judge::CaseResult result;
  result.lab = lab, result.step = step, result.name = name, result.hidden = hidden;
  result.view = course::find_view(view).value();
  result.status = passed ? judge::Status::passed : judge::Status::failed;
  result.score = passed ? 1 : 0;
  result.limit = view == "color" ? 2 : view == "mesh" ? 0 : 0.2;
  result.error = passed ? 0 : view == "color" ? 83 : view == "mesh" ? 12 : 106.26;
  const char* ending = view == "color" ? ".png" : view == "mesh" ? ".ply" : ".pfm";
  result.command = "./run lab 5 --turn 50 --normal-map bump --view " + view + " --size 128x128 --snapshot " +
                   name + ending;
  if (!hidden) result.reference = std::string("pictures/right") + ending;
  if (passed) return result;
  result.message = view == "mesh" ? "2 of 4 vertices have another texture coordinate."
                                  : "In 1208 pixels of the object the light comes from below.";
  result.picture = std::string("pictures/wrong") + ending;
  return result;
}

/// Steps 1 to `solved` (counted over all labs) are solved, of the next the public cases only.
inline std::vector<judge::LabResult> demo_results(int solved, const std::string& mistake = {},
                                                  const std::string& says = {}) {
  std::vector<judge::LabResult> labs;
  for (const course::Lab& lab : demo_labs()) {
    judge::LabResult result;
    result.lab = lab;
    for (const course::Step& step : lab.steps) {
      const std::string view = step.id == "3.1" ? "mesh" : step.id == "5.3" ? "color" : "normal";
      std::vector<judge::CaseResult> cases = {
          demo_case(lab.folder, step.id, "plain_" + view, view, false, solved > 0),
          demo_case(lab.folder, step.id, "turned_" + view, view == "normal" ? "color" : view, false,
                    solved > 0),
          demo_case(lab.folder, step.id, "unseen_" + view, view, true, solved > 0)};
      if (solved == 0) cases[0] = demo_case(lab.folder, step.id, "flat_" + view, view, false, true);
      for (judge::CaseResult& each : cases)
        if (!each.passed())
          each.mistake = mistake, each.mistake_says = says, each.score = mistake.empty() ? 0 : 0.25;
      result.steps.push_back(judge::step_result(step, cases));
      result.steps.back().file =
          step.id == "5.2" ? "shaders/05_normal_map/tangent_frame.glsl" : "labs/" + lab.folder + "/lab.cpp";
      result.steps.back().line = 42;
      --solved;
    }
    labs.push_back(result);
  }
  return labs;
}

/// Full marks (with the id of the class's own page), half, nothing, a compile error, a hostile name, a long
/// one, an incident, and a submission that cannot be read.
inline store::ClassResult demo_class(const std::filesystem::path& folder) {
  write_pictures(folder);
  store::ClassResult results;
  results.facts = {{"renderer", "llvmpipe (LLVM 15.0.6, 256 bits), OSMesa"},
                   {"seed", "7f3a 91c2"},
                   {"version", "0.1.0"},
                   {"command", "texel grade class --out out/grade --labs 3,5,9"}};
  const auto add = [&](const std::string& id, const std::string& name, const std::string& number) -> auto& {
    store::StudentResult& student = results.students.emplace_back();
    student.id = id, student.name = name, student.number = number;
    return student;
  };
  add("index", "Index Page", "10231").labs = demo_results(5);
  add("ada-half", "Ada Half", "10232").labs =
      demo_results(2, "normal-green-flipped", "Green is inverted: in these maps green points up (+Y).");
  add("ben-nothing", "Ben Nothing", "10233").labs = demo_results(-1);

  store::StudentResult& broken = add("cleo-broken", "Cleo Broken", "10234");
  broken.labs =
      demo_results(1, "normal-green-flipped", "Green is inverted: in these maps green points up (+Y).");
  broken.logs = {{"shaders/05_normal_map/decode_normal.glsl",
                  "shaders/05_normal_map/decode_normal.glsl:7:3: error: `colour' undeclared\n"
                  "    7 |   return colour * 2.0 - 1.0;\n      |          ^~~~~~\n"}};
  for (judge::CaseResult& each : broken.labs.back().steps[0].cases)  // 9.1 is not begun
    each.status = judge::Status::untouched;
  broken.ignored = {{"build/CMakeCache.txt", "no file of the labs"}, {".git/config", "in a hidden folder"}};

  store::StudentResult& hostile = add("script-1a2b3c4d", kHostile, "=HYPERLINK(\"http://x\")");
  hostile.labs = demo_results(0, "normal-green-flipped", kHostile);
  for (judge::LabResult& lab : hostile.labs)
    for (judge::StepResult& step : lab.steps) {
      step.message = step.title = step.file = kHostile, step.hints = {kHostile};
      for (judge::CaseResult& each : step.cases)
        each.message = each.command = kHostile, each.name += kHostile;
    }
  hostile.labs.front().notes = {kHostile};
  hostile.logs = {
      {kHostile, std::string("a\x01\x1b[31mb\xff\n\tline two \xEF\xBF\xBE \xEF\xBF\xBF ") + kHostile}};
  hostile.ignored = {{kHostile, kHostile}};

  store::StudentResult& long_name =
      add("wolfeschlegelsteinhausenbergerdorff",
          "Hubert Blaine Wolfeschlegelsteinhausenbergerdorff-Featherstonehaugh", "10236");
  long_name.labs = demo_results(3, "tangent-not-orthogonal", "T must be made perpendicular to `N` again.");
  long_name.labs[1].steps[1].overridden = "right idea, shown in the lab session";
  long_name.labs[1].steps[1].score = 0.75;

  store::StudentResult& incident = add("dora-incident", "Dora Incident", "10237");
  incident.labs = demo_results(0);
  incident.incident = "lab 5: the sandbox could not start: no space left on the disk";

  add("emil-bomb", "Emil Bomb", "10238").fault = "the archive unpacks to more than 512 MiB";

  results.changes = {{"ada-half", "5.1", 0.25, 1}, {"ben-nothing", "5.2", 0.5, 0.25}};
  return results;
}

}  // namespace texel::test
