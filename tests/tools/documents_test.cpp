// SPDX-License-Identifier: MIT
// Every command that README, guides and handouts show, run as it is typed: in the course's tree what its
// makers type, in a starter what its students type.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <regex>
#include <set>

#include "../support/picture_files.hpp"
#include "../support/places.hpp"
#include "../support/process.hpp"
#include "../support/said.hpp"
#include "core/files.hpp"
#include "course/lab_file.hpp"
#include "gallery.hpp"
#include "image/difference.hpp"
#include "image/load.hpp"

namespace texel {
namespace {

namespace fs = std::filesystem;
using test::has;
using test::Result;
using test::shell;
using test::shell_word;

const fs::path kRoot = test::kSource;
const std::string kBin = test::kBin, kTexel = kBin + "/texel";

/// Without what stands behind it as a remark.
std::string command_in(std::string line) {
  line = line.substr(0, line.find("  #"));
  const std::size_t first = line.find_first_not_of(" \t"), last = line.find_last_not_of(" \t");
  return first == line.npos ? "" : line.substr(first, last - first + 1);
}

/// The commands of a document: lines of its blocks of shell, and code within its text.
std::set<std::string> commands_of(const std::string& text) {
  static const std::regex begins(R"(^(\./run|texel|build/release/bin/\w+)( .*)?$)");
  std::set<std::string> commands;
  const auto add = [&](const std::string& line) {
    const std::string command = command_in(line);
    if (std::regex_match(command, begins)) commands.insert(command);
  };
  bool in_block = false;
  std::string prose;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.find("```") != line.npos)
      in_block = !in_block;
    else if (in_block)
      add(line);
    else
      prose += line + " ";
  }
  static const std::regex code("`([^`]+)`");
  for (std::sregex_iterator found(prose.begin(), prose.end(), code), end; found != end; ++found)
    add((*found)[1]);
  return commands;
}

class Document : public testing::TestWithParam<std::string> {
 protected:
  Document() : folder_("document"), work_(fs::absolute(folder_ / "work")) {
    fs::create_directories(work_);
    // Paths in commands are those in the tree's root; what they write shall not land there.
    for (const char* name : {"assets", "docs", "labs"})
      fs::create_directory_symlink(kRoot / name, work_ / name);
  }

  [[nodiscard]] Result run(const std::string& line) const {
    return shell(fmt::format("cd {} && {} 2>&1", shell_word(work_.string()), line));
  }

  /// In a starter, which is made when the first command wants it.
  Result run_as_student(const std::string& line) {
    const fs::path starter = fs::absolute(folder_ / "starter");
    if (!fs::exists(starter)) {
      const Result made = run(fmt::format("{} starter --out {}", kTexel, shell_word(starter.string())));
      EXPECT_EQ(made.exit_code, 0) << made.output;
    }
    return run(fmt::format("TEXEL_ROOT={} {}", shell_word(starter.string()), line));
  }

  void run_lab(const std::string& arguments) {
    const std::size_t digits = arguments.find_first_not_of("0123456789");
    const std::string number = arguments.substr(0, digits);
    const std::string program = fmt::format("{}/lab{}_*", kBin, std::string(2 - number.size(), '0') + number);
    std::string rest = digits == arguments.npos ? "" : arguments.substr(digits);
    // What opens a window draws a small picture in its place.
    static const std::regex without_window(
        "--(snapshot|stats|mesh|measure|batch|bench|help|list-parameters|list-views|frames|save-config)\\b");
    if (!std::regex_search(rest, without_window)) rest += " --size 64x64 --snapshot document.png";
    const Result result = run(fmt::format("{}{}", program, rest));
    EXPECT_EQ(result.exit_code, 0) << result.output;
  }

  test::TemporaryFolder folder_;
  fs::path work_;
};

