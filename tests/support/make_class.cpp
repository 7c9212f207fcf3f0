// SPDX-License-Identifier: MIT
// Makes a class folder whose grades are known: make_class --root TREE --out DIR --labs 8,9 [--kinds …]
// [--limit N]
//
//   entries          what they hand in                                     what must come out
//
//   solution-N       everything solved                                     full marks
//   starter-N        nothing solved                                        0
//   steps-9.2        everything up to step 9.2 solved                      exactly these steps pass
//   mutant-NAME      the solution with one of tests/mutants                its step alone fails, and is named
//   mistake-NAME     the same, with one for each step; and some more       its step alone fails
//   equivalent-NAME  the solution with one of tests/equivalents            full marks
//   threat-NAME      the solution with one of tests/threats, hostile files 0 on what it fakes
//   slow-NAME        the same, from tests/threats/slow.toml                0 on what it fakes
//   broken-NAME      an archive that is none, or is hostile                0
//
// Folders, zips and tarballs mix, some named as Canvas and Moodle do. Beside the folder comes DIR.json: for
// each student's id the entry's kind and name, and what must come out: `passes`, the steps that must have
// full marks while no other passes; `zero`, the steps that must score 0; `fails`, a step that must not pass;
// `mistake`, its name; `fault`, that nothing can be read.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "archives.hpp"
#include "core/error.hpp"
#include "core/files.hpp"
#include "core/json.hpp"
#include "course/lab_file.hpp"
#include "course/markers.hpp"
#include "grade/submission.hpp"
#include "judge/results.hpp"
#include "material/mutant_file.hpp"

namespace texel::test {
namespace {

namespace fs = std::filesystem;
using Files = std::map<std::string, std::string>;

struct Options {
  fs::path root, out;
  std::vector<int> labs;
  std::vector<std::string> kinds = {"solution",   "starter", "prefix", "mutant",
                                    "equivalent", "threat",  "files",  "broken"};
  std::size_t limit = 100'000;
};

void replace_all(std::string& text, const std::string& what, const std::string& by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != text.npos; at += by.size())
    text.replace(at, what.size(), by);
}

/// At most so many of a list, from all over it.
template <class Item>
std::vector<Item> some_of(const std::vector<Item>& all, std::size_t count) {
  std::vector<Item> some;
  count = std::min(count, all.size());
  for (std::size_t i = 0; i < count; ++i) some.push_back(all[i * all.size() / count]);
  return some;
}

class ClassMaker {
 public:
  explicit ClassMaker(Options options) : options_(std::move(options)) {
    if (fs::exists(options_.out) && !fs::is_empty(options_.out))
      throw Error::usage(fmt::format("'{}' holds something already", options_.out.string()),
                         "name a new folder");
    fs::create_directories(options_.out);
    options_.root = fs::canonical(options_.root);
    options_.out = fs::canonical(options_.out);
    for (const std::string& file : course::step_files(options_.root))
      sources_[file] = read_file(options_.root / file);
    for (const course::Lab& lab : course::read_labs(options_.root / "labs"))
      for (const course::Step& step : lab.steps) {
        order_.push_back(step.id);
        if (is_asked(lab.number)) asked_.push_back(step.id);
      }
  }

  void make() {
    const std::vector<std::pair<const char*, std::function<void()>>> makers = {
        {"solution", [&] { solutions(); }},
        {"starter", [&] { starters(); }},
        {"prefix", [&] { prefixes(); }},
        {"mutant", [&] { changes(some_of(fitting("tests/mutants"), options_.limit), "mutant"); }},
        {"mistake", [&] { changes(one_for_each_step(), "mistake"); }},
        {"equivalent", [&] { changes(some_of(fitting("tests/equivalents"), options_.limit), "equivalent"); }},
        {"threat", [&] { threats("threat"); }},
        {"slow", [&] { threats("slow"); }},
        {"files", [&] { hostile_files(); }},
        {"broken", [&] { broken(); }}};
    for (const auto& [kind, maker] : makers)
      if (std::find(options_.kinds.begin(), options_.kinds.end(), kind) != options_.kinds.end()) maker();
    write_expectations();
  }

