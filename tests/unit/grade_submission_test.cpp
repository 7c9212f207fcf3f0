// SPDX-License-Identifier: MIT
// Class folders, and submissions sound and hostile.
#include "grade/submission.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <clocale>
#include <map>

#include "../support/archives.hpp"
#include "../support/picture_files.hpp"
#include "../support/said.hpp"
#include "core/error.hpp"
#include "core/files.hpp"
#include "course/markers.hpp"

namespace texel::grade {
namespace {

namespace fs = std::filesystem;
using test::Format;
using test::has;
using test::pack;
using test::Packed;
using test::with_utf8_flag;

const std::vector<std::string> allowed = {
    "common/mesh/weld.cpp", "labs/01_texture_quad/lab.cpp", "labs/05_normal_map/lab.cpp",
    "shaders/05_normal_map/decode_normal.glsl", "shaders/05_normal_map/tangent_frame.glsl"};

fs::path path_of(const test::TemporaryFolder& folder) {
  return (folder / "x").parent_path();
}

/// One submission in a folder of its own.
class Handed {
 public:
  Handed(Format format, const std::vector<Packed>& files) : Handed(format, pack(format, files)) {}
  Handed(Format format, const std::string& bytes) : folder_("submission") {
    const std::string name = format == Format::zip ? "jane.zip" : "jane.tar.gz";
    write_file(folder_ / name, bytes);
  }
  [[nodiscard]] Submission unpack(const UnpackLimits& limits = {}) const {
    return grade::unpack(read_class(path_of(folder_)).at(0), allowed, limits);
  }