TEST_P(Document, shows_commands_that_work) {
  const std::set<std::string> commands = commands_of(read_file(kRoot / GetParam()));
  ASSERT_FALSE(commands.empty());
  const std::string help = run(shell_word((kRoot / "run").string()) + " help").output;
  fs::copy_file(kRoot / "docs/pictures/01_texture_quad.png", work_ / "right.png");
  fs::copy_file(kRoot / "docs/pictures/01_texture_quad.png", work_ / "mine.png");
  write_file(work_ / "looks.json", R"([{"name": "brick", "size": "64x64", "set": {"texture": "brick"}}])");
  write_file(work_ / "seed.txt", "a seed of the course\n");
  write_file(work_ / "roster.csv", "id,sis,name\nada,s1,Ada\n");
  write_file(work_ / "due.csv", "lab,due\n5,2026-11-20T23:59+01:00\n");
  write_file(work_ / "times.csv", "id,submitted\nada,2026-11-21T12:00+01:00\n");
  for (const char* lab : {"1", "5"}) {
    fs::create_directories(work_ / fmt::format("out/lab{}", lab));
    write_file(work_ / fmt::format("out/lab{}/class.csv", lab),
               fmt::format("name,id,number,lab {}\nAda,ada,,6\n", lab));
  }
  for (const std::string& command : commands) {
    SCOPED_TRACE(command);
    std::smatch words;
    if (std::regex_match(command, words, std::regex(R"(\./run lab (.*))"))) {
      run_lab(words[1]);
    } else if (std::regex_match(command, words,
                                std::regex(R"(\./run ((check|hint|reset|progress)( .*)?))"))) {
      const Result result = run_as_student(kTexel + " " + words[1].str());
      EXPECT_LE(result.exit_code, 1) << result.output;
    } else if (std::regex_match(command, words, std::regex(R"(\./run (watch \d+))"))) {
      const Result result =
          run_as_student("timeout --signal=INT 1 " + kTexel + " " + words[1].str() + " </dev/null");
      EXPECT_TRUE(has(result.output, "Save a file") || result.exit_code == 124) << result.output;
    } else if (std::regex_match(command, words, std::regex(R"(\./run bench( \d+)?)"))) {
      // The measuring itself is tested by accuracy.*; this has the same page made of what was measured.
      const Result result = run(fmt::format("TEXEL_ROOT={} {} bench{} --from docs/accuracy.json --out bench",
                                            shell_word(kRoot.string()), kTexel, words[1].str()));
      EXPECT_EQ(result.exit_code, 0) << result.output;
    } else if (std::regex_match(command, words, std::regex(R"((?:\./run|texel) (course .*))"))) {
      if (has(command, "classroom")) run_as_student("true");  // makes the starter beside this folder
      std::string line = std::regex_replace(words[1].str(), std::regex(R"(\.\./my-labs)"), "../starter");
      if (has(line, "similar")) fs::create_directories(work_ / "CLASS/ada");
      if (line == "course NAME") line = "course --help";
      if (has(line, "similar") && shell("command -v sim_c").exit_code != 0) continue;
      const Result result = run(kTexel + " " + line);
      EXPECT_EQ(result.exit_code, 0) << result.output;
    } else if (std::regex_match(command, words, std::regex(R"((?:\./run|texel) (grade .*))"))) {
      // Whole classes are graded in grade_test; here what it is told is understood, and only the class is
      // missing.
      const Result result = run(kTexel + " " + words[1].str());
      EXPECT_NE(result.exit_code, 2) << result.output;
    } else if (std::regex_match(command, words, std::regex(R"(\./run(?: (\S+).*)?)"))) {
      // What sets up, tests or renews the whole tree is what continuous integration and its makers run.
      EXPECT_TRUE(has(help, words[1].matched ? "./run " + words[1].str() : "./run ")) << help;
    } else if (std::regex_match(command, words, std::regex(R"(texel( \w+)?( --verify)?)"))) {
      // The name alone; all of the starter is verified by grade_test's WholeCourse.
      const Result result = run(kTexel + words[1].str() + " --help");
      EXPECT_EQ(result.exit_code, 0) << result.output;
    } else {
      static const std::regex program("^(build/release/bin/|(?=texel ))");
      std::string line = std::regex_replace(command, program, kBin + "/");
      const bool all = std::getenv("TEXEL_TEST_ALL") != nullptr;
      if (all) line = std::regex_replace(line, std::regex("(renderers --mutants).*"), "$1");
      // One lab's is a share of it: the starter that the grader's tests have built.
      if (has(line, "--verify")) {
        const bool is_tried = has(line, "--labs 9") || all;
        line += is_tried ? fmt::format(" --cache {}/grade", test::kBuild) : " --help";
      }
      const Result result = run(line);
      EXPECT_EQ(result.exit_code, 0) << result.output;
    }
  }
}

