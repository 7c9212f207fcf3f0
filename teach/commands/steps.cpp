// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cctype>
#include <map>
#include <set>
#include <string>

#include "commands.hpp"
#include "core/files.hpp"
#include "core/json.hpp"
#include "core/plain_text.hpp"
#include "course/markers.hpp"
#include "course_commands.hpp"
#include "grade/submission.hpp"

namespace texel::commands {
namespace {

using Steps = std::map<std::string, std::string>;  // what stands between the markers, by step

std::string without_blanks(std::string text) {
  std::erase_if(text, [](unsigned char c) { return std::isspace(c) != 0; });
  return text;
}

/// The lines that the starter's file does not have.
std::string new_lines(const std::string& text, const std::string& first) {
  std::set<std::string> given;
  for (const std::string& line : lines_of(first)) given.insert(without_blanks(line));
  std::string result;
  for (const std::string& line : lines_of(text))
    if (!given.contains(without_blanks(line))) result += line + "\n";
  return result;
}

}  // namespace

Exit print_steps(const GradeCommand& command) {
  std::set<std::string> asked;
  for (const course::Lab& lab : tools::chosen_labs(command.labs))
    for (const course::Step& step : lab.steps) asked.insert(step.id);
  const std::filesystem::path root = tools::course_root();
  const std::vector<std::string> allowed = course::step_files(root);
  Json solution = Json::object(), submissions = Json::array();
  std::map<std::string, Steps> given;  // by file: the steps that are asked for, as the starter has them
  for (const std::string& file : allowed)
    for (const auto& [step, text] : course::step_texts(course::first_text(root, file)))
      if (asked.contains(step)) {
        given[file][step] = without_blanks(text);
        const std::string solved =
            course::with_steps(read_file(root / file), file, [](const std::string&) { return true; });
        solution[step] = solution.value(step, "") + course::step_texts(solved).at(step);
      }

  for (const grade::Entry& entry : grade::read_class(command.class_folder)) {
    const grade::Submission taken = grade::unpack(
        entry, allowed, [&](const std::string& file) { return course::first_text(root, file); });
    Json steps = Json::object(), damaged = Json::object(), ignored = Json::object();
    for (const auto& [file, text] : taken.files) {
      const auto of_file = given.find(file);
      if (of_file == given.end()) continue;
      const std::string first = course::first_text(root, file);
      if (const auto faults = course::marker_faults(text, first, file); !faults.empty()) {
        damaged[file] = plain_text(faults.begin()->second);
        steps[file] = new_lines(text, first);
        continue;
      }
      for (const auto& [step, part] : course::step_texts(text))
        if (const auto starter = of_file->second.find(step);
            starter != of_file->second.end() && without_blanks(part) != starter->second)
          steps[step] = steps.value(step, "") + part;
    }
    for (const store::Ignored& file : taken.ignored) ignored[file.path] = file.reason;
    submissions.push_back(
        {{"entry", plain_text(entry.path.lexically_relative(command.class_folder).string())},
         {"id", entry.id},
         {"fault", taken.fault},
         {"steps", steps},
         {"damaged", damaged},
         {"ignored", ignored}});
  }
  fmt::print("{}\n", to_text({{"solution", solution}, {"submissions", submissions}}));
  return Exit::holds;
}

}  // namespace texel::commands
