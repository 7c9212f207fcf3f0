// SPDX-License-Identifier: MIT
// Each lab stands alone: what a student has of other labs does not show in its pictures. Programs and shaders
// of the starter, with the steps of all other labs solved, and with each of them replaced by a crash.
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <regex>
#include <string>

#include "../../teach/grade/workshop.hpp"
#include "../support/places.hpp"
#include "core/files.hpp"
#include "core/process.hpp"
#include "course/batch.hpp"
#include "course/lab_file.hpp"
#include "course/markers.hpp"
#include "grade/submission.hpp"

namespace texel {
namespace {

namespace fs = std::filesystem;
using Files = std::map<std::string, std::string>;

const fs::path kSource = test::kSource, kCache = fs::path(test::kBuild) / "grade";

/// A step's file in which every function that is called ends the program, and that no shader can include.
std::string crash(const std::string& path, const std::string& text) {
  if (!path.ends_with(".cpp")) return "#error another lab's shader\n";
  return std::regex_replace(text, std::regex(R"(\breturn\b)"), "__builtin_trap(); return");
}

class StandsAlone : public testing::Test {
 protected:
  StandsAlone()
      : starter_(grade::starter_tree(kSource, kCache)),
        workshop_(starter_, kCache / "stands_alone", run_plainly),
        work_(kCache.parent_path() / "stands_alone") {
    fs::remove_all(work_);
  }

  /// The starter's files with steps of all labs but this one, each changed.
  template <class Change>
  [[nodiscard]] Files others(const course::Lab& lab, Change change) const {
    Files files;
    for (const std::string& path : course::step_files(starter_.source))
      if (path.find("/" + lab.folder + "/") == path.npos) files[path] = change(path);
    return files;
  }

  /// The words that run a lab's program with these files in place of the starter's.
  [[nodiscard]] std::vector<std::string> with(const course::Lab& lab, const Files& files,
                                              const std::string& name) {
    const grade::Program program = workshop_.make(lab.program(), files);
    for (const store::CompilerLog& refused : program.refused) ADD_FAILURE() << refused.file << refused.text;
    const fs::path root = work_ / lab.folder / name;
    fs::create_directories(root);
    grade::make_root(starter_.source, files, root);
    return {"env", "TEXEL_ROOT=" + root.string(), program.file.string()};
  }

  /// The lab's first picture and its looks, as bytes.
  [[nodiscard]] Files draw(const course::Lab& lab, std::vector<std::string> command,
                           const std::string& name) const {
    std::vector<course::Case> cases(1);
    cases[0].file = "first.png";
    for (const course::Look& look : lab.looks)
      if (look.view != course::View::error) cases.push_back(look);  // a student's tree has no view error
    for (course::Case& one : cases) one.size = {96, 96};
    const fs::path batch = work_ / lab.folder / (name + ".json"), out = work_ / lab.folder / (name + "_out");
    write_file(batch, course::to_batch(cases));
    for (const std::string& word :
         {std::string("--batch"), batch.string(), std::string("--out"), out.string()})
      command.push_back(word);
    const Ran result = run_program(command, true);
    EXPECT_EQ(result.exit_code, 0) << result.output;
    Files pictures;
    for (const course::Case& one : cases)
      pictures[one.file] = fs::exists(out / one.file) ? read_file(out / one.file) : name + " did not draw it";
    return pictures;
  }

  grade::BuiltTree starter_;
  grade::Workshop workshop_;
  fs::path work_;
};

TEST_F(StandsAlone, each_lab_draws_the_same_whatever_stands_in_others) {
  const auto all = [](const std::string&) { return true; };
  for (const course::Lab& lab : course::read_labs(kSource / "labs")) {
    SCOPED_TRACE(lab.folder);
    const Files untouched = draw(lab, with(lab, {}, "untouched"), "untouched");
    const Files solved = others(lab, [&](const std::string& path) {
      return course::with_steps(read_file(kSource / path), path, all);
    });
    EXPECT_EQ(draw(lab, with(lab, solved, "solved"), "solved"), untouched);
    const Files broken =
        others(lab, [&](const std::string& path) { return crash(path, read_file(starter_.source / path)); });
    EXPECT_EQ(draw(lab, with(lab, broken, "broken"), "broken"), untouched);
    EXPECT_FALSE(untouched.empty());
  }
}

/// The crash is one: an OBJ file that is named goes through lab 3's reader, the student's own.
TEST_F(StandsAlone, but_a_named_obj_file_is_read_by_the_students_reader) {
  for (const course::Lab& lab : course::read_labs(kSource / "labs")) {
    if (lab.number != 4 && lab.number != 5) continue;
    SCOPED_TRACE(lab.folder);
    const Files broken =
        others(lab, [&](const std::string& path) { return crash(path, read_file(starter_.source / path)); });
    const fs::path models = kSource / "assets/models";
    const std::vector<std::string> program = with(lab, broken, "reader");
    const auto draws = [&](const fs::path& model) {
      std::vector<std::string> command = program;
      for (const std::string& word : {model.string(), std::string("--size"), std::string("16x16"),
                                      std::string("--snapshot"), (work_ / "reader.png").string()})
        command.push_back(word);
      return run_program(command, true).exit_code == 0;
    };
    EXPECT_FALSE(draws(models / "ship.obj"));
    EXPECT_TRUE(draws(models / "ship.ply"));
  }
}

}  // namespace
}  // namespace texel