/// The guides, and each lab's handout.
std::vector<std::string> documents() {
  std::vector<std::string> all = {
      "README.md",      "CONTRIBUTING.md",  "docs/student.md",      "docs/instructor.md",
      "docs/course.md", "docs/accuracy.md", "docs/architecture.md", "docs/adding_a_lab.md"};
  for (const course::Lab& lab : course::read_labs(kRoot / "labs"))
    all.push_back("labs/" + lab.folder + "/README.md");
  return all;
}

INSTANTIATE_TEST_SUITE_P(Every, Document, testing::ValuesIn(documents()), [](const auto& document) {
  std::string name = document.param;
  for (char& c : name) c = std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  return name;
});

TEST(Documents, show_pictures_of_the_present_code) {
  const test::TemporaryFolder folder("heroes");
  for (const course::Lab& lab : course::read_labs("labs")) {
    const course::Look* hero = tools::hero_of(lab);
    ASSERT_NE(hero, nullptr) << lab.folder;
    std::string line = fmt::format("{}/{}", test::kBin, lab.program());
    for (const course::Setting& setting : hero->settings) line += course::flag(setting);
    const auto drawn = folder / (lab.folder + ".png"), small = folder / (lab.folder + "_small.png");
    const Result result = shell(fmt::format("{} --view {} --size {} --snapshot {} 2>&1", line,
                                            name_of(hero->view), as_text(hero->size), drawn.string()));
    ASSERT_EQ(result.exit_code, 0) << result.output;
    tools::save_hero(drawn, small);
    const auto kept = std::filesystem::path("docs/pictures") / (lab.folder + ".png");
    // Mesa 25 is off by up to 0.15 in the mean and 5 in P99: lab 5's pictures are read by the driver's
    // filter.
    const image::Difference off = image::compare(image::load8(kept), image::load8(small));
    EXPECT_LE(off.mean, 0.5) << kept << ": ./run docs renews it";
    EXPECT_LE(off.p99, 15) << kept << ": ./run docs renews it";
  }
}

/// A folder or file of the tree, or one without its ending, or a room's header without include/ROOM.
bool is_in_tree(const std::filesystem::path& name) {
  const auto folder = name.parent_path();
  return std::filesystem::exists(name) || std::filesystem::exists(name.string() + ".cpp") ||
         std::filesystem::exists(folder / "include" / folder.filename() / name.filename());
}

TEST(Documents, name_only_files_that_are_there) {
  const std::regex code("`((common|labs|shaders|tests|tools|web)/[\\w./]+)`");
  const std::regex link("\\]\\(([^):#]+)|src=\"([^\"]+)");
  std::vector<std::string> documents = {"README.md",       "CONTRIBUTING.md",    "docs/architecture.md",
                                        "docs/student.md", "docs/instructor.md", "docs/course.md"};
  for (const course::Lab& lab : course::read_labs("labs"))
    documents.push_back("labs/" + lab.folder + "/README.md");
  for (const std::string& document : documents) {
    const std::string text = read_file(document);
    for (std::sregex_iterator found(text.begin(), text.end(), link), end; found != end; ++found) {
      const std::string target = (*found)[1].str() + (*found)[2].str();
      if (target == "https") continue;
      const auto path = std::filesystem::path(document).parent_path() / target;
      EXPECT_TRUE(std::filesystem::exists(path)) << document << " names " << target;
    }
    for (std::sregex_iterator found(text.begin(), text.end(), code), end; found != end; ++found) {
      const std::string name = (*found)[1].str();
      EXPECT_TRUE(name.find("/NN_") != std::string::npos || is_in_tree(name))
          << document << " names " << name;
    }
  }
}

}  // namespace
}  // namespace texel
