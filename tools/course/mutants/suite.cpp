// SPDX-License-Identifier: MIT
#include "course/mutants/suite.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <regex>
#include <set>

#include "core/error.hpp"
#include "core/files.hpp"
#include "core/json.hpp"
#include "core/parallel.hpp"
#include "params/set.hpp"
#include "processes.hpp"

namespace texel::tools {
namespace {

namespace fs = std::filesystem;

/// The slowest test of a lab takes 12 s on a free machine.
constexpr int kTimeoutSeconds = 120;

std::string quoted(const fs::path& path) {
  return params::shell_quoted(path.string());
}

/// Runs a line of shell; its exit code.
int shell(const std::string& line) {
  int status = 0;
  run_all({{"/bin/sh", "-c", line}}, 1, [&](std::size_t, int ended) { status = ended; });
  return status;
}

std::string lower(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

/// "05_normal_map" of "shaders/05_normal_map/…" is lab 5; 0 for a folder that is no lab's.
int lab_of(const fs::path& folder) {
  const std::string name = folder.filename().string();
  return name.size() > 3 && name[2] == '_' ? std::atoi(name.substr(0, 2).c_str()) : 0;
}

/// The labs whose shaders include a file of shaders/lib.
std::vector<int> labs_with(const fs::path& shaders, const std::string& library_file) {
  std::vector<int> labs;
  for (const fs::directory_entry& folder : fs::directory_iterator(shaders)) {
    const int lab = lab_of(folder.path());
    if (lab == 0) continue;
    for (const fs::directory_entry& shader : fs::directory_iterator(folder))
      if (read_file(shader.path()).find("\"lib/" + library_file + "\"") != std::string::npos) {
        labs.push_back(lab);
        break;
      }
  }
  return labs;
}

/// What a test's key has that is about the file, the nearest first.
std::vector<std::regex> subjects_of(const fs::path& tree, const fs::path& file) {
  const fs::path folder = file.parent_path(), stem = file.stem();
  std::vector<int> labs;
  if (const int lab = lab_of(folder); lab != 0) labs = {lab};
  if (folder == "shaders/lib") labs = labs_with(tree / "shaders", file.filename().string());
  if (!labs.empty()) return {std::regex(fmt::format("lab_?0*({})(?![0-9])", fmt::join(labs, "|")))};
  if (*file.begin() != "common") return {};
  // "unit_mesh tangentmethods.…" is about common/mesh/tangents.cpp.
  std::string subject = stem.string();
  if (subject.ends_with('s')) subject.pop_back();
  const std::string program = "unit_" + std::next(file.begin())->string() + " ";
  return {std::regex(program + "[^.]*" + subject), std::regex(program)};
}

/// Tests of what the libraries alone make and refuse. They take long.
bool is_of_libraries(const Test& test) {
  return test.name.starts_with("assets.") || test.name.starts_with("compile_fail.");
}

/// Whether the file can have a part in what the test runs. The assets and what must not compile are made of
/// four libraries; and no test named after one lab runs another.
bool can_notice(const Test& test, const fs::path& file, const std::vector<std::regex>& subjects) {
  static const std::regex any_lab("lab_?0*[1-9]");
  if (is_of_libraries(test)) {
    const fs::path library = file.parent_path();
    return library == "common/core" || library == "common/params" || library == "common/image" ||
           library == "common/procedural";
  }
  // What draws nothing never sees a shader.
  static const std::regex draws_nothing("unit_(?!app$).*|mutants_test");
  if (*file.begin() == "shaders" && std::regex_match(test.target, draws_nothing)) return false;
  const bool is_of_one_lab = lab_of(file.parent_path()) != 0;
  return !is_of_one_lab || std::regex_search(test.key, subjects.front()) ||
         !std::regex_search(test.key, any_lab);
}

std::string unescaped(std::string text) {
  for (const auto& [entity, sign] :
       {std::pair("&quot;", "\""), {"&apos;", "'"}, {"&lt;", "<"}, {"&gt;", ">"}, {"&amp;", "&"}})
    for (std::size_t at = text.find(entity); at != std::string::npos; at = text.find(entity, at + 1))
      text.replace(at, std::string_view(entity).size(), sign);
  return text;
}

struct TestRun {
  double seconds = 0;
  std::string status;  ///< ctest's word: run, fail, notrun, disabled
};

/// What ctest's JUnit file says of each test, by name.
std::map<std::string, TestRun> read_junit(const fs::path& xml) {
  static const std::regex entry("<testcase name=\"([^\"]*)\"[^>]* time=\"([^\"]*)\" status=\"([^\"]*)\"");
  const std::string text = read_file(xml);
  std::map<std::string, TestRun> runs;
  for (std::sregex_iterator found(text.begin(), text.end(), entry), end; found != end; ++found)
    runs[unescaped((*found)[1])] = {std::stod((*found)[2]), (*found)[3]};
  return runs;
}

/// Whether a log has the message that one of these files, as a shader, does not compile.
bool has_shader_error(const fs::path& log, const std::vector<std::string>& files) {
  const std::string text = read_file(log);
  return std::any_of(files.begin(), files.end(), [&](const std::string& file) {
    const std::regex message(fs::path(file).filename().string() + ":[0-9]+:[0-9]+: error:");
    return file.starts_with("shaders/") && std::regex_search(text, message);
  });
}

/// The name without what GoogleTest adds for a parameter.
std::string short_name(const std::string& name) {
  return name.substr(0, name.find("  #"));
}

}  // namespace

std::optional<Order> order_of(const Test& test, const fs::path& tree, const std::string& file) {
  const std::vector<std::regex> subjects = subjects_of(tree, file);
  if (!can_notice(test, file, subjects)) return std::nullopt;
  const auto found = std::find_if(subjects.begin(), subjects.end(), [&](const std::regex& subject) {
    return std::regex_search(test.key, subject);
  });
  const auto rank = static_cast<int>(found - subjects.begin());
  const auto last = static_cast<int>(subjects.size()) + 1;
  const bool runs_last = is_of_libraries(test) || test.name.starts_with("window.");
  const double pace = std::max(0.0, std::ceil(std::log2(test.seconds / kQuickSeconds)));
  return Order{runs_last ? last : rank, static_cast<int>(pace)};
}

Suite::Suite(fs::path tree, fs::path logs) : tree_(std::move(tree)), logs_(std::move(logs)) {
  fs::create_directories(logs_);
}

void Suite::prepare() const {
  const fs::path log = logs_ / "configure.log";
  // A mutant may well leave a variable unused: that is no reason not to build.
  const int status =
      shell(fmt::format("cd {0} && cmake --preset release -B build/release "
                        "-D TEXEL_TESTS=ON -D TEXEL_WARNINGS_AS_ERRORS=OFF >{1} 2>&1",
                        quoted(tree_), quoted(log)));
  if (status != 0) throw Error::failed("cmake failed; see its log", {log.string()});
  const fs::path build_log = logs_ / "build.log";
  if (!build({}, build_log))
    throw Error::failed("the tree does not build; see the log", {build_log.string()});
}

bool Suite::build(const std::set<std::string>& targets, const fs::path& log) const {
  const std::string of = targets.empty() ? "" : fmt::format("--target {}", fmt::join(targets, " "));
  return shell(fmt::format("cd {0} && cmake --build build/release "
                           "--parallel {1} {2} >{3} 2>&1",
                           quoted(tree_), processors(), of, quoted(log))) == 0;
}

void Suite::run(const std::vector<int>& numbers, const fs::path& xml, const fs::path& log) const {
  std::error_code ignored;
  fs::remove(xml, ignored);
  // The driver's cache of compiled shaders would keep what other mutants compiled; TEXEL_ROOT would name
  // another tree. ctest's status says no more than its file.
  shell(fmt::format(
      "cd {} && env -u TEXEL_ROOT MESA_SHADER_CACHE_DISABLE=true ctest --test-dir build/release "
      "-I 0,0,0,{} --parallel {} --timeout {} --output-on-failure --output-junit {} >{} 2>&1",
      quoted(tree_), fmt::join(numbers, ","), processors(), kTimeoutSeconds, quoted(xml), quoted(log)));
  if (!fs::exists(xml)) throw Error::failed("ctest failed; see its log", {log.string()});
}

void Suite::list() {
  const fs::path file = logs_ / "tests.json";
  const int status = shell(fmt::format("cd {} && ctest --test-dir build/release --show-only=json-v1 >{}",
                                       quoted(tree_), quoted(file)));
  const auto json = json_or_null(read_file(file));
  if (status != 0 || json.is_discarded())
    throw Error::failed("ctest does not list its tests", {file.string()});
  tests_.clear();
  for (const auto& entry : json.at("tests")) {
    Test test;
    test.number = static_cast<int>(tests_.size()) + 1;
    test.name = entry.at("name");
    const auto command = entry.value("command", std::vector<std::string>{""});  // none: it is not built
    const fs::path program = command.front();
    test.key = lower(program.filename().string() + " " + test.name);
    if (program.string().starts_with(tree_.string())) test.target = program.filename();
    for (const auto& property : entry.value("properties", Json::array()))
      if (property.at("name") == "LABELS")
        for (const std::string& label : property.at("value").get<std::vector<std::string>>())
          test.is_used &= label != "tree" && label != "class";
    tests_.push_back(std::move(test));
  }
}

void Suite::measure(const std::string& state) {
  list();
  const fs::path xml = logs_ / "unchanged.xml";
  const fs::path known = logs_ / "unchanged.state";
  if (!fs::exists(known) || read_file(known) != state) {
    std::vector<int> all;
    for (const Test& test : tests_)
      if (test.is_used) all.push_back(test.number);
    run(all, xml, logs_ / "unchanged.log");
    write_file(known, state);
  }
  const std::map<std::string, TestRun> runs = read_junit(xml);
  for (Test& test : tests_) {
    const auto found = runs.find(test.name);
    if (!test.is_used) continue;
    test.is_used = found != runs.end() && found->second.status == "run";
    if (found != runs.end()) test.seconds = found->second.seconds;
    if (found != runs.end() && found->second.status == "fail")
      fmt::print(stderr, "texel: {} fails even without a mutant and is left out\n", short_name(test.name));
  }
  if (std::none_of(tests_.begin(), tests_.end(), [](const Test& test) { return test.is_used; }))
    throw Error::failed("no test passes in the unchanged tree", {(logs_ / "unchanged.log").string()});
}

Verdict Suite::judge(const std::vector<std::string>& files, const std::string& name) const {
  const fs::path log = logs_ / (name + ".log"), xml = logs_ / "mutant.xml";
  std::map<Order, std::vector<const Test*>> stages;
  for (const Test& test : tests_) {
    std::optional<Order> first;
    for (const std::string& file : files)
      if (const auto order = order_of(test, tree_, file); order && (!first || *order < *first)) first = order;
    if (test.is_used && first) stages[*first].push_back(&test);
  }
  for (const auto& [order, tests] : stages) {
    std::set<std::string> targets;
    std::vector<int> numbers;
    for (const Test* test : tests) {
      targets.insert(test->target);
      numbers.push_back(test->number);
    }
    if (targets.contains("")) targets.clear();
    if (!build(targets, log)) return {false, {}};
    run(numbers, xml, log);
    std::vector<std::string> failed;
    for (const auto& [test, result] : read_junit(xml))
      if (result.status == "fail") failed.push_back(short_name(test));
    if (!failed.empty()) return {!has_shader_error(log, files), failed};
  }
  return {};
}

}  // namespace texel::tools
