// SPDX-License-Identifier: MIT
// The labs for a page: one function that takes a call as JSON and gives JSON. README.md has the calls;
// worker.mjs makes them. It does what the window does (common/window).
#include <emscripten.h>
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <list>
#include <map>
#include <memory>

#include "all_labs.inc"
#include "app/gestures.hpp"
#include "app/reports.hpp"
#include "check/check.hpp"
#include "core/error.hpp"
#include "core/files.hpp"
#include "core/json.hpp"
#include "core/pattern.hpp"
#include "core/plain_text.hpp"
#include "core/stopwatch.hpp"
#include "course/batch.hpp"
#include "course/lab_file.hpp"
#include "display.hpp"
#include "es_source.hpp"
#include "gl/context.hpp"
#include "judge/results.hpp"
#include "opened.hpp"
#include "student_files.hpp"
#include "web_context.hpp"

namespace texel::app {
namespace {
AnyLab* registered = nullptr;
}

/// What each lab's main() calls: here it only hands over the lab.
int run(AnyLab& lab, int, char**) {
  registered = &lab;
  return 0;
}

}  // namespace texel::app

namespace texel::web {
namespace {

namespace fs = std::filesystem;
using app::View;

const fs::path kTree = "/tree";
const fs::path kBuild = "/build";  // where check keeps what it remembers

class Engine {
 public:
  Engine() : context_(gl::create_headless()), assets_(kTree) {
    for (const auto& lab_main : kLabs) {
      lab_main(0, nullptr);
      labs_.push_back(app::registered);
    }
    for (const fs::directory_entry& entry : fs::directory_iterator(kTree / "labs"))
      if (const int number = number_of(entry.path().filename());
          number > 0 && course::copied_from(entry.path()).empty())
        course_[number].folder = entry.path().filename();
  }

  Json call(const std::string& name, const Json& a) {
    if (name == "open") return open(a.at("lab"));
    if (name == "steps_of") return steps(lab_called(a.at("lab")));
    if (current_ == nullptr) throw Error::usage("no lab is open", "call open first");
    if (name == "parameters") return parameters();
    if (name == "values") return values();
    if (name == "looks") return looks();
    if (name == "set") return set(a);
    if (name == "reset") return current_->lab.parameters().reset(), frame();
    if (name == "view") return current_->view = find_view(current_->lab, a.at("name")), frame();
    if (name == "split") return split(a);
    if (name == "resize") return size_ = {a.at("width"), a.at("height")}, frame();
    if (name == "aspect") return made_for_ = a.at("aspect"), frame();
    if (name == "samples") return samples_ = a.at("count"), frame();
    if (name == "drag") return app::orbit(current_->lab.parameters(), {a.at("dx"), a.at("dy")}), frame();
    if (name == "zoom") return app::zoom(current_->lab.parameters(), a.at("steps")), frame();
    if (name == "turn") return app::turn(current_->lab.parameters(), a.at("degrees")), frame();
    if (name == "frame") return frame();
    if (name == "draw") return draw(a);
    if (name == "pixel") return pixel({a.at("x"), a.at("y")});
    if (name == "steps") return steps(course_lab());
    if (name == "read") return read(a.at("step"));
    if (name == "write") return write(a.at("step"), a.at("text"));
    if (name == "experiment") return experiment(a.at("path"), a.at("text"));
    if (name == "file") return files().read(a.at("path"));
    if (name == "put") return put(a.at("path"), a.at("text"));
    if (name == "check") return check(a.value("step", std::string()));
    if (name == "compare") return compare(a.at("name"));
    throw Error::usage(fmt::format("there is no call '{}'", name));
  }

  /// What a call leaves besides its JSON, until the next one.
  struct Buffer {
    const void* at;
    std::size_t bytes;
    const char* type;  ///< of its elements
  };
  std::vector<Buffer> buffers;

 private:
  // ---- labs and looks ----

  /// "5" and "05_normal_map" give 5, and what does not begin with a number 0.
  static int number_of(const std::string& name) {
    return static_cast<int>(std::strtol(name.c_str(), nullptr, 10));
  }

  /// Each is read when it is first asked for: a page shows one.
  const course::Lab& lab_called(const Json& which) {
    const int number = which.is_string() ? number_of(which.get<std::string>()) : which.get<int>();
    if (!course_.contains(number)) throw Error::usage(fmt::format("there is no lab {}", to_text(which)));
    course::Lab& lab = course_[number];
    if (lab.title.empty()) lab = course::read_lab(kTree / "labs" / lab.folder / "lab.toml");
    return lab;
  }
  const course::Lab& course_lab() { return lab_called(current_->lab.info().number); }

