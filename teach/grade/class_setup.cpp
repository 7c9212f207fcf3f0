// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sodium.h>

#include <algorithm>
#include <array>

#include "cache.hpp"
#include "class_run.hpp"
#include "core/error.hpp"
#include "core/files.hpp"
#include "core/parallel.hpp"
#include "core/plain_text.hpp"
#include "course/markers.hpp"
#include "grade/hidden_cases.hpp"
#include "material/starter.hpp"

namespace texel::grade {
namespace {

namespace fs = std::filesystem;

/// The course's secret, from which hidden cases are drawn.
std::string read_seed(const fs::path& file) {
  if (!fs::exists(file)) {
    std::array<unsigned char, 16> bytes{};
    if (sodium_init() < 0) throw Error::failed("the system has no source of random numbers");
    randombytes_buf(bytes.data(), bytes.size());
    write_file(file, fmt::format("{:02x}\n", fmt::join(bytes, "")));
    fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
  }
  std::string seed = read_file(file);
  while (!seed.empty() && (seed.back() == '\n' || seed.back() == '\r' || seed.back() == ' ')) seed.pop_back();
  if (seed.size() < 8)
    throw Error::failed("does not contain a seed of at least 8 characters", {file.string()},
                        "write your course's secret into it");
  return seed;
}

}  // namespace

ClassSetup prepare(const GradeOptions& options, unsigned jobs) {
  ClassSetup p;
  p.labs = course::read_labs(options.course / "labs");
  std::erase_if(p.labs, [&](const course::Lab& lab) {
    const bool is_asked_for = options.labs.empty() || std::ranges::count(options.labs, lab.number) > 0;
    return lab.steps.empty() || !is_asked_for;
  });
  if (p.labs.empty()) throw Error::usage("none of these labs has steps");
  p.seed = read_seed(options.seed_file.empty() ? options.out / "seed.txt" : options.seed_file);
  p.course = std::make_unique<References>(options.course, options.build, options.cache, options.context);
  p.starter = p.course->starter();
  p.workshop = std::make_unique<Workshop>(p.starter, options.cache, options.run);
  p.allowed = course::step_files(p.starter.source);
  for (const material::StarterFile& file : material::starter_files(options.course))
    p.given[lower_case(file.path)] = file.text ? file.text->size() : fs::file_size(file.source);
  for (const std::string& path : p.allowed) {
    p.solution[path] =
        course::with_steps(read_file(options.course / path), path, [](const std::string&) { return true; });
    for (const auto& [step, text] : course::step_texts(p.solution[path])) p.files_of_step[step].insert(path);
  }
  p.models = options.cache / "models" / fingerprint({p.seed}).substr(0, 16);
  p.plans = full_plan(p.labs, p.seed, p.models);
  in_parallel(jobs, p.plans.size(), [&](std::size_t i) {
    p.course->prepare(p.plans[i]);
    p.course->known_mistakes(p.plans[i]);  // a broken file ends the run before it judges anybody
  });
  return p;
}

}  // namespace texel::grade