  [[nodiscard]] std::size_t size() const { return expected_.size(); }

 private:
  [[nodiscard]] bool is_asked(int lab) const {
    return std::find(options_.labs.begin(), options_.labs.end(), lab) != options_.labs.end();
  }
  static int lab_of(const std::string& step) { return std::stoi(step); }
  static int lab_of_file(const std::string& file) { return std::stoi(file.substr(file.find('/') + 1)); }

  /// The steps that are graded and of which `chosen` says so.
  [[nodiscard]] Json steps(const std::function<bool(const std::string&)>& chosen) const {
    Json list = Json::array();
    for (const std::string& step : asked_)
      if (chosen(step)) list.push_back(step);
    return list;
  }
  [[nodiscard]] Json all_steps() const {
    return steps([](const std::string&) { return true; });
  }

  /// What a student has who solved these steps; `changed` stands for a file of the course.
  [[nodiscard]] Files student_files(const std::function<bool(const std::string&)>& solved,
                                    const Files& changed = {}) const {
    Files files;
    for (const auto& [path, text] : sources_) {
      const auto other = changed.find(path);
      files[path] = course::with_steps(other == changed.end() ? text : other->second, path, solved);
    }
    return files;
  }
  [[nodiscard]] Files solution(const Files& changed = {}) const {
    return student_files([](const std::string&) { return true; }, changed);
  }
  [[nodiscard]] Files starter() const {
    return student_files([](const std::string&) { return false; });
  }

  // --- Entries ---------------------------------------------------------------------------------------------

  void expect(const std::string& entry, const std::string& kind, const std::string& name,
              const Json& outcome) {
    Json& json = expected_[entry];
    json = {{"entry", entry}, {"kind", kind}, {"name", name}};
    json.update(outcome);
  }

  static std::string packed(Format format, const Files& files) {
    std::vector<Packed> list;
    for (const auto& [path, text] : files) list.push_back({path, text});
    return pack(format, list);
  }

  void write_folder(const fs::path& folder, const Files& files) const {
    for (const auto& [path, text] : files) {
      fs::create_directories((folder / path).parent_path());
      write_file(folder / path, text);
    }
  }

  /// An entry in one of the forms.
  void put(const std::string& kind, const std::string& name, const Files& files, const Json& outcome) {
    std::string entry = kind + "-" + name;
    // By the name alone, so that a student has the same id in every class.
    std::size_t turn = 0;
    for (const char c : entry) turn = (turn * 31 + static_cast<unsigned char>(c)) % 9973;
    switch (turn % 5) {
      case 0:
        write_folder(options_.out / entry, files);
        break;
      case 1:
        write_file(options_.out / (entry += ".zip"), packed(Format::zip, files));
        break;
      case 2:
        write_file(options_.out / (entry += ".tar.gz"), packed(Format::tar_gz, files));
        break;
      case 3: {  // Canvas
        std::erase_if(entry, [](char c) { return c == '-' || c == '.'; });
        entry += fmt::format("_{}_{}_labs.zip", 1000 + turn, 5000 + turn);
        Files below;
        for (const auto& [path, text] : files) below["my labs/" + path] = text;
        write_file(options_.out / entry, packed(Format::zip, below));
        break;
      }
      default:  // Moodle
        entry += fmt::format("_{}_assignsubmission_file", 1000 + turn);
        fs::create_directories(options_.out / entry);
        write_file(options_.out / entry / "labs.zip", packed(Format::zip, files));
    }
    expect(entry, kind, name, outcome);
  }

  void put_file(const std::string& kind, const std::string& entry, const std::string& bytes,
                const Json& outcome) {
    write_file(options_.out / entry, bytes);
    expect(entry, kind, entry, outcome);
  }