  Opened& opened(const course::Lab& lab) {
    std::unique_ptr<Opened>& one = opened_[lab.number];
    if (one == nullptr)
      for (app::AnyLab* any : labs_)
        if (any->info().number == lab.number) one = std::make_unique<Opened>(*any, *context_, assets_);
    return *one;
  }

  Json open(const Json& which) {
    const course::Lab& lab = lab_called(which);
    current_ = &opened(lab);
    Json views = Json::array();
    for (const View view : current_->lab.views()) views.push_back(name_of(view));
    Json report = frame();
    return {{"number", lab.number}, {"folder", lab.folder}, {"title", lab.title},
            {"lesson", lab.lesson}, {"views", views},       {"report", report}};
  }

  Json parameters() {
    Json list = parse_json(app::parameters_as_json(current_->lab.parameters()));
    std::size_t i = 0;
    for (const params::Parameter& p : current_->lab.parameters()) {
      Json& one = list[i++];
      one["value"] = p.text();
      one["section"] = p.section;
      one["flag"] = p.flag();
      one["scale"] = p.scale == params::Scale::logarithmic ? "logarithmic" : "linear";
    }
    return list;
  }

  Json values() {
    Json all = Json::object();
    for (const params::Parameter& p : current_->lab.parameters()) all[std::string(p.name)] = p.text();
    return {{"values", all}, {"view", name_of(current_->view)}};
  }

  Json looks() {
    Json list = Json::array();
    for (const std::vector<course::Look>* looks : {&course_lab().openings, &course_lab().looks})
      for (const course::Look& look : *looks) {
        list.push_back({{"name", look.name},
                        {"caption", look.caption},
                        {"source", look.source},
                        {"hero", look.hero},
                        {"view", name_of(look.view)},
                        {"size", as_text(look.size)},
                        {"sides", look.sides},
                        {"set", course::to_json(look.settings)}});
        if (look.right)
          list.back()["right"] = {{"parameter", look.right->parameter}, {"value", look.right->value}};
      }
    return list;
  }

  Json set(const Json& set) {
    app::apply_settings(current_->lab.parameters(), course::settings_from(set));
    return frame();
  }

  Json split(const Json& a) {
    current_->split.reset();
    if (a.contains("parameter"))
      current_->split = {a.at("parameter"), a.at("value").get<std::string>(), a.value("position", 0.5F)};
    return frame();
  }

  /// Draws into the page's canvas.
  Json frame() {
    const Stopwatch stopwatch;
    Opened& now = *current_;
    Json report;
    const bool draws = size_.x > 0 && size_.y > 0;  // not before the page has said how large
    if (draws) {
      const app::KeptValues before(now.lab.parameters());
      fit_view();
      const gl::Preview preview(now.view == View::color);
      if (!display_) display_.emplace(assets_.shader_root());
      if (now.view == View::error) try {
          now.lab.answer()->work(size_, 0);
        } catch (const Error&) {  // there is none: over no colours
          now.canvas.draw_nothing(size_);
          display_->show(now.canvas.picture());
          throw;
        }
      now.canvas.draw(now.view, size_, samples_, now.split, gl::Preview::kind());
      display_->show(now.canvas.picture());
      wait(now.canvas.picture());
    }
    report["drawn"] = draws;
    if (const app::Legend legend = draws ? now.canvas.legend(now.view) : app::Legend(); !legend.title.empty())
      report["legend"] = parse_json(app::to_json(legend));
    report["frame_ms"] = stopwatch.milliseconds();
    report["warnings"] = now.canvas.notes().warnings;
    report["facts"] = now.canvas.notes().facts;
    if (const auto& figures = now.canvas.error_figures())
      report["error_figures"] = parse_json(now.lab.answer()->report(now.lab, *figures));
    return report;
  }

  /// Nothing of the model is cut off on the canvas.
  void fit_view() {
    app::fit_view(current_->lab.parameters(), static_cast<double>(size_.x) / size_.y, made_for_);
  }

  /// Until all is drawn: glFinish only asks for it in a browser.
  static void wait(const gl::Target& picture) {
    unsigned char pixel[4];
    picture.bind_for_reading();
    glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
  }

  // ---- pictures beside the canvas ----

  Json give(image::Image8 picture) {
    given8_.push_back(std::move(picture));
    const image::Image8& it = given8_.back();
    buffers.push_back({it.samples.data(), it.samples.size(), "u8"});
    return {{"width", it.width}, {"height", it.height}, {"channels", it.channels}};
  }