 private:
  test::TemporaryFolder folder_;
};

std::string reason_of(const Submission& submission, const std::string& path) {
  for (const store::Ignored& ignored : submission.ignored)
    if (ignored.path == path) return ignored.reason;
  return "not ignored";
}

std::map<std::string, Entry> class_of(const std::vector<std::string>& file_names) {
  const test::TemporaryFolder folder("class");
  for (const std::string& name : file_names) {
    if (name.ends_with('/'))
      fs::create_directory(folder / name);
    else
      write_file(folder / name, "x");
  }
  std::map<std::string, Entry> entries;
  for (const Entry& entry : read_class(path_of(folder))) EXPECT_TRUE(entries.emplace(entry.id, entry).second);
  EXPECT_EQ(entries.size(), file_names.size());
  return entries;
}

TEST(ReadClass, knows_the_names_of_canvas_moodle_and_plain_ones) {
  const auto entries = class_of({"doejane_12345_678_labs.zip", "roejohn_LATE_222_333_my_labs-1.tar.gz",
                                 "Jane Q. Doe_1234_assignsubmission_file/",
                                 "Max Roe_77_assignsubmission_file_labs.zip", "anna.tgz"});
  EXPECT_EQ(entries.at("doejane-12345").name, "doejane");
  EXPECT_EQ(entries.at("doejane-12345").number, "12345");
  EXPECT_EQ(entries.at("doejane-12345").kind, Entry::Kind::zip);
  EXPECT_EQ(entries.at("roejohn-222").kind, Entry::Kind::tar);
  EXPECT_EQ(entries.at("jane-q-doe-1234").name, "Jane Q. Doe");
  EXPECT_EQ(entries.at("jane-q-doe-1234").kind, Entry::Kind::folder);
  EXPECT_EQ(entries.at("max-roe-77").number, "77");
  EXPECT_EQ(entries.at("anna").name, "anna");
  EXPECT_EQ(entries.at("anna").number, "");
}

TEST(ReadClass, gives_two_students_with_one_name_two_ids) {
  class_of({"jane.zip", "jane.tar.gz", "jane/", "Jane.zip", "JANE.zip", "J\xC3\xA4ne.zip", "J\xC3\xB6ne.zip",
            "doe_1_2_labs.zip", "doe_1_3_labs.zip", "doe_2_4_labs.zip", "Doe_1_assignsubmission_file/"});
}

TEST(ReadClass, does_not_change_an_id_when_others_hand_in) {
  const std::string alone = class_of({"Jane Doe.zip"}).begin()->first;
  EXPECT_TRUE(class_of({"Jane Doe.zip", "jane doe.zip", "jane-doe.zip", "Jane_Doe.zip"}).contains(alone));
}

TEST(ReadClass, makes_ids_safe_and_keeps_names_as_text) {
  const std::vector<std::string> hostile = {"<script>alert(1)<script>.zip",
                                            "=HYPERLINK(\"x\").zip",
                                            "$(touch hacked).zip",
                                            "-rf.zip",
                                            "a\nb.zip",
                                            "\xFF\xFE.zip",
                                            "\xE2\x80\xAEgpj.zip",
                                            "'; DROP TABLE scores; --.zip",
                                            std::string(200, 'x') + ".zip",
                                            "_1_2_3.zip",
                                            "___.zip",
                                            "con\\..\\x.zip"};
  for (const auto& [id, entry] : class_of(hostile)) {
    EXPECT_LE(id.size(), 100U);
    EXPECT_TRUE(std::all_of(id.begin(), id.end(), [](char c) {
      return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
    })) << id;
    EXPECT_TRUE(id[0] != '-' && id[0] != '_') << id;
    EXPECT_FALSE(has(entry.name, "\n"));
    EXPECT_FALSE(has(entry.name, "\xFF"));
    EXPECT_FALSE(has(entry.name, "\xE2\x80\xAE"));
  }
  const Entry script = class_of({hostile[0]}).begin()->second;
  EXPECT_EQ(script.name, "<script>alert(1)<script>");
}

TEST(ReadClass, takes_an_archive_alone_in_a_folder_for_the_submission) {
  const test::TemporaryFolder folder("class");
  const fs::path student = folder / "Jane Doe_1_assignsubmission_file";
  fs::create_directory(student);
  write_file(student / "labs.zip", pack(Format::zip, {{"labs/05_normal_map/lab.cpp", "mine"}}));
  const std::vector<Entry> entries = read_class(path_of(folder));
  ASSERT_EQ(entries.size(), 1U);
  EXPECT_EQ(entries[0].id, "jane-doe-1");
  EXPECT_EQ(entries[0].kind, Entry::Kind::zip);
  EXPECT_EQ(unpack(entries[0], allowed).files.at("labs/05_normal_map/lab.cpp"), "mine");
}

TEST(ReadClass, keeps_a_student_whose_file_cannot_be_unpacked) {
  const auto entries = class_of({"jane.rar"});
  const Entry& entry = entries.begin()->second;
  EXPECT_EQ(entry.kind, Entry::Kind::other);
  EXPECT_EQ(unpack(entry, allowed).fault, "is not a folder, a .zip or a .tar.gz file");
}

TEST(ReadClass, follows_no_link_and_throws_for_a_missing_folder) {
  const test::TemporaryFolder folder("class");
  fs::create_directory_symlink("/etc", folder / "jane");
  const Entry link = read_class(path_of(folder)).at(0);
  EXPECT_EQ(link.kind, Entry::Kind::other);
  EXPECT_TRUE(unpack(link, allowed).fault.starts_with("is a symbolic link, which is not followed"));
  EXPECT_THROW(read_class(folder / "missing"), Error);
}

TEST(StepFiles, are_the_files_of_the_tree_with_a_marker) {
  const test::TemporaryFolder tree("step_files");
  for (const char* name : {"labs/01_a", "shaders/lib", "common/mesh", "tests"})
    fs::create_directories(tree / name);
  write_file(tree / "labs/01_a/lab.cpp", "int x;\n    //@step 1.1 begin\n//@end\n");
  write_file(tree / "labs/01_a/other.hpp", "// the marker //@step is explained here\n");
  write_file(tree / "shaders/lib/light.glsl", "//@step 5.1 begin\n");
  write_file(tree / "tests/test.cpp", "//@step 5.1 begin\n");
  EXPECT_EQ(course::step_files(path_of(tree)),
            (std::vector<std::string>{"labs/01_a/lab.cpp", "shaders/lib/light.glsl"}));
  EXPECT_THROW(course::step_files(tree / "tests"), Error);
}

TEST(Unpack, takes_allowed_files_and_lists_the_others) {
  for (const Format format : {Format::zip, Format::tar_gz}) {
    const Submission submission = Handed(format, {{"labs/05_normal_map/lab.cpp", "mine"},
                                                  {"labs/05_normal_map/lab.toml", "points = 100"},
                                                  {"CMakeLists.txt", "execute_process(COMMAND sh)"},
                                                  {"more.zip", "PK"},
                                                  {".git/config", "hidden"},
                                                  {"__MACOSX/labs/05_normal_map/._lab.cpp", "mac"}})
                                      .unpack();
    EXPECT_EQ(submission.fault, "");
    EXPECT_EQ(submission.root, "");
    EXPECT_EQ(submission.files, (std::map<std::string, std::string>{{"labs/05_normal_map/lab.cpp", "mine"}}));
    EXPECT_EQ(submission.ignored.size(), 5U);
    EXPECT_TRUE(has(reason_of(submission, "CMakeLists.txt"), "no"));
    EXPECT_TRUE(has(reason_of(submission, "labs/05_normal_map/lab.toml"), "not a file with steps"));
    EXPECT_TRUE(has(reason_of(submission, "more.zip"), "archive"));
    EXPECT_TRUE(has(reason_of(submission, ".git/config"), "hidden"));
  }
}

struct Packing {
  std::vector<std::string> paths;  ///< each with its own path as content
  std::string root;
  std::map<std::string, std::string> files;
};

TEST(Unpack, finds_the_root_wherever_it_lies) {
  const std::string lab = "labs/05_normal_map/lab.cpp";
  const std::string frame = "shaders/05_normal_map/tangent_frame.glsl";
  const std::vector<Packing> packings = {
      {{"./" + lab, frame}, "", {{lab, "./" + lab}, {frame, frame}}},
      {{"Jane's work/texel/" + lab}, "Jane's work/texel/", {{lab, "Jane's work/texel/" + lab}}},
      {{"05_normal_map/lab.cpp"}, "", {{lab, "05_normal_map/lab.cpp"}}},
      {{"05_normal_map/lab.cpp", "05_normal_map/tangent_frame.glsl"},
       "",
       {{lab, "05_normal_map/lab.cpp"}, {frame, "05_normal_map/tangent_frame.glsl"}}},
      {{"tangent_frame.glsl"}, "", {{frame, "tangent_frame.glsl"}}},
      {{"home\\jane\\labs\\05_normal_map\\lab.cpp"},
       "home/jane/",
       {{lab, "home\\jane\\labs\\05_normal_map\\lab.cpp"}}},
      // The tree with more of the labs; and of two alike the first by bytes.
      {{"old/" + lab, "new/" + lab, "new/" + frame}, "new/", {{lab, "new/" + lab}, {frame, "new/" + frame}}},
      {{"b/" + lab, "a/" + lab}, "a/", {{lab, "a/" + lab}}},
      // One that names more of its place goes before a loose one.
      {{frame, "tangent_frame.glsl"}, "", {{frame, frame}}},
      // Capitals, and folders inside folders, where one file alone can be meant.
      {{"Labs/05_Normal_Map/Lab.cpp", "SHADERS/05_normal_map/tangent_frame.glsl"},
       "",
       {{lab, "Labs/05_Normal_Map/Lab.cpp"}, {frame, "SHADERS/05_normal_map/tangent_frame.glsl"}}},
      {{"Labs/05_normal_map/lab.cpp", lab}, "", {{lab, lab}}},
      {{"a/labs/labs/05_normal_map/lab.cpp", "b/shaders/shaders/05_normal_map/tangent_frame.glsl"},
       "a/labs/",
       {{lab, "a/labs/labs/05_normal_map/lab.cpp"},
        {frame, "b/shaders/shaders/05_normal_map/tangent_frame.glsl"}}},
      {{frame, "shaders/05_normal_map/Decode_normal.glsl", "shaders/05_normal_map/DECODE_NORMAL.glsl"},
       "",
       {{frame, frame}}},
      // A name alone says too little outside the root.
      {{lab, "x/tangent_frame.glsl"}, "", {{lab, lab}}},
      {{"lab.cpp"}, "", {}},
      {{"readme.txt"}, "", {}},
  };
  for (const Packing& packing : packings) {
    std::vector<Packed> files;
    for (const std::string& path : packing.paths) files.push_back({path, path});
    const Submission submission = Handed(Format::tar_gz, files).unpack();
    SCOPED_TRACE(packing.paths[0]);
    EXPECT_EQ(submission.root, packing.root);
    EXPECT_EQ(submission.files, packing.files);
    EXPECT_EQ(submission.files.size() + submission.ignored.size(), packing.paths.size());
  }
}

TEST(Unpack, says_why_a_loose_file_of_a_common_name_is_not_taken) {
  const Submission submission = Handed(Format::zip, {{"lab.cpp", "whose?"}}).unpack();
  EXPECT_TRUE(
      has(reason_of(submission, "lab.cpp"), "labs/01_texture_quad/lab.cpp, labs/05_normal_map/lab.cpp"));
}

TEST(Unpack, says_why_none_of_several_files_is_taken) {
  const std::string lab = "labs/05_normal_map/lab.cpp", decode = "shaders/05_normal_map/decode_normal.glsl";
  const Submission submission = Handed(Format::zip, {{decode, ""},
                                                     {"labs/01_texture_quad/lab.cpp", ""},
                                                     {"old/" + lab, ""},
                                                     {"older/" + lab, ""},
                                                     {"shaders/05_normal_map/Tangent_Frame.glsl", ""},
                                                     {"shaders/05_normal_map/TANGENT_FRAME.glsl", ""}})
                                    .unpack();
  EXPECT_EQ(submission.files.size(), 2U);
  EXPECT_EQ(reason_of(submission, "old/" + lab),
            "is one of 2 files for labs/05_normal_map/lab.cpp, and none of them is in the top folder, which "
            "is graded");
  EXPECT_EQ(reason_of(submission, "shaders/05_normal_map/TANGENT_FRAME.glsl"),
            "should be called shaders/05_normal_map/tangent_frame.glsl: upper and lower case matter where "
            "there are two");
}

TEST(Unpack, takes_of_two_copies_the_one_with_more_steps_begun) {
  const std::string lab = "labs/05_normal_map/lab.cpp", frame = "shaders/05_normal_map/tangent_frame.glsl";
  const BegunSteps begun = [](const std::string&, const std::string& text) {
    return text == "work" ? std::set<std::string>{"5.1", "5.2"} : std::set<std::string>{};
  };
  const test::TemporaryFolder folder("copies");
  for (const Format format : {Format::zip, Format::tar_gz})
    // The name does not decide, nor which one has more files.
    for (const auto& [work, backup] : {std::pair("labs-new/", "labs-backup/"), std::pair("a/", "b/"),
                                       std::pair("x/old/", ""), std::pair("", "old/")}) {
      SCOPED_TRACE(work);
      const fs::path file = folder / (format == Format::zip ? "jane.zip" : "jane.tar.gz");
      write_file(file,
                 pack(format, {{backup + lab, "given"}, {backup + frame, "given"}, {work + lab, "work"}}));
      const Submission submission =
          unpack({file, format == Format::zip ? Entry::Kind::zip : Entry::Kind::tar, "jane", "", ""}, allowed,
                 {}, begun);
      EXPECT_EQ(submission.root, work);
      // Of the other file there is one copy alone.
      EXPECT_EQ(submission.files, (std::map<std::string, std::string>{{lab, "work"}, {frame, "given"}}));
      ASSERT_EQ(submission.copies.size(), 1U);
      EXPECT_EQ(submission.copies[0].path, *backup == 0 ? "/" : backup);
      EXPECT_TRUE(has(submission.copies[0].reason, "0 steps are begun in it, and 2 in "))
          << submission.copies[0].reason;
    }
}

TEST(Unpack, takes_the_later_of_two_equal_paths) {
  for (const Format format : {Format::zip, Format::tar_gz}) {
    const std::string path = "labs/05_normal_map/lab.cpp";
    const Submission submission = Handed(format, {{path, "old"}, {path, "new"}}).unpack();
    EXPECT_EQ(submission.files.at(path), "new");
    EXPECT_EQ(submission.ignored.size(), 1U);
  }
}

TEST(Unpack, takes_no_link_and_no_device) {
  const Submission submission =
      Handed(Format::tar_gz, {{"labs/05_normal_map/lab.cpp", "", AE_IFLNK, "/etc/passwd"},
                              {"labs", "", AE_IFLNK, "/etc"},
                              {"labs/01_texture_quad/lab.cpp", "mine"},
                              {"common/mesh/weld.cpp", "", AE_IFREG, "labs/01_texture_quad/lab.cpp"},
                              {"shaders/05_normal_map/decode_normal.glsl", "", AE_IFCHR},
                              {"shaders/05_normal_map/tangent_frame.glsl", "", AE_IFIFO}})
          .unpack();
  EXPECT_EQ(submission.files, (std::map<std::string, std::string>{{"labs/01_texture_quad/lab.cpp", "mine"}}));
  EXPECT_EQ(reason_of(submission, "labs/05_normal_map/lab.cpp"), "is a symbolic link");
  EXPECT_EQ(reason_of(submission, "common/mesh/weld.cpp"), "is a hard link");
  EXPECT_EQ(reason_of(submission, "shaders/05_normal_map/decode_normal.glsl"), "is a device, pipe or socket");
  EXPECT_EQ(reason_of(submission, "shaders/05_normal_map/tangent_frame.glsl"), "is a device, pipe or socket");
  const Submission zipped =
      Handed(Format::zip, {{"labs/05_normal_map/lab.cpp", "", AE_IFLNK, "/etc/passwd"}}).unpack();
  EXPECT_EQ(reason_of(zipped, "labs/05_normal_map/lab.cpp"), "is a symbolic link");
}

TEST(Unpack, takes_no_path_that_leaves_the_submission_and_no_strange_name) {
  const std::string lab = "labs/05_normal_map/lab.cpp";
  for (const auto& [path, reason] :
       std::vector<std::pair<std::string, std::string>>{{"/" + lab, "absolute"},
                                                        {"C:\\" + lab, "absolute"},
                                                        {"../" + lab, ".."},
                                                        {"x/../" + lab, ".."},
                                                        {"..\\" + lab, ".."},
                                                        {"a\nb/" + lab, "control"},
                                                        {"a\x1b[2J/" + lab, "control"},
                                                        {std::string(1200, 'a') + "/" + lab, "too long"}}) {
    const Submission submission = Handed(Format::tar_gz, {{path, "x"}}).unpack();
    SCOPED_TRACE(path);
    EXPECT_TRUE(submission.files.empty());
    ASSERT_EQ(submission.ignored.size(), 1U);
    EXPECT_TRUE(has(submission.ignored[0].reason, reason)) << submission.ignored[0].reason;
    EXPECT_FALSE(has(submission.ignored[0].path, "\x1b"));
  }
}

TEST(Unpack, takes_files_from_folders_with_names_in_any_encoding_and_locale) {
  const std::string lab = "labs/05_normal_map/lab.cpp", frame = "shaders/05_normal_map/tangent_frame.glsl";
  const std::vector<std::string> utf8 = {"\u00dcbung 9 \u2013 L\u00f6sung", "\u4f5c\u4e1a\u4e5d",
                                         "final \U0001F642"};
  // The same in CP437, CP1252, GBK (whose second bytes may be '\\') and Shift-JIS, without a word of it.
  const std::vector<std::string> others = {
      "\x9a"
      "bung 9 - L\x94sung",
      "\xdc"
      "bung 9 \x96 L\xf6sung",
      "\xd7\xf7\xd2\xb5\xbe\xc5",
      "\x81\\ \xd7\x5c",
      "\x83\x5c\x95\x5c",
      "\xC0\xAF"};
  for (const char* locale : {"C", "C.UTF-8"}) {
    ASSERT_NE(std::setlocale(LC_ALL, locale), nullptr);
    for (const bool is_utf8 : {true, false})
      for (const std::string& folder : is_utf8 ? utf8 : others)
        for (const Format format : {Format::zip, Format::tar_gz}) {
          SCOPED_TRACE(folder + " in " + locale);
          const std::vector<Packed> files = {{folder + "/" + lab, "mine"},
                                             {folder + "/" + frame, "mine too"}};
          // In a locale with UTF-8 the packer would say that these bytes are.
          std::setlocale(LC_ALL, "C");
          std::string bytes = pack(format, files);
          std::setlocale(LC_ALL, locale);
          if (is_utf8 && format == Format::zip) bytes = with_utf8_flag(bytes);
          const Submission submission = Handed(format, bytes).unpack();
          EXPECT_EQ(submission.fault, "");
          EXPECT_EQ(submission.files,
                    (std::map<std::string, std::string>{{lab, "mine"}, {frame, "mine too"}}));
          if (is_utf8) {
            EXPECT_EQ(submission.root, folder + "/");
          }
        }
    for (const std::string& name : {utf8[0], others[0]}) {
      const test::TemporaryFolder folder("class");
      fs::create_directories(folder / "jane" / name / "labs/05_normal_map");
      write_file(folder / "jane" / name / lab, "mine");
      EXPECT_EQ(unpack(read_class(path_of(folder)).at(0), allowed).files.count(lab), 1U) << name;
    }
  }
  std::setlocale(LC_ALL, "C");
}

TEST(Unpack, lists_every_entry_and_says_when_nothing_was_taken) {
  const std::string long_name = std::string(256, 'n') + ".cpp", no_utf8 = "\xff\xfe.cpp";
  for (const Format format : {Format::zip, Format::tar_gz}) {
    const Submission submission = Handed(format, {{long_name, "x"}, {no_utf8, "x"}}).unpack();
    EXPECT_TRUE(submission.files.empty());
    EXPECT_EQ(submission.ignored.size(), 2U);
    EXPECT_EQ(reason_of(submission, long_name), "is not a file with steps");
    EXPECT_EQ(reason_of(submission, "\uFFFD\uFFFD.cpp"), "is not a file with steps");
    EXPECT_TRUE(submission.fault.starts_with("contains no file with steps, so nothing was taken (2 files"))
        << submission.fault;
  }
  // A zip whose names say that they are UTF-8 and are not: libarchive gives such a name no text.
  const Submission broken =
      Handed(Format::zip,
             with_utf8_flag(pack(Format::zip, {{no_utf8, "x"}, {"labs/05_normal_map/lab.cpp", "mine"}})))
          .unpack();
  EXPECT_EQ(broken.files.size(), 1U) << broken.fault;
  EXPECT_EQ(reason_of(broken, "(an entry without a name)"), "has no name");
}

TEST(Unpack, ends_a_name_at_its_first_zero) {
  std::string zip = pack(Format::zip, {{"labs/05_normal_map/lab.cpp?/../../x", "mine"}});
  for (std::size_t at = zip.find('?'); at != std::string::npos; at = zip.find('?', at)) zip[at] = '\0';
  const Submission submission = Handed(Format::zip, zip).unpack();
  EXPECT_EQ(submission.files, (std::map<std::string, std::string>{{"labs/05_normal_map/lab.cpp", "mine"}}));
}

TEST(Unpack, takes_no_encrypted_file) {
  const Submission submission =
      Handed(Format::zip, pack(Format::zip, {{"labs/05_normal_map/lab.cpp", "secret"}}, "password")).unpack();
  EXPECT_TRUE(submission.files.empty());
  EXPECT_EQ(reason_of(submission, "labs/05_normal_map/lab.cpp"), "is encrypted");
}

TEST(Unpack, says_which_file_is_saved_as_utf_16) {
  for (const char* mark : {"\xff\xfe", "\xfe\xff"}) {
    const Submission submission =
        Handed(Format::zip, {{"labs/05_normal_map/lab.cpp", mark},
                             {"labs/01_texture_quad/lab.cpp", "\xef\xbb\xbf// UTF-8"}})
            .unpack();
    EXPECT_EQ(submission.files.size(), 1U);
    EXPECT_EQ(reason_of(submission, "labs/05_normal_map/lab.cpp"), "is saved as UTF-16; save it as UTF-8");
  }
}

TEST(Unpack, takes_no_file_over_a_mebibyte) {
  const std::string large((1U << 20U) + 1, '/');
  for (const Format format : {Format::zip, Format::tar_gz}) {
    const Submission submission = Handed(format, {{"labs/05_normal_map/lab.cpp", large},
                                                  {"labs/01_texture_quad/lab.cpp", large.substr(1)}})
                                      .unpack();
    EXPECT_EQ(submission.files.size(), 1U);
    EXPECT_EQ(reason_of(submission, "labs/05_normal_map/lab.cpp"), "is larger than 1024 KiB");
  }
}

TEST(Unpack, refuses_bombs) {
  const std::string zeros(17U << 20U, '\0');
  for (const Format format : {Format::zip, Format::tar_gz}) {
    const Handed bomb(format, {{"a", zeros}, {"labs/05_normal_map/lab.cpp", "x"}});
    EXPECT_TRUE(has(bomb.unpack().fault, "bomb"));
    EXPECT_TRUE(bomb.unpack().files.empty());
  }
  UnpackLimits small;
  small.unpacked = 1000;
  const std::string text(600, 'x');
  EXPECT_TRUE(has(Handed(Format::tar_gz, {{"a", text}, {"b", text}}).unpack(small).fault, "bomb"));
  small.archive = 100;
  EXPECT_TRUE(has(Handed(Format::zip, {{"a", text}}).unpack(small).fault, "larger"));
}

TEST(Unpack, stops_early_in_an_archive_of_too_many_files) {
  std::vector<Packed> files;
  for (int i = 0; i < 12'000; ++i) files.push_back({"f" + std::to_string(i), ""});
  for (const Format format : {Format::zip, Format::tar_gz}) {
    std::string bytes = pack(format, files);
    EXPECT_TRUE(has(Handed(format, bytes).unpack().fault, "more than 10000 files"));
    // Who reads on finds that it is broken.
    if (format == Format::tar_gz) bytes.resize(bytes.size() - 20);
    EXPECT_TRUE(has(Handed(format, bytes).unpack().fault, "more than 10000 files"));
  }
}

TEST(Unpack, calls_a_broken_archive_broken) {
  std::string content;  // that cannot be packed much
  for (std::uint32_t i = 0; i < 5000; ++i) content += static_cast<char>(i * i * 2654435761U >> 24U);
  const std::vector<Packed> files = {{"labs/05_normal_map/lab.cpp", content}};
  std::string zip = pack(Format::zip, files);
  const std::string tar = pack(Format::tar_gz, files);
  std::vector<std::pair<Format, std::string>> broken = {{Format::zip, "PK"},
                                                        {Format::zip, "not an archive"},
                                                        {Format::zip, zip.substr(0, 60)},
                                                        {Format::tar_gz, "not an archive"},
                                                        {Format::tar_gz, tar.substr(0, tar.size() / 2)},
                                                        {Format::tar_gz, tar.substr(0, tar.size() - 100)}};
  zip[zip.size() / 2] = static_cast<char>(zip[zip.size() / 2] ^ 0x55);
  broken.emplace_back(Format::zip, zip);
  for (const auto& [format, bytes] : broken) {
    const Submission submission = Handed(format, bytes).unpack();
    EXPECT_TRUE(has(submission.fault, "broken")) << bytes.size() << submission.fault;
    EXPECT_TRUE(submission.files.empty());
  }
  EXPECT_EQ(Handed(Format::zip, std::string()).unpack().fault, "is empty");
  EXPECT_EQ(Handed(Format::zip, std::vector<Packed>()).unpack().fault, "is an archive without files");
  EXPECT_TRUE(has(Handed(Format::zip, "%PDF-1.4").unpack().fault, "hand in a folder, a .zip or a .tar.gz"));
}

TEST(Unpack, goes_by_what_an_archive_is_and_not_by_its_name) {
  const std::vector<Packed> files = {{"labs/05_normal_map/lab.cpp", "mine"}};
  for (const auto& [name, format] :
       {std::pair(Format::zip, Format::tar_gz), std::pair(Format::tar_gz, Format::zip)})
    EXPECT_EQ(Handed(name, pack(format, files)).unpack().files.size(), 1U);
}

TEST(Unpack, takes_a_folder_and_follows_nothing_in_it) {
  const test::TemporaryFolder folder("class");
  const test::TemporaryFolder outside("outside");
  write_file(outside / "lab.cpp", "secret");
  const fs::path work = folder / "jane/my work";
  fs::create_directories(work / "labs/01_texture_quad");
  fs::create_directories(work / "shaders/05_normal_map");
  fs::create_directory_symlink(path_of(outside), work / "labs/05_normal_map");
  fs::create_symlink(outside / "lab.cpp", work / "shaders/05_normal_map/decode_normal.glsl");
  ASSERT_EQ(::mkfifo((work / "shaders/05_normal_map/tangent_frame.glsl").c_str(), 0600), 0);
  write_file(work / "labs/01_texture_quad/lab.cpp", "mine");
  write_file(work / "large.txt", std::string((1U << 20U) + 1, 'x'));
  fs::create_directory(work / ".git");
  write_file(work / ".git/config", "hidden");
  const Entry entry = read_class(path_of(folder)).at(0);
  const Submission submission = unpack(entry, allowed);
  EXPECT_EQ(submission.root, "my work/");
  EXPECT_EQ(submission.files, (std::map<std::string, std::string>{{"labs/01_texture_quad/lab.cpp", "mine"}}));
  EXPECT_EQ(reason_of(submission, "my work/labs/05_normal_map"), "is a symbolic link");
  EXPECT_EQ(reason_of(submission, "my work/shaders/05_normal_map/decode_normal.glsl"), "is a symbolic link");
  EXPECT_EQ(reason_of(submission, "my work/shaders/05_normal_map/tangent_frame.glsl"),
            "is a device, pipe or socket");
  EXPECT_EQ(reason_of(submission, "my work/large.txt"), "is larger than 1024 KiB");
  EXPECT_EQ(reason_of(submission, "my work/.git"), "is hidden or belongs to the system");
  UnpackLimits few;
  few.entries = 3;
  EXPECT_TRUE(has(unpack(entry, allowed, few).fault, "more than 3 files"));
}

TEST(Unpack, takes_a_whole_mebibyte_out_of_a_folder_and_no_more) {
  const test::TemporaryFolder folder("class");
  std::string whole;
  while (whole.size() < (1U << 20U)) whole += "line " + std::to_string(whole.size()) + "\n";
  whole.resize(1U << 20U);
  for (const char* lab : {"jane/labs/01_texture_quad", "jane/labs/05_normal_map"})
    fs::create_directories(folder / lab);
  write_file(folder / "jane/labs/01_texture_quad/lab.cpp", whole);
  write_file(folder / "jane/labs/05_normal_map/lab.cpp", whole + "/");
  const Submission submission = unpack(read_class(path_of(folder)).at(0), allowed);
  EXPECT_EQ(submission.files.size(), 1U);
  EXPECT_TRUE(submission.files.at("labs/01_texture_quad/lab.cpp") == whole);
  EXPECT_EQ(reason_of(submission, "labs/05_normal_map/lab.cpp"), "is larger than 1024 KiB");
}

TEST(Overlay, can_be_read_by_the_sandbox_whatever_the_umask) {
  const test::TemporaryFolder tree("overlay_tree");
  const test::TemporaryFolder out("overlay_out");
  const mode_t before = ::umask(077);
  fs::create_directory(tree / "labs");
  write_file(tree / "labs/closed", "closed");
  overlay(path_of(tree), {{"labs/new/lab.cpp", "mine"}}, out / "work");
  ::umask(before);
  for (const char* name : {"", "labs", "labs/new"})
    EXPECT_EQ(fs::status(out / "work" / name).permissions(), fs::perms(0755)) << name;
  for (const char* name : {"labs/closed", "labs/new/lab.cpp"})
    EXPECT_EQ(fs::status(out / "work" / name).permissions(), fs::perms(0644)) << name;
  EXPECT_EQ(fs::status(tree / "labs/closed").permissions(), fs::perms(0600));
}

TEST(Overlay, lays_files_over_a_tree_and_leaves_the_tree_alone) {
  const test::TemporaryFolder tree("overlay_tree");
  const test::TemporaryFolder out("overlay_out");
  fs::create_directories(tree / "labs/01_texture_quad");
  write_file(tree / "labs/01_texture_quad/lab.cpp", "starter");
  write_file(tree / "CMakeLists.txt", "trusted");
  const fs::path to = out / "work";
  overlay(path_of(tree), {{"labs/01_texture_quad/lab.cpp", "mine"}, {"labs/new/file.hpp", "new"}}, to);
  EXPECT_EQ(read_file(to / "labs/01_texture_quad/lab.cpp"), "mine");
  EXPECT_EQ(read_file(to / "labs/new/file.hpp"), "new");
  EXPECT_EQ(read_file(to / "CMakeLists.txt"), "trusted");
  EXPECT_EQ(read_file(tree / "labs/01_texture_quad/lab.cpp"), "starter");
  EXPECT_THROW(overlay(path_of(tree), {}, to), Error);  // not empty
  for (const char* path : {"../x", "/etc/x", "", "a/../../x", "labs/"})
    EXPECT_THROW(overlay(path_of(tree), {{path, "x"}}, out / "other"), Error) << path;
  fs::create_symlink("/etc/passwd", tree / "link");
  EXPECT_THROW(overlay(path_of(tree), {}, out / "linked"), Error);
}

}  // namespace
}  // namespace texel::grade