  // --- Kinds -----------------------------------------------------------------------------------------------

  void solutions() {
    for (const char* name : {"1", "2", "3"}) put("solution", name, solution(), {{"passes", all_steps()}});
  }

  [[nodiscard]] Json nothing() const { return {{"passes", Json::array()}, {"zero", all_steps()}}; }
  [[nodiscard]] Json unreadable() const {
    return {{"passes", Json::array()}, {"zero", all_steps()}, {"fault", true}};
  }

  void starters() {
    for (const char* name : {"1", "2"}) put("starter", name, starter(), nothing());
  }

  void prefixes() {
    std::vector<std::string> last(asked_.begin(), asked_.end() - 1);  // with the last step it is the solution
    for (const std::string& step : some_of(last, options_.limit)) {
      const auto end = std::find(order_.begin(), order_.end(), step) + 1;
      const std::set<std::string> solved(order_.begin(), end);
      const auto is_solved = [&](const std::string& one) { return solved.count(one) > 0; };
      put("steps", step, student_files(is_solved),
          {{"passes", steps(is_solved)},
           {"zero", steps([&](const std::string& other) { return !is_solved(other); })}});
    }
  }

  /// Those that a student can make who is graded in these labs.
  [[nodiscard]] std::vector<material::Mutant> fitting(const char* catalogue) const {
    std::vector<material::Mutant> fit;
    for (const material::Mutant& mutant : material::read_catalogue(options_.root / catalogue))
      if (sources_.count(mutant.file) > 0 && !mutant.step.empty() && is_asked(lab_of(mutant.step)))
        fit.push_back(mutant);
    return fit;
  }

  /// The first mutant of each step, and mistakes on which many other steps build.
  [[nodiscard]] std::vector<material::Mutant> one_for_each_step() const {
    std::vector<material::Mutant> chosen;
    for (const material::Mutant& mutant : fitting("tests/mutants"))
      if (std::none_of(chosen.begin(), chosen.end(),
                       [&](const material::Mutant& one) { return one.step == mutant.step; }))
        chosen.push_back(mutant);
    const auto add = [&](const char* name, const char* step, const char* file, const char* what,
                         const char* by) {
      if (!is_asked(lab_of(step))) return;
      material::Mutant mutant;
      mutant.name = name, mutant.step = step, mutant.file = file, mutant.what = what, mutant.by = by;
      chosen.push_back(mutant);
    };
    add("decodes-to-minus-0.9", "5.1", "shaders/05_normal_map/decode_normal.glsl", "color * 2.0 - 1.0",
        "color * 2.0 - 0.9");
    add("draws-nothing", "5.7", "labs/05_normal_map/lab.cpp",
        "return texel::app::run<texel::normal_map::NormalMap>(argc, argv);", "return argc + argv[0][0];");
    add("reflects-with-a-wrong-sign", "8.1", "shaders/08_reflection/rays.glsl", "incident - 2.0 *",
        "incident + 2.0 *");
    return chosen;
  }

  void changes(const std::vector<material::Mutant>& chosen, const std::string& kind) {
    for (const material::Mutant& mutant : chosen) {
      const Files files = solution({{mutant.file, material::mutated(mutant, sources_.at(mutant.file))}});
      Json outcome = {{"passes", all_steps()}};
      if (!mutant.is_right)
        outcome = {{"passes", steps([&](const std::string& step) { return step != mutant.step; })},
                   {"fails", mutant.step}};
      // Some are called as a mutant that draws the same.
      if (!mutant.is_right && kind == "mutant") outcome["mistake"] = mutant.name;
      // What the starter has there already is called that.
      if (!mutant.is_right && is_untouched(mutant.step, mutant.file, files.at(mutant.file)))
        outcome = {{"zero", {mutant.step}}, {"untouched", mutant.step}};
      put(kind, mutant.name, files, outcome);
    }
  }