  Json draw(const Json& a) {
    Opened& now = *current_;
    const app::KeptValues before(now.lab.parameters());
    const View view = find_view(now.lab, a.value("view", std::string("color")));
    const app::Settings settings = course::settings_from(a.value("set", Json::object()));
    app::check_settings(now.lab.parameters(), settings);
    now.start.set(settings);
    const glm::ivec2 size = app::pixels(course::parse_size(a.value("size", std::string("512x512"))));
    const int samples = a.value("samples", view == View::color ? 4 : 1);
    now.canvas.draw(view, size, samples);
    if (view == View::color || a.value("colors", false))
      return give(image::without_alpha(now.canvas.read8()));
    given_ = now.canvas.read_float();
    buffers.push_back({given_.samples.data(), given_.samples.size() * sizeof(float), "f32"});
    return {{"width", given_.width}, {"height", given_.height}, {"channels", given_.channels}};
  }

  Json pixel(glm::ivec2 at) {
    Opened& now = *current_;
    if (at.x < 0 || at.y < 0 || at.x >= size_.x || at.y >= size_.y)
      throw Error::usage("no pixel of the canvas");
    const app::KeptValues before(now.lab.parameters());
    fit_view();
    Json views = Json::array();
    for (const View view : now.lab.views()) {
      if (view == View::color || view == View::error) continue;
      const glm::vec4 value = now.canvas.value_at(view, size_, at);
      views.push_back({{"view", name_of(view)}, {"values", {value.x, value.y, value.z, value.w}}});
    }
    Json result{{"x", at.x}, {"y", at.y}, {"views", views}};
    const auto comparison =
        now.lab.answer() != nullptr ? now.lab.answer()->compare_at(now.canvas, size_, at) : std::nullopt;
    if (comparison) {
      const auto& [measure, value, truth, error] = *comparison;
      result["comparison"] = {{"view", name_of(measure.view)},
                              {"unit", name_of(measure.unit)},
                              {"of", measure.truth},
                              {"value", {value.x, value.y, value.z}},
                              {"truth", {truth.x, truth.y, truth.z}},
                              {"error", error}};
    }
    return result;
  }

  // ---- steps ----

  StudentFiles& files() {
    if (!files_) files_.emplace(kTree);
    return *files_;
  }

  Json steps(const course::Lab& lab) {
    Json list = Json::array();
    const StudentFiles& files = this->files();
    const std::set<std::string> untouched = check::untouched_steps({kTree, kBuild});
    for (const course::Step& step : lab.steps) {
      const Place& place = files.place(step.id);
      Json one{{"id", step.id},
               {"title", step.title},
               {"points", step.points},
               {"needs", step.needs},
               {"hints", step.hints},
               {"untouched", untouched.contains(step.id)},
               {"kind", StudentFiles::is_shader(place.file) ? "shader" : "c++"},
               {"file", place.file},
               {"line", place.line},
               {"cases", Json::array()}};
      for (const course::Case& it : course::with_public_cases(lab).cases)
        if (it.step == step.id)
          one["cases"].push_back({{"name", it.name},
                                  {"view", name_of(it.view)},
                                  {"size", it.is_mesh() ? "" : as_text(it.size)},
                                  {"set", course::to_json(it.settings)},
                                  {"limit", it.limit},
                                  {"unit", name_of(course::unit_of(it.view))},
                                  {"command", course::command(lab, it)}});
      list.push_back(one);
    }
    return list;
  }

  Json read(const std::string& step) {
    const StudentFiles::Text text = files().text(step);
    return {{"text", text.now}, {"first", text.first}, {"file", text.file}, {"line", text.line}};
  }

  Json write(const std::string& step, const std::string& text) {
    return put(files().place(step).file, files().with(step, text));
  }

  Json put(const std::string& path, const std::string& text) {
    files().write(path, text);
    return drawn_anew();
  }

  /// Draws with another text of a shader that has no step, and with its own again where the text is empty.
  Json experiment(const std::string& path, const std::string& text) {
    if (!path.starts_with("shaders/" + course_lab().folder + "/") || !path.ends_with(".frag"))
      throw Error::usage(fmt::format("'{}' is no fragment shader of this lab", path));
    std::string& own = own_shaders_[path];
    if (own.empty()) own = read_file(kTree / path);
    write_file(kTree / path, text.empty() ? own : text);
    return drawn_anew();
  }

  /// After a shader was written.
  Json drawn_anew() {
    for (auto& [number, one] : opened_) one->canvas.programs().clear();
    Json report = frame();
    if (shows_endless_loop())
      report["endless"] = fmt::format(
          "A loop goes on for more than {} rounds. It was ended there, and the picture is magenta.",
          gl::kMostRounds);
    return report;
  }

  /// Whether gl::es_source ended a loop in a pixel of the canvas.
  bool shows_endless_loop() {
    if (size_.x <= 0 || size_.y <= 0) return false;
    const auto is_marked = [](const auto& picture, auto full, auto half, auto rounding) {
      for (std::size_t i = 0; i + 4 <= picture.samples.size(); i += 4) {
        const auto* p = &picture.samples[i];
        if (p[0] == full && p[1] == 0 && p[2] == full && std::abs(p[3] - half) <= rounding) return true;
      }
      return false;
    };
    if (current_->view != View::color && current_->view != View::error)
      return is_marked(current_->canvas.read_float(), 1.0F, 0.5F, 0.0F);
    return is_marked(current_->canvas.read8(), 255, 128, 1);
  }

