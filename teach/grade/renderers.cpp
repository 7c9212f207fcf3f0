// SPDX-License-Identifier: MIT
#include "grade/renderers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "check/check.hpp"
#include "core/error.hpp"
#include "core/files.hpp"
#include "core/parallel.hpp"
#include "grade/hidden_cases.hpp"
#include "references.hpp"

namespace texel::grade {
namespace {

namespace fs = std::filesystem;

/// Those of the hidden cases: any will do.
constexpr std::array kSeeds = {"one", "two", "three"};

/// The variables of a renderer, for as long as this lives.
class Surroundings {
 public:
  explicit Surroundings(const Renderer& renderer) : renderer_(renderer) {
    for (const auto& [name, value] : renderer_.environment) ::setenv(name.c_str(), value.c_str(), 1);
    ::setenv("TEXEL_CONTEXT", renderer_.context.c_str(), 1);
  }
  ~Surroundings() {
    for (const auto& variable : renderer_.environment) ::unsetenv(variable.first.c_str());
    ::unsetenv("TEXEL_CONTEXT");
  }
  Surroundings(const Surroundings&) = delete;
  Surroundings& operator=(const Surroundings&) = delete;

 private:
  const Renderer& renderer_;
};

check::Studio studio(const CourseTree& tree, const course::Lab& lab, const std::string& context) {
  return {tree.build / "bin" / lab.program(), tree.course, context};
}

/// What draws, or "" where the machine has no such renderer.
std::string found(const Renderer& renderer, const CourseTree& tree) {
  for (const auto& [name, value] : renderer.environment)
    if (name == "LD_PRELOAD" && !fs::exists(value)) return {};
  try {
    std::string says = check::renderer_of(studio(tree, tree.labs.front(), renderer.context));
    return says.starts_with(renderer.says) ? says : "";
  } catch (const Error&) {
    return {};
  }
}

/// The cases of a seed; of others than the first the hidden ones alone, as the public ones are the same.
std::vector<judge::LabPlan> plans_of(const CourseTree& tree, const std::string& seed,
                                     const fs::path& models) {
  std::vector<judge::LabPlan> plans = full_plan(tree.labs, seed, models);
  if (seed != kSeeds.front())
    for (judge::LabPlan& one : plans)
      std::erase_if(one.cases, [](const course::Case& of) { return !of.hidden; });
  return plans;
}

/// What check compares a public case with.
check::ExpectedFiles kept(const CourseTree& tree, const judge::LabPlan& lab, const course::Case& of) {
  const fs::path folder = check::expected_folder(tree.course, lab.lab);
  return {folder / of.file, of.is_mesh() ? fs::path() : folder / (of.name + ".mask.png")};
}

/// "mesa22" of "… Mesa 22.3.6", "nvidia580" of "… NVIDIA 580.95.05", else "gpu".
std::string version_of(const std::string& says) {
  const auto after = [&](const std::string& maker) -> std::string {
    const std::size_t place = says.rfind(maker + " ");
    if (place == std::string::npos) return {};
    const std::string version = says.substr(place + maker.size() + 1);
    return version.substr(0, version.find('.'));
  };
  if (const std::string mesa = after("Mesa"); !mesa.empty()) return "mesa" + mesa;
  if (const std::string nvidia = after("NVIDIA"); !nvidia.empty()) return "nvidia" + nvidia;
  return "gpu";
}

/// 0 where both are the same bytes; NaN where nothing can be compared.
double distance(const course::Case& of, const check::ExpectedFiles& expected, const fs::path& picture) {
  return check::judge(of, expected, picture).error;
}

}  // namespace

std::vector<Renderer> known_renderers(const fs::path& rsqrt_library) {
  using Variables = std::vector<std::pair<std::string, std::string>>;
  // The drivers that EGL asks, in its own order; Studio would name Mesa's alone.
  const Variables all_drivers = {
      {"LIBGL_ALWAYS_SOFTWARE", "0"},
      {"__EGL_VENDOR_LIBRARY_FILENAMES",
       "/usr/share/glvnd/egl_vendor.d/10_nvidia.json:/usr/share/glvnd/egl_vendor.d/50_mesa.json"}};
  const auto rsqrt = [&](const char* how) {
    return Variables{{"LD_PRELOAD", rsqrt_library.string()}, {"TEXEL_RSQRT", how}};
  };
  return {{"llvmpipe_osmesa", "osmesa", "llvmpipe", {}},
          {"llvmpipe_egl", "egl", "llvmpipe", {}},
          {"llvmpipe_128", "egl", "llvmpipe", {{"LP_NATIVE_VECTOR_WIDTH", "128"}}},
          {"llvmpipe_256", "egl", "llvmpipe", {{"LP_NATIVE_VECTOR_WIDTH", "256"}}},
          {"llvmpipe_sse2", "egl", "llvmpipe", {{"GALLIUM_OVERRIDE_CPU_CAPS", "sse2"}}},
          {"llvmpipe_sse41", "egl", "llvmpipe", {{"GALLIUM_OVERRIDE_CPU_CAPS", "sse4.1"}}},
          {"llvmpipe_avx", "egl", "llvmpipe", {{"GALLIUM_OVERRIDE_CPU_CAPS", "avx"}}},
          {"llvmpipe_rsqrt_exact", "egl", "llvmpipe", rsqrt("exact")},
          {"llvmpipe_rsqrt_high", "egl", "llvmpipe", rsqrt("high")},
          {"llvmpipe_rsqrt_low", "egl", "llvmpipe", rsqrt("low")},
          {"softpipe_osmesa", "osmesa", "softpipe", {{"GALLIUM_DRIVER", "softpipe"}}},
          {"softpipe_egl", "egl", "softpipe", {{"GALLIUM_DRIVER", "softpipe"}}},
          // It complains on standard error where that variable is missing.
          {"zink_egl", "egl", "zink", {{"MESA_LOADER_DRIVER_OVERRIDE", "zink"}, {"XDG_RUNTIME_DIR", "/tmp"}}},
          {"hardware_egl", "egl", "", all_drivers}};
}

void with(const Renderer& renderer, const std::function<void()>& action) {
  const Surroundings surroundings(renderer);
  action();
}

std::string draw_by(const Renderer& renderer, const CourseTree& tree, const fs::path& out) {
  const Surroundings surroundings(renderer);
  const std::string says = found(renderer, tree);
  if (says.empty() || (renderer.says.empty() && check::is_software(says))) return {};
  const std::string name = version_of(says) + "_" + renderer.name;
  const fs::path folder = out / name;
  fs::remove_all(folder);
  for (const char* seed : kSeeds) {
    const std::vector<judge::LabPlan> plans = plans_of(tree, seed, out / "models");
    in_parallel(processors(), plans.size(), [&](std::size_t i) {
      const check::Studio own = studio(tree, plans[i].lab, renderer.context);
      const fs::path to = folder / seed / plans[i].lab.folder;
      fs::create_directories(to);
      if (plans[i].cases.empty()) return;
      check::draw_all(own, plans[i].cases, to);
      check::draw_all(own, plans[i].masks(), to / "mask");
    });
  }
  write_file(folder / check::kRendererFile, says + "\n");
  return name;
}

std::vector<std::string> passed_by(const Renderer& renderer, const CourseTree& tree,
                                   const std::function<void(const std::string&)>& say) {
  const Surroundings surroundings(renderer);
  std::vector<std::string> faults;
  if (found(renderer, tree).empty()) {
    say(renderer.name + ": not on this machine");
    return faults;
  }
  const BuiltTree starter = starter_tree(tree.course, tree.cache);
  References course(solution_tree(tree.course, tree.build, starter), starter, tree.cache, renderer.context);
  // By what this renderer draws, as grade has it, or by what is kept, as check has it: one of them is enough.
  const auto is_passed = [&](const judge::LabPlan& lab, const std::string& step, const fs::path& folder) {
    return std::all_of(lab.cases.begin(), lab.cases.end(), [&](const course::Case& of) {
      const fs::path picture = folder / of.file;
      return of.step != step || check::judge(of, course.expected(lab, of), picture).passed ||
             (!of.hidden && check::judge(of, kept(tree, lab, of), picture).passed);
    });
  };
  for (const judge::LabPlan& lab : full_plan(tree.labs, kSeeds.front(), tree.cache / "models")) {
    course.prepare(lab);
    for (const course::Step& step : lab.lab.steps)
      if (is_passed(lab, step.id, course.starter_folder(lab)))
        faults.push_back(fmt::format("{}: the starter passes step {}", renderer.name, step.id));
    std::vector<const material::Mutant*> mutants;
    for (const material::Mutant& mutant : course.mutants())
      if (!mutant.step.empty() && std::stoi(mutant.step) == lab.lab.number) mutants.push_back(&mutant);
    std::vector<char> passed(mutants.size());
    in_parallel(processors(), mutants.size(), [&](std::size_t i) {
      passed[i] = is_passed(lab, mutants[i]->step, course.drawn_by(lab, *mutants[i]));
    });
    for (std::size_t i = 0; i < mutants.size(); ++i)
      if (passed[i] != 0)
        faults.push_back(
            fmt::format("{}: mutant {} passes step {}", renderer.name, mutants[i]->name, mutants[i]->step));
    say(fmt::format("{}: lab {}, {} mutants", renderer.name, lab.lab.number, mutants.size()));
  }
  return faults;
}

double Spread::most() const {
  double most = 0;
  for (const auto& [renderer, error] : by)
    most = std::isnan(error) ? std::numeric_limits<double>::infinity() : std::max(most, error);
  return most;
}

std::vector<Spread> spreads(const CourseTree& tree, const fs::path& drawn, const std::string& reference) {
  std::vector<std::string> renderers;
  for (const fs::directory_entry& entry : fs::directory_iterator(drawn))
    if (fs::exists(entry.path() / check::kRendererFile))
      renderers.push_back(entry.path().filename().string());
  std::sort(renderers.begin(), renderers.end());
  std::map<std::pair<std::string, std::string>, Spread> known;
  std::vector<Spread> all;
  for (const course::Lab& lab : tree.labs)
    for (const course::GradedCase& one : lab.cases)
      all.push_back({lab.number, one.name, name_of(unit_of(one.view)), one.limit, {}});
  for (const char* seed : kSeeds)
    for (const judge::LabPlan& lab : plans_of(tree, seed, drawn / "models"))
      in_parallel(processors(), lab.cases.size(), [&](std::size_t i) {
        const course::Case& of = lab.cases[i];
        const fs::path folder = fs::path(seed) / lab.lab.folder;
        check::ExpectedFiles expected = kept(tree, lab, of);
        if (of.hidden) {
          expected.reference = drawn / reference / folder / of.file;
          if (!of.is_mesh()) expected.mask = drawn / reference / folder / "mask" / (of.name + ".png");
        }
        const auto place = std::find_if(all.begin(), all.end(), [&](const Spread& spread) {
          return spread.lab == lab.lab.number && spread.name == of.name;
        });
        for (const std::string& renderer : renderers) {
          const double error = distance(of, expected, drawn / renderer / folder / of.file);
          double& most = place->by[renderer];
          most = std::isnan(error) || std::isnan(most) ? std::nan("") : std::max(most, error);
        }
      });
  return all;
}

}  // namespace texel::grade