  static bool has_step(const std::string& text, const std::string& step) {
    return text.find("//@step " + step + " begin") != text.npos;
  }

  [[nodiscard]] bool is_untouched(const std::string& step, const std::string& file,
                                  const std::string& text) const {
    return course::untouched_steps(text, starter().at(file)).count(step) > 0;
  }

  void threats(const std::string& kind) {
    const std::string asked = read_file(options_.root / "tests/threats/asked.hpp");
    for (material::Mutant threat : material::read_catalogue(options_.root / "tests/threats", {"threat"})) {
      const bool is_slow = fs::path(threat.place.file).stem() == "slow";
      if (is_slow != (kind == "slow")) continue;
      const int lab = threat.step.empty() ? lab_of_file(threat.file) : lab_of(threat.step);
      if (!is_asked(lab)) continue;
      replace_all(threat.by, "@ASKED@", asked);
      replace_all(threat.by, "@ROOT@", options_.root.string());
      replace_all(threat.by, "@CLASS@", options_.out.string());
      const Files files = solution({{threat.file, material::mutated(threat, sources_.at(threat.file))}});
      Json outcome = {{"zero", {threat.step}}};
      // Steps of other files are judged among the solution's.
      const auto texts = course::step_texts(files.at(threat.file));
      if (threat.step.empty())
        outcome = {{"zero", steps([&](const std::string& step) { return texts.contains(step); })},
                   {"passes", steps([&](const std::string& step) { return !texts.contains(step); })}};
      put(kind, threat.name, files, outcome);
    }
  }

