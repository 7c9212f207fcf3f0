// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "reports/reports.hpp"
#include "wording.hpp"

namespace texel::reports {
namespace {

/// Escaped text that cannot ask for a file: Jenkins and GitLab take [[ATTACHMENT|path]] out of any output.
std::string quoted(const std::string& text) {
  std::string result;
  for (const char c : escaped(text)) {
    if (c == '[' && result.ends_with('[')) result += ' ';
    result += c;
  }
  return result;
}

struct Counts {
  std::size_t tests = 0, failures = 0, errors = 0;

  void operator+=(const Counts& other) {
    tests += other.tests;
    failures += other.failures;
    errors += other.errors;
  }
  [[nodiscard]] std::string attributes() const {
    return fmt::format("tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"0\"", tests, failures, errors);
  }
};

std::string attachments(const judge::CaseResult& result, const std::filesystem::path& folder) {
  std::string lines;
  for (const std::string& path : {result.picture, result.reference})
    if (!path.empty()) lines += "\n[[ATTACHMENT|" + escaped((folder / path).string()) + "]]";
  return lines;
}

std::string test_case(const judge::CaseResult& result, const judge::StepResult& step,
                      const std::filesystem::path& folder, Counts& counts) {
  ++counts.tests;
  const std::string opening = fmt::format("  <testcase classname=\"{}.{}\" name=\"{}\"", quoted(result.lab),
                                          quoted(step.id), quoted(result.name));
  if (result.passed() && result.is_alone())
    return fmt::format("{}>\n   <system-out>{}</system-out>\n  </testcase>\n", opening,
                       quoted(judging(step)));
  if (result.passed()) return opening + "/>\n";
  ++counts.failures;
  const std::string typed = command(result);
  std::string said;
  for (const std::string& line : {cause(result.mistake_says), judging(step), distance(result), place(step),
                                  hint(step).empty() ? "" : "Hint: " + hint(step), typed})
    if (!line.empty()) said += "\n" + quoted(line);
  const std::string files = attachments(result, folder);
  return fmt::format("{}>\n   <failure message=\"{}\" type=\"{}\">{}</failure>\n{}  </testcase>\n", opening,
                     quoted(result.message), result.mistake.empty() ? "difference" : quoted(result.mistake),
                     said, files.empty() ? "" : fmt::format("   <system-out>{}\n</system-out>\n", files));
}

std::string suite(const std::string& name, const Counts& counts, const std::string& cases,
                  const std::string& errors = {}) {
  return fmt::format(" <testsuite name=\"{}\" {}>\n{}{} </testsuite>\n", quoted(name), counts.attributes(),
                     cases,
                     errors.empty() ? "" : fmt::format("  <system-err>{}</system-err>\n", quoted(errors)));
}

}  // namespace

std::string junit(const store::StudentResult& student, const std::filesystem::path& folder) {
  Counts all;
  std::string suites;
  std::string logs;
  for (const store::CompilerLog& log : student.logs) logs += log.file + ":\n" + log.text + "\n";
  std::string faults;  // that kept the whole from being judged: a test each
  const auto add_fault = [&](const char* name, const char* kind, std::size_t& count, const std::string& why) {
    if (why.empty()) return;
    ++count, ++all.tests;
    faults += fmt::format(
        "  <testcase classname=\"submission\" name=\"{}\">\n   <{} message=\"{}\"/>\n"
        "  </testcase>\n",
        name, kind, quoted(why));
  };
  add_fault("graded", "error", all.errors, student.unmarked());
  add_fault("readable", "failure", all.failures, student.fault);
  add_fault("compiles", "failure", all.failures, logs.empty() ? "" : "A file does not compile.");
  if (all.tests > 0) suites += suite("submission", all, faults, logs);
  for (const judge::LabResult& lab : student.labs) {
    Counts counts;
    std::string cases, notes;
    for (const judge::StepResult& step : lab.steps)
      for (const judge::CaseResult& result : step.cases) cases += test_case(result, step, folder, counts);
    for (const std::string& note : lab.notes) notes += note + "\n";
    suites += suite(lab.lab.folder, counts, cases, notes);
    all += counts;
  }
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"{}\" {}>\n{}</testsuites>\n",
      quoted(student.name), all.attributes(), suites);
}

}  // namespace texel::reports