  // ---- the judge ----

  Json check(const std::string& step) {
    files();
    const check::Draws draws = [this](const course::Lab& lab, const std::vector<course::Case>& cases,
                                      const fs::path& out) {
      return draw_cases(opened(lab), cases, check::expected_folder(kTree, lab), out);
    };
    const check::OwnTree tree{kTree, kBuild};
    checked_ = step.empty() ? check::check(tree, {course_lab()}, draws).front()
                            : check::check_step(tree, course_lab(), step, draws);
    return parse_json(judge::to_json(checked_));
  }

  /// A case of the last check by its name; nullptr where it has no picture.
  const judge::CaseResult* drawn_case(const std::string& name) const {
    for (const judge::StepResult& step : checked_.steps)
      for (const judge::CaseResult& one : step.cases)
        if (one.name == name && !one.is_mesh() && !one.picture.empty()) return &one;
    return nullptr;
  }

  Json compare(const std::string& name) {
    const judge::CaseResult* one = drawn_case(name);
    if (one == nullptr) return nullptr;
    image::Compared all = check::compared(*one);
    const glm::ivec2 telling(all.figures.telling_x, all.figures.telling_y);
    const bool differs = !one->passed() && all.figures.max > 0;
    Json size = give(std::move(all.own));
    if (differs) size["mark"] = {telling.x, telling.y};  // from the lower left
    give(std::move(all.expected)), give(std::move(all.heat_map));
    return size;
  }

 public:
  /// Forgets the pictures that the last call gave.
  void clear() { buffers.clear(), given8_.clear(); }

 private:
  std::unique_ptr<gl::Context> context_;
  app::Assets assets_;
  std::vector<app::AnyLab*> labs_;
  std::map<int, course::Lab> course_;  ///< by number; of one that nobody has asked for, the folder alone
  std::optional<StudentFiles> files_;
  std::map<std::string, std::string> own_shaders_;  ///< the first texts of experiments, by path
  judge::LabResult checked_;                        ///< the last
  std::map<int, std::unique_ptr<Opened>> opened_;
  Opened* current_ = nullptr;
  std::optional<Display> display_;
  glm::ivec2 size_{0};
  int samples_ = 4;
  double made_for_ = 1;  ///< the aspect of the look that is shown
  image::ImageF given_;
  std::list<image::Image8> given8_;
};

/// A compiler's lines "file:line:column: what" in an error's text.
Json problems_of(const std::string& text) {
  static const Pattern kProblem(R"(([^:.]*\.[^:]*):([1-9][0-9]*):(?:([1-9][0-9]*):)? *(.*))");
  Json list = Json::array();
  for (const std::string& line : lines_of(text))
    if (const Pattern::Groups found = kProblem.match(line); !found.empty())
      list.push_back({{"file", found[1]},
                      {"line", std::stoi(found[2])},
                      {"column", found[3].empty() ? 0 : std::stoi(found[3])},
                      {"message", found[4]}});
  return list;
}

std::string answer(const char* request) {
  static std::unique_ptr<Engine> engine;
  Json result;
  try {
    if (engine == nullptr) engine = std::make_unique<Engine>();
    engine->clear();
    const Json call = parse_json(request);
    result["result"] = engine->call(call.at("call"), call.value("with", Json::object()));
    result["buffers"] = Json::array();
    for (const Engine::Buffer& buffer : engine->buffers)
      result["buffers"].push_back({{"at", reinterpret_cast<std::uintptr_t>(buffer.at)},
                                   {"bytes", buffer.bytes},
                                   {"type", buffer.type}});
  } catch (const Error& error) {
    const Json problems = problems_of(error.what());
    result = {{"error",
               {{"message", error.what()},
                {"kind", error.exit_code() == Exit::usage ? "usage" : "failed"},
                {"file", problems.empty() ? Json(error.place().file) : problems[0]["file"]},
                {"line", problems.empty() ? Json(error.place().line) : problems[0]["line"]},
                {"column", problems.empty() ? Json(error.place().column) : problems[0]["column"]},
                {"problems", problems}}}};
  } catch (const std::exception& error) {
    result = {{"error", {{"message", error.what()}, {"kind", "internal"}, {"problems", Json::array()}}}};
  }
  return to_text(result);
}

}  // namespace
}  // namespace texel::web

extern "C" EMSCRIPTEN_KEEPALIVE const char* texel_call(const char* request) {
  static std::string text;
  text = texel::web::answer(request);
  return text.c_str();
}