  /// Links, other files than those of the labs, and names that mean something to a page, a table or a shell.
  void hostile_files() {
    const fs::path links = options_.out / "files-links";
    for (const auto& [path, text] : sources_) {
      fs::create_directories((links / path).parent_path());
      fs::create_symlink(options_.root / path, links / path);
    }
    const fs::path linked = options_.out / "files-linked-folders";
    fs::create_directories(linked);
    for (const char* folder : {"common", "labs", "shaders"})
      fs::create_directory_symlink(options_.root / folder, linked / folder);
    fs::create_directory_symlink(options_.root, options_.out / "files-link");
    for (const std::string name : {"links", "linked-folders", "link"})
      expect("files-" + name, "files", name, unreadable());

    const std::string mark = options_.out.string() + "/texel_threat_was_here";
    const std::string cmake = fmt::format(
        "cmake_minimum_required(VERSION 3.20)\nexecute_process(COMMAND sh -c \"touch '{}'\")\nfile(TOUCH "
        "\"{}\")\n",
        mark, mark);
    Files files = starter();
    for (const char* path : {"CMakeLists.txt", "labs/CMakeLists.txt", "labs/07_environment/CMakeLists.txt",
                             "common/CMakeLists.txt", "cmake/texel_targets.cmake",
                             "cmake/texel_dependencies.cmake", "labs/09_bump/CMakeLists.txt"})
      files[path] = cmake;
    files["CMakePresets.json"] = "{}";
    files["build.ninja"] = "rule x\n command = touch " + mark + "\nbuild all: x\n";
    files["Makefile"] = "all:\n\ttouch " + mark + "\n";
    files["run"] = "#!/bin/sh\ntouch " + mark + "\n";
    files["labs/07_environment/lab.toml"] = "lab = \"07_environment\"\n";
    files["labs/09_bump/lab.toml"] = "lab = \"09_bump\"\n";
    files["common/core/include/core/error.hpp"] = "#error taken\n";
    files["shaders/09_bump/bump.frag"] = "#error taken\n";
    files["results.sqlite"] = files["seed.txt"] = "1";
    put("files", "build-files", files, nothing());

    Files names = solution();
    for (const char* name :
         {"<script>texel_threat()</script>.txt", "\"><img src=x onerror=texel_threat()>", "=cmd|' !A0.txt",
          "$(touch texel_threat_was_here).txt", "`touch texel_threat_was_here`", "-rf", "a\nb.txt",
          "a\tb.txt", "[[ATTACHMENT|x]]", "\xff\xfe.txt", "]]>.txt"})
      names[name] = "x";
    const std::vector<std::string> entries = {"<script>texel_threat()<script>",
                                              "\"><img src=x onerror=texel_threat()>",
                                              "'; touch texel_threat_was_here; '",
                                              "$(touch texel_threat_was_here)",
                                              "`touch texel_threat_was_here`",
                                              "=HYPERLINK(\"x\",\"y\")",
                                              "+1",
                                              "@SUM(A1)",
                                              "-rf",
                                              "--out=x",
                                              "a,\"b\",c",
                                              "a\nb",
                                              "a\rb\tc",
                                              "[[ATTACHMENT|x]]",
                                              "\xff\xfe",
                                              "\xe2\x80\xaetxt.exe",
                                              "a b  c",
                                              "%s%n",
                                              std::string(200, 'x')};
    for (std::size_t i = 0; i < entries.size(); ++i)
      if (i % 8 == 0)
        put_file("files", entries[i] + ".zip", packed(Format::zip, names), {{"passes", all_steps()}});
      else
        put_file("files", entries[i] + ".zip", "nothing that can be read", unreadable());

    // Folders with names in other encodings than the grader's.
    const std::vector<std::string> folders = {"\u00dcbung 9 \u2013 L\u00f6sung", "\u4f5c\u4e1a\u4e5d",
                                              "final \U0001F642",
                                              "\x9a"
                                              "bung 9 - L\x94sung",
                                              "\xd7\xf7\xd2\xb5"};
    for (std::size_t i = 0; i < folders.size(); ++i) {
      Files below;
      for (const auto& [path, text] : solution()) below[folders[i] + "/" + path] = text;
      below[std::string(256, 'n') + ".cpp"] = "// nobody asked for this\n";
      std::string zip = packed(Format::zip, below);
      if (i < 3) zip = with_utf8_flag(zip);
      put_file("files", fmt::format("files-folder-{}.zip", i), zip, {{"passes", all_steps()}});
    }

    // A file that does not link costs its own steps, and no others of its lab.
    const std::string tangents = "labs/05_normal_map/triangle_frame.cpp";
    Files unlinked = solution();
    unlinked[tangents] += "int missing_function();\nint unlinked = missing_function();\n";
    Json own = steps([&](const std::string& step) { return has_step(sources_.at(tangents), step); });
    put("files", "does-not-link", unlinked,
        own.empty() ? Json{{"passes", all_steps()}} : Json{{"zero", own}});

    // One name, two students: each keeps their own work.
    write_folder(options_.out / "Jane Doe", solution());
    expect("Jane Doe", "files", "one-name", {{"passes", all_steps()}});
    put_file("files", "jane doe.tar.gz", packed(Format::tar_gz, solution()), {{"passes", all_steps()}});
    for (const auto& [entry, is_solved] : {std::pair("Jane Doe.zip", false),
                                           {"Jane Doe_77_assignsubmission_file_labs.zip", false},
                                           {"Jane Doe_78_assignsubmission_file_labs.zip", true}})
      put_file("files", entry, packed(Format::zip, is_solved ? solution() : starter()),
               is_solved ? Json{{"passes", all_steps()}} : nothing());
  }

  void broken() {
    const std::string zip = packed(Format::zip, solution()), tar = packed(Format::tar_gz, solution());
    std::vector<Packed> bomb = {{"bomb", std::string(64U << 20U, '\0')}}, many;
    for (const auto& [path, text] : solution()) bomb.push_back({path, text});
    for (int i = 0; i < 20'000; ++i) many.push_back({fmt::format("{}.txt", i), ""});
    std::vector<Packed> absolute, above, links, hard_links, devices, pipes;
    for (const auto& [path, text] : solution()) {
      absolute.push_back({"/" + path, text});
      above.push_back({"x/../../" + path, text});
      links.push_back({path, "", AE_IFLNK, (options_.root / path).string()});
      hard_links.push_back({path, "", AE_IFREG, (options_.root / path).string()});
      devices.push_back({path, "", AE_IFCHR});
      pipes.push_back({path, "", AE_IFIFO});
    }
    for (const auto& [name, bytes] : Files{{"cut.zip", zip.substr(0, zip.size() / 2)},
                                           {"cut.tar.gz", tar.substr(0, tar.size() / 2)},
                                           {"empty.zip", ""},
                                           {"empty.tar.gz", ""},
                                           {"text.zip", "I could not get it to work, sorry.\n"},
                                           {"essay.docx", "My solution"},
                                           {"without-files.zip", pack(Format::zip, {})},
                                           {"bomb.zip", pack(Format::zip, bomb)},
                                           {"bomb.tar.gz", pack(Format::tar_gz, bomb)},
                                           {"archive-in-archive.zip", pack(Format::zip, {{"labs.zip", zip}})},
                                           {"many.zip", pack(Format::zip, many)},
                                           {"absolute.zip", pack(Format::zip, absolute)},
                                           {"above.tar.gz", pack(Format::tar_gz, above)},
                                           {"links.zip", pack(Format::zip, links)},
                                           {"links.tar.gz", pack(Format::tar_gz, links)},
                                           {"hard-links.tar", pack(Format::tar, hard_links)},
                                           {"devices.tar.gz", pack(Format::tar_gz, devices)},
                                           {"pipes.tar", pack(Format::tar, pipes)}})
      put_file("broken", "broken-" + name, bytes, unreadable());
    fs::create_directories(options_.out / "broken-empty-folder");
    expect("broken-empty-folder", "broken", "empty-folder", unreadable());
  }

  /// DIR.json, by the ids that the grader will give.
  void write_expectations() const {
    Json students = Json::object();
    // What an entry is called in the class folder; the grader may say the archive in it.
    for (const grade::Entry& entry : grade::read_class(options_.out)) {
      const std::string name = entry.path.lexically_relative(options_.out).begin()->string();
      students[entry.id] = expected_.at(name);
    }
    const Json json = {{"labs", options_.labs}, {"steps", all_steps()}, {"students", students}};
    fs::path file = options_.out;
    write_file(file += ".json", to_text(json, 1) + "\n");
  }

  Options options_;
  Files sources_;                           ///< the course's own, with both parts of each step
  std::vector<std::string> order_, asked_;  ///< all steps, and those of the labs
  std::map<std::string, Json> expected_;    ///< by the entry's name
};

}  // namespace
}  // namespace texel::test

int main(int argc, char** argv) {
  texel::test::Options options;
  CLI::App app("Makes a class folder whose grades are known", "make_class");
  app.add_option("--root", options.root, "The course's tree")->required();
  app.add_option("--out", options.out, "A new folder; what must come out goes into the same name with .json")
      ->required();
  app.add_option("--labs", options.labs, "Numbers of labs")->required()->delimiter(',');
  app.add_option("--kinds", options.kinds,
                 "solution,starter,prefix,mutant,mistake,equivalent,threat,slow,files,broken")
      ->delimiter(',')
      ->check(CLI::IsMember({"solution", "starter", "prefix", "mutant", "mistake", "equivalent", "threat",
                             "slow", "files", "broken"}));
  app.add_option("--limit", options.limit,
                 "At most so many prefixes, mutants and equivalents each, from all over the list")
      ->check(CLI::PositiveNumber);
  CLI11_PARSE(app, argc, argv)
  try {
    texel::test::ClassMaker maker(options);
    maker.make();
    std::printf("%zu entries\n", maker.size());
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "make_class: %s\n", error.what());
    return 3;
  }
}
