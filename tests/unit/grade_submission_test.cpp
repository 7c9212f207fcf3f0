// SPDX-License-Identifier: MIT
// Class folders, and submissions sound and hostile.
#include "grade/submission.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <clocale>
#include <map>
#include <numeric>

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
using test::put;
using test::with_utf8_flag;
using Texts = std::map<std::string, std::string>;

const std::string kQuad = "labs/01_texture_quad/lab.cpp", kLab = "labs/05_normal_map/lab.cpp",
                  kDecode = "shaders/05_normal_map/decode_normal.glsl",
                  kFrame = "shaders/05_normal_map/tangent_frame.glsl", kWeld = "labs/04_cube_wrap/weld.cpp";
const std::vector<std::string> allowed = {kWeld, kQuad, kLab, kDecode, kFrame};
const std::string kMebibyte(1U << 20U, '/');

/// A starter without steps.
std::string no_step(const std::string& /*file*/) {
  return {};
}

/// What an archive of that name holds, alone in a class.
Submission unpacked(Format name, const std::string& bytes, const UnpackLimits& limits = {},
                    const FirstText& first_text = no_step) {
  const test::TemporaryFolder folder;
  write_file(folder / (name == Format::zip ? "jane.zip" : "jane.tar.gz"), bytes);
  return unpack(read_class(folder.path()).at(0), allowed, first_text, limits);
}

std::string reason_of(const Submission& submission, const std::string& path) {
  for (const store::Ignored& ignored : submission.ignored)
    if (ignored.path == path) return ignored.reason;
  return "not ignored";
}

std::map<std::string, Entry> class_of(const std::vector<std::string>& file_names) {
  const test::TemporaryFolder folder;
  for (const std::string& name : file_names)
    if (name.ends_with('/'))
      fs::create_directory(folder / name);
    else
      write_file(folder / name, "x");
  std::map<std::string, Entry> entries;
  for (const Entry& entry : read_class(folder.path())) EXPECT_TRUE(entries.emplace(entry.id, entry).second);
  EXPECT_EQ(entries.size(), file_names.size());
  return entries;
}

TEST(ReadClass, knows_the_names_of_canvas_moodle_and_plain_ones) {
  using Kind = Entry::Kind;
  using Row = std::tuple<const char*, const char*, const char*, const char*, Kind>;
  for (const auto& [file, id, name, number, kind] : std::vector<Row>{
           {"doejane_12345_678_labs.zip", "doejane-12345", "doejane", "12345", Kind::zip},
           {"roejohn_LATE_222_333_my_labs-1.tar.gz", "roejohn-222", "roejohn", "222", Kind::tar},
           {"Jane Q. Doe_1234_assignsubmission_file/", "jane-q-doe-1234", "Jane Q. Doe", "1234",
            Kind::folder},
           {"Max Roe_77_assignsubmission_file_labs.zip", "max-roe-77", "Max Roe", "77", Kind::zip},
           {"anna.tgz", "anna", "anna", "", Kind::tar},
           {"<script>alert(1)<script>.zip", nullptr, "<script>alert(1)<script>", "", Kind::zip},
           {"jane.rar", nullptr, "jane.rar", "", Kind::other}}) {
    const Entry entry = class_of({file}).begin()->second;
    EXPECT_TRUE(id == nullptr || entry.id == id) << entry.id;
    EXPECT_EQ(entry.name, name);
    EXPECT_EQ(entry.number, number) << file;
    EXPECT_EQ(entry.kind, kind) << file;
    if (kind != Kind::other) continue;
    EXPECT_EQ(unpack(entry, allowed, no_step).fault, "is not a folder, a .zip or a .tar.gz file");
  }
}

TEST(ReadClass, tells_students_with_the_same_name_apart) {
  class_of({"jane.zip", "jane.tar.gz", "jane/", "Jane.zip", "JANE.zip", "J\xC3\xA4ne.zip", "J\xC3\xB6ne.zip",
            "doe_1_2_labs.zip", "doe_1_3_labs.zip", "doe_2_4_labs.zip", "Doe_1_assignsubmission_file/"});
  const std::string alone = class_of({"Jane Doe.zip"}).begin()->first;
  EXPECT_TRUE(class_of({"Jane Doe.zip", "jane doe.zip", "jane-doe.zip", "Jane_Doe.zip"}).contains(alone));
  // An id is of the name, and not of the place in the class.
  const auto three = class_of({"jane.tar.gz", "jane.tgz", "jane.zip"});
  for (const auto& [id, entry] : class_of({"jane.tgz", "jane.zip"}))
    EXPECT_EQ(three.at(id).path.filename(), entry.path.filename());
}

TEST(ReadClass, makes_ids_safe_and_keeps_names_as_text) {
  for (const auto& [id, entry] :
       class_of({"<script>alert(1)<script>.zip", "=HYPERLINK(\"x\").zip", "$(touch hacked).zip", "-rf.zip",
                 "a\nb.zip", "\xFF\xFE.zip", "\xE2\x80\xAEgpj.zip", "'; DROP TABLE scores; --.zip",
                 std::string(200, 'x') + ".zip", "_1_2_3.zip", "___.zip", "con\\..\\x.zip"})) {
    EXPECT_LE(id.size(), 100U);
    EXPECT_EQ(id.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-_"), id.npos) << id;
    EXPECT_TRUE(id[0] != '-' && id[0] != '_') << id;
    for (const char* strange : {"\n", "\xFF", "\xE2\x80\xAE"}) EXPECT_FALSE(has(entry.name, strange)) << id;
  }
}

TEST(ReadClass, takes_an_archive_alone_in_a_folder_for_the_submission) {
  const test::TemporaryFolder folder;
  put(folder / "Jane Doe_1_assignsubmission_file", {{"labs.zip", pack(Format::zip, {{kLab, "mine"}})}});
  const Entry entry = read_class(folder.path()).at(0);
  EXPECT_EQ(entry.id, "jane-doe-1");
  EXPECT_EQ(entry.kind, Entry::Kind::zip);
  EXPECT_EQ(unpack(entry, allowed, no_step).files, (Texts{{kLab, "mine"}}));
}

TEST(ReadClass, follows_no_link_and_throws_for_a_missing_folder) {
  const test::TemporaryFolder folder;
  fs::create_directory_symlink("/etc", folder / "jane");
  const Entry link = read_class(folder.path()).at(0);
  EXPECT_EQ(link.kind, Entry::Kind::other);
  EXPECT_TRUE(unpack(link, allowed, no_step).fault.starts_with("is a symbolic link, which is not followed"));
  EXPECT_THROW(read_class(folder / "missing"), Error);
}

TEST(StepFiles, are_the_files_of_the_tree_with_a_marker) {
  const test::TemporaryFolder tree;
  put(tree.path(), {{"labs/01_a/lab.cpp", "int x;\n    //@step 1.1 begin\n//@end\n"},
                    {"labs/01_a/other.hpp", "// the marker //@step is explained here\n"},
                    {"shaders/lib/light.glsl", "//@step 5.1 begin\n"},
                    {"tests/test.cpp", "//@step 5.1 begin\n"}});
  EXPECT_EQ(course::step_files(tree.path()),
            (std::vector<std::string>{"labs/01_a/lab.cpp", "shaders/lib/light.glsl"}));
  EXPECT_THROW(course::step_files(tree / "tests"), Error);
}

/// What labs 3 and 4 of a starter have of four steps.
std::string first_text(const std::string& file) {
  const std::string step = has(file, "corner_numbers") ? "3.4"
                           : has(file, "face_index")   ? "3.2"
                           : has(file, "split_cube")   ? "4.4"
                           : has(file, "seam")         ? "6.2"
                                                       : "4.2";
  return fmt::format("#include \"new\"\n//@step {} begin\nfirst();\n//@end\n", step);
}

std::string with(const std::string& file, const std::string& code) {
  std::string text = first_text(file);
  return text.replace(text.find("first();"), 8, code);
}

TEST(Unpack, takes_steps_out_of_the_files_that_an_older_starter_had_them_in) {
  const std::string numbers = "labs/03_obj_texcoords/corner_numbers.cpp", weld = "labs/04_cube_wrap/weld.cpp",
                    index = "labs/03_obj_texcoords/face_index.cpp", older = "common/mesh/weld.cpp",
                    lab = "labs/04_cube_wrap/lab.cpp", cube = "labs/04_cube_wrap/split_cube.cpp",
                    seam = "shaders/06_cube_map/seam.glsl";
  const std::vector<std::string> files = {index, numbers, cube, weld, seam};
  const auto step = [](const std::string& id, const std::string& code) {
    return fmt::format("//@step {} begin\n{}\n//@end\n", id, code);
  };
  struct Row {
    const char* name;
    std::vector<Packed> handed;
    Texts taken;
    std::string path, reason;  ///< of an ignored file
  };
  const Row rows[] = {
      {"both steps of one file",
       {{"tree/" + older, "#include \"old\"\n" + step("3.4", "mine();") + step("4.2", "own();")}},
       {{numbers, with(numbers, "mine();")}, {weld, with(weld, "own();")}},
       "tree/" + older,
       "is a file of an older starter; taken out of it: step 3.4, now in " + numbers + ", step 4.2, now in " +
           weld},
      {"a step that is not begun",
       {{older, step("3.4", "first();") + step("4.2", "own();")}},
       {{weld, with(weld, "own();")}},
       older,
       "is a file of an older starter; taken out of it: step 4.2, now in " + weld},
      {"a step that is begun in both",
       {{older, step("4.2", "old();")}, {weld, with(weld, "new();")}},
       {{weld, with(weld, "new();")}},
       older,
       "is a file of an older starter; not taken: step 4.2, since it is begun in " + weld},
      {"a step that is begun in the older file alone",
       {{older, step("4.2", "old();")}, {weld, first_text(weld)}},
       {{weld, with(weld, "old();")}},
       older,
       "is a file of an older starter; taken out of it: step 4.2, now in " + weld},
      {"markers in too many places",
       {{older, step("4.2", "one();") + step("4.2", "two();")}, {index, with(index, "i();")}},
       {{index, with(index, "i();")}},
       older,
       "is a file of an older starter; not taken: step 4.2, since its markers are damaged"},
      {"the course's own file of that name",
       {{older, "int weld();\n"}, {index, with(index, "i();")}},
       {{index, with(index, "i();")}},
       older,
       "is not a file with steps"},
      {"no step that is begun",
       {{older, step("4.2", "first();")}, {index, with(index, "i();")}},
       {{index, with(index, "i();")}},
       older,
       "is a file of an older starter without a step that is begun"},
      {"a step with names that are gone",
       {{lab, "#include \"mesh/cube.hpp\"\n" + step("4.4", "mesh::cube_by_face(); mesh::cube_split();")}},
       {{cube, with(cube, "cube_by_face(); mesh::cube_split();")}},
       lab,
       "is a file of an older starter; taken out of it: step 4.4, now in " + cube},
      {"a file of today that includes what is gone",
       {{seam, "#include \"lib/sphere_coordinates.glsl\"\n" + step("6.2", "own();")}},
       {{seam, with(seam, "own();")}},
       seam,
       "is of an older starter; taken out of it: step 6.2"},
      {"a name alone is that of a file of today",
       {{"weld.cpp", with(weld, "own();")}},
       {{weld, with(weld, "own();")}},
       "weld.cpp",
       "not ignored"},
  };
  for (const Row& row : rows) {
    SCOPED_TRACE(row.name);
    const test::TemporaryFolder folder;
    write_file(folder / "jane.zip", pack(Format::zip, row.handed));
    const Submission submission = unpack(read_class(folder.path()).at(0), files, first_text);
    EXPECT_EQ(submission.fault, "");
    EXPECT_EQ(submission.files, row.taken);
    EXPECT_EQ(reason_of(submission, row.path), row.reason);
  }
}

/// An archive, and what becomes of its files.
struct Archive {
  std::vector<Packed> files;
  Texts taken;
  Texts ignored = {};  ///< words of the reason, by path; of those that are not named the reason is not asked
  std::string fault = {};  ///< how it begins, or ""
  std::string root = {};
  std::vector<Format> formats = {Format::zip, Format::tar_gz};
};

void expect(const std::vector<Archive>& archives) {
  for (const Archive& archive : archives)
    for (const Format format : archive.formats) {
      SCOPED_TRACE(archive.files.at(0).path + (format == Format::zip ? " in a .zip" : " in a .tar.gz"));
      const Submission submission = unpacked(format, pack(format, archive.files));
      EXPECT_EQ(submission.files, archive.taken);
      EXPECT_EQ(submission.root, archive.root);
      EXPECT_EQ(submission.files.size() + submission.ignored.size(), archive.files.size());
      for (const auto& [path, reason] : archive.ignored)
        EXPECT_TRUE(has(reason_of(submission, path), reason)) << path << reason_of(submission, path);
      EXPECT_EQ(submission.fault.substr(0, archive.fault.size()), archive.fault);
      EXPECT_EQ(submission.fault.empty(), !submission.files.empty()) << submission.fault;
    }
}

/// Files that have their own path as content; which of them is taken for what.
Archive of_paths(const std::vector<std::string>& paths, const std::string& root, const Texts& taken) {
  Archive archive{{}, taken};
  for (const std::string& path : paths) archive.files.push_back({path, path});
  archive.root = root, archive.formats = {Format::tar_gz};
  return archive;
}

TEST(Unpack, finds_the_root_wherever_it_lies) {
  const std::string windows = "home\\jane\\labs\\05_normal_map\\lab.cpp";
  const std::string capitals = "Labs/05_Normal_Map/Lab.cpp",
                    loud = "SHADERS/05_normal_map/tangent_frame.glsl";
  const std::string deep = "a/labs/labs/05_normal_map/lab.cpp",
                    deeper = "b/shaders/shaders/05_normal_map/tangent_frame.glsl";
  const std::string part = "05_normal_map/lab.cpp", frame_part = "05_normal_map/tangent_frame.glsl";
  const std::string loose = "tangent_frame.glsl", jane = "Jane's work/texel/";
  expect({
      of_paths({"./" + kLab, kFrame}, "", {{kLab, "./" + kLab}, {kFrame, kFrame}}),
      of_paths({jane + kLab}, jane, {{kLab, jane + kLab}}),
      of_paths({part}, "", {{kLab, part}}),
      of_paths({part, frame_part}, "", {{kLab, part}, {kFrame, frame_part}}),
      of_paths({loose}, "", {{kFrame, loose}}),
      of_paths({windows}, "home/jane/", {{kLab, windows}}),
      // The tree with more of the labs; and of two alike the first by bytes.
      of_paths({"old/" + kLab, "new/" + kLab, "new/" + kFrame}, "new/",
               {{kLab, "new/" + kLab}, {kFrame, "new/" + kFrame}}),
      of_paths({"b/" + kLab, "a/" + kLab}, "a/", {{kLab, "a/" + kLab}}),
      // Before that the one that lies less deep.
      of_paths({"a/b/" + kLab, "z/" + kLab}, "z/", {{kLab, "z/" + kLab}}),
      // One that names more of its place goes before a loose one.
      of_paths({kFrame, loose}, "", {{kFrame, kFrame}}),
      // Capitals, and folders inside folders, where one file alone can be meant.
      of_paths({capitals, loud}, "", {{kLab, capitals}, {kFrame, loud}}),
      of_paths({"Labs/05_normal_map/lab.cpp", kLab}, "", {{kLab, kLab}}),
      of_paths({deep, deeper}, "a/labs/", {{kLab, deep}, {kFrame, deeper}}),
      of_paths(
          {kFrame, "shaders/05_normal_map/Decode_normal.glsl", "shaders/05_normal_map/DECODE_NORMAL.glsl"},
          "", {{kFrame, kFrame}}),
      // A name alone says too little outside the root.
      of_paths({kLab, "x/tangent_frame.glsl"}, "", {{kLab, kLab}}),
      of_paths({"lab.cpp"}, "", {}),
      of_paths({"readme.txt"}, "", {}),
  });
}

TEST(Unpack, takes_allowed_files_and_says_why_not_the_others) {
  const std::string long_name = std::string(256, 'n') + ".cpp", lab = "labs/05_normal_map/";
  const std::string shader = "shaders/05_normal_map/";
  const std::vector<Format> zip = {Format::zip}, tar = {Format::tar_gz};
  expect({
      {{{kLab, "mine"},
        {lab + "lab.toml", "points = 100"},
        {"CMakeLists.txt", "execute_process(COMMAND sh)"},
        {"more.zip", "PK"},
        {".git/config", "hidden"},
        {"__MACOSX/" + lab + "._lab.cpp", "mac"}},
       {{kLab, "mine"}},
       {{"CMakeLists.txt", "no"},
        {lab + "lab.toml", "not a file with steps"},
        {"more.zip", "archive"},
        {".git/config", "hidden"}}},
      {{{"lab.cpp", "whose?"}}, {}, {{"lab.cpp", kQuad + ", " + kLab}}},
      {{{kDecode, ""},
        {kQuad, ""},
        {"old/" + kLab, ""},
        {"older/" + kLab, ""},
        {shader + "Tangent_Frame.glsl", ""},
        {shader + "TANGENT_FRAME.glsl", ""}},
       {{kDecode, ""}, {kQuad, ""}},
       {{"old/" + kLab,
         "is one of 2 files for labs/05_normal_map/lab.cpp, and none of them is in the top folder, which "
         "is graded"},
        {shader + "TANGENT_FRAME.glsl",
         "should be called shaders/05_normal_map/tangent_frame.glsl: upper and lower case matter where "
         "there are two"}}},
      {{{kLab, "old"}, {kLab, "new"}}, {{kLab, "new"}}},
      {{{kLab, "", AE_IFLNK, "/etc/passwd"},
        {"labs", "", AE_IFLNK, "/etc"},
        {kQuad, "mine"},
        {kWeld, "", AE_IFREG, kQuad},
        {kDecode, "", AE_IFCHR},
        {kFrame, "", AE_IFIFO}},
       {{kQuad, "mine"}},
       {{kLab, "is a symbolic link"},
        {kWeld, "is a hard link"},
        {kDecode, "is a device, pipe or socket"},
        {kFrame, "is a device, pipe or socket"}},
       {},
       {},
       tar},
      {{{kLab, "", AE_IFLNK, "/etc/passwd"}}, {}, {{kLab, "is a symbolic link"}}, {}, {}, zip},
      {{{long_name, "x"}, {"\xff\xfe.cpp", "x"}},
       {},
       {{long_name, "is not a file with steps"}, {"\uFFFD\uFFFD.cpp", "is not a file with steps"}},
       "contains no file with steps, so nothing was taken (2 files"},
      {{{kLab, "\xff\xfe"}, {kFrame, "\xfe\xff"}, {kQuad, "\xef\xbb\xbf// UTF-8"}},
       {{kQuad, "\xef\xbb\xbf// UTF-8"}},
       {{kLab, "is saved as UTF-16; save it as UTF-8"}, {kFrame, "is saved as UTF-16; save it as UTF-8"}}},
      {{{kLab, kMebibyte + "/"}, {kQuad, kMebibyte}},
       {{kQuad, kMebibyte}},
       {{kLab, "is larger than 1024 KiB"}}},
  });
}

TEST(Unpack, takes_no_path_that_leaves_the_submission_and_no_strange_name) {
  const std::pair<const char*, std::vector<std::string>> rows[] = {
      {"absolute", {"/", "C:\\"}},
      {"..", {"../", "x/../", "..\\"}},
      {"control", {"a\nb/", "a\x1b[2J/"}},
      {"too long", {std::string(1200, 'a') + "/"}}};
  for (const auto& [reason, places] : rows)
    for (const std::string& before : places) {
      const Submission submission = unpacked(Format::tar_gz, pack(Format::tar_gz, {{before + kLab, "x"}}));
      EXPECT_TRUE(submission.files.empty()) << before;
      ASSERT_EQ(submission.ignored.size(), 1U) << before;
      EXPECT_TRUE(has(submission.ignored[0].reason, reason)) << submission.ignored[0].reason;
      EXPECT_FALSE(has(submission.ignored[0].path, "\x1b"));
    }
}

TEST(Unpack, takes_of_two_copies_the_one_with_more_steps_begun) {
  const std::string given = "//@step 5.1 begin\n//@end\n//@step 5.2 begin\n//@end\n",
                    done = "//@step 5.1 begin\na();\n//@end\n//@step 5.2 begin\nb();\n//@end\n";
  for (const Format format : {Format::zip, Format::tar_gz})
    // The name does not decide, nor which one has more files.
    for (const auto& [work, backup] : std::vector<std::pair<std::string, std::string>>{
             {"labs-new/", "labs-backup/"}, {"a/", "b/"}, {"x/old/", ""}, {"", "old/"}}) {
      const std::string bytes =
          pack(format, {{backup + kLab, given}, {backup + kFrame, given}, {work + kLab, done}});
      const Submission submission = unpacked(format, bytes, {}, [&](const std::string&) { return given; });
      EXPECT_EQ(submission.root, work);
      // Of the other file there is one copy alone.
      EXPECT_EQ(submission.files, (Texts{{kLab, done}, {kFrame, given}}));
      ASSERT_EQ(submission.copies.size(), 1U);
      EXPECT_EQ(submission.copies[0].path, backup.empty() ? "/" : backup);
      EXPECT_TRUE(has(submission.copies[0].reason, "0 steps are begun in it, and 2 in "));
    }
}

TEST(Unpack, takes_files_from_folders_with_names_in_any_encoding_and_locale) {
  const std::vector<std::string> utf8 = {"\u00dcbung 9 \u2013 L\u00f6sung", "\u4f5c\u4e1a\u4e5d",
                                         "final \U0001F642"};
  // The same in CP437, CP1252, GBK (whose second bytes may be '\\') and Shift-JIS, without a word of it.
  const std::vector<std::string> others = {"\232bung 9 - L\224sung",   "\334bung 9 \226 L\366sung",
                                           "\xd7\xf7\xd2\xb5\xbe\xc5", "\x81\\ \xd7\x5c",
                                           "\x83\x5c\x95\x5c",         "\xC0\xAF"};
  for (const char* locale : {"C", "C.UTF-8"}) {
    ASSERT_NE(std::setlocale(LC_ALL, locale), nullptr);
    for (const bool is_utf8 : {true, false})
      for (const std::string& folder : is_utf8 ? utf8 : others)
        for (const Format format : {Format::zip, Format::tar_gz}) {
          SCOPED_TRACE(folder + " in " + locale);
          // In a locale with UTF-8 the packer would say that these bytes are.
          std::setlocale(LC_ALL, "C");
          std::string bytes =
              pack(format, {{folder + "/" + kLab, "mine"}, {folder + "/" + kFrame, "mine too"}});
          std::setlocale(LC_ALL, locale);
          if (is_utf8 && format == Format::zip) bytes = with_utf8_flag(bytes);
          const Submission submission = unpacked(format, bytes);
          EXPECT_EQ(submission.fault, "");
          EXPECT_EQ(submission.files, (Texts{{kLab, "mine"}, {kFrame, "mine too"}}));
          EXPECT_TRUE(!is_utf8 || submission.root == folder + "/") << submission.root;
        }
    for (const std::string& name : {utf8[0], others[0]}) {
      const test::TemporaryFolder folder;
      put(folder / "jane" / name, {{kLab, "mine"}});
      EXPECT_EQ(unpack(read_class(folder.path()).at(0), allowed, no_step).files.count(kLab), 1U) << name;
    }
  }
  std::setlocale(LC_ALL, "C");
}

TEST(Unpack, takes_what_a_zip_says_oddly_and_nothing_that_is_encrypted) {
  // Names that say that they are UTF-8 and are not: libarchive gives such a name no text.
  const Submission unnamed =
      unpacked(Format::zip, with_utf8_flag(pack(Format::zip, {{"\xff\xfe.cpp", "x"}, {kLab, "mine"}})));
  EXPECT_EQ(unnamed.files, (Texts{{kLab, "mine"}})) << unnamed.fault;
  EXPECT_EQ(reason_of(unnamed, "(an entry without a name)"), "has no name");
  // A name ends at its first zero.
  std::string zip = pack(Format::zip, {{kLab + "?/../../x", "mine"}});
  std::replace(zip.begin(), zip.end(), '?', '\0');
  EXPECT_EQ(unpacked(Format::zip, zip).files, (Texts{{kLab, "mine"}}));
  const Submission secret = unpacked(Format::zip, pack(Format::zip, {{kLab, "secret"}}, "password"));
  EXPECT_TRUE(secret.files.empty());
  EXPECT_EQ(reason_of(secret, kLab), "is encrypted");
}

TEST(Unpack, goes_by_what_an_archive_is_and_not_by_its_name) {
  for (const auto& [name, format] :
       {std::pair(Format::zip, Format::tar_gz), std::pair(Format::tar_gz, Format::zip)})
    EXPECT_EQ(unpacked(name, pack(format, {{kLab, "mine"}})).files.size(), 1U);
}

TEST(Unpack, refuses_bombs_and_what_is_broken_or_no_archive) {
  std::string content;  // that cannot be packed much
  for (std::uint32_t i = 0; i < 5000; ++i) content += static_cast<char>(i * i * 2654435761U >> 24U);
  std::vector<Packed> many;
  for (int i = 0; i < 12'000; ++i) many.push_back({"f" + std::to_string(i), ""});
  const std::vector<Packed> sound = {{kLab, content}},
                            bomb = {{"a", std::string(17U << 20U, '\0')}, {kLab, "x"}},
                            two = {{"a", std::string(600, 'x')}, {"b", std::string(600, 'x')}};
  const std::string zip = pack(Format::zip, sound), tar = pack(Format::tar_gz, sound),
                    many_in_tar = pack(Format::tar_gz, many);
  std::string flipped = zip;
  flipped[zip.size() / 2] = static_cast<char>(zip[zip.size() / 2] ^ 0x55);
  // A file in pieces, the second one before the first: GNU's header of a sparse file.
  std::string sparse = pack(Format::tar, {{kLab, std::string(1024, 'x')}});
  sparse.replace(156, 1, "S").replace(257, 8, std::string("ustar  \0", 8)).replace(148, 8, 8, ' ');
  for (const auto& [at, number] : {std::pair(386U, 512), {398, 512}, {410, 0}, {422, 512}, {483, 1024}})
    sparse.replace(at, 11, fmt::format("{:011o}", number));
  sparse.replace(148, 6, fmt::format("{:06o}", std::accumulate(sparse.begin(), sparse.begin() + 512, 0)));
  UnpackLimits small, smaller;
  small.unpacked = 1000;
  smaller.archive = 100;
  struct Row {
    Format name;
    std::string bytes, fault;
    UnpackLimits limits = {};
  };
  for (const auto& [name, bytes, fault, limits] : std::vector<Row>{
           {Format::zip, "PK", "broken"},
           {Format::zip, "not an archive", "broken"},
           {Format::zip, zip.substr(0, 60), "broken"},
           {Format::zip, flipped, "broken"},
           {Format::tar_gz, "not an archive", "broken"},
           {Format::tar_gz, tar.substr(0, tar.size() / 2), "broken"},
           {Format::tar_gz, tar.substr(0, tar.size() - 100), "broken"},
           {Format::tar_gz, sparse, "broken archive: Encountered out-of-order sparse blocks"},
           {Format::zip, "", "is empty: nothing was handed in"},
           {Format::zip, pack(Format::zip, {}), "is empty: nothing was handed in"},
           {Format::zip, "%PDF-1.4", "hand in a folder, a .zip or a .tar.gz"},
           {Format::zip, pack(Format::zip, bomb), "bomb"},
           {Format::tar_gz, pack(Format::tar_gz, bomb), "bomb"},
           {Format::tar_gz, pack(Format::tar_gz, two), "bomb", small},
           {Format::zip, pack(Format::zip, two), "larger", smaller},
           {Format::zip, pack(Format::zip, many), "more than 10000 files"},
           {Format::tar_gz, many_in_tar, "more than 10000 files"},
           // Who reads on finds that it is broken.
           {Format::tar_gz, many_in_tar.substr(0, many_in_tar.size() - 20), "more than 10000 files"}}) {
    const Submission submission = unpacked(name, bytes, limits);
    EXPECT_TRUE(has(submission.fault, fault)) << fault << " | " << submission.fault;
    EXPECT_TRUE(submission.files.empty());
  }
}

TEST(Unpack, takes_a_folder_and_follows_nothing_in_it) {
  const test::TemporaryFolder folder, outside;
  write_file(outside / "lab.cpp", "secret");
  const fs::path work = folder / "jane/my work";
  put(work, {{kQuad, kMebibyte}, {"large.txt", kMebibyte + "/"}, {".git/config", "hidden"}});
  fs::create_directories(work / "shaders/05_normal_map");
  fs::create_directory_symlink(outside.path(), work / "labs/05_normal_map");
  fs::create_symlink(outside / "lab.cpp", work / kDecode);
  ASSERT_EQ(::mkfifo((work / kFrame).c_str(), 0600), 0);
  const Entry entry = read_class(folder.path()).at(0);
  const Submission submission = unpack(entry, allowed, no_step);
  EXPECT_EQ(submission.root, "my work/");
  EXPECT_TRUE(submission.files == (Texts{{kQuad, kMebibyte}}));
  for (const auto& [path, reason] : Texts{{"labs/05_normal_map", "is a symbolic link"},
                                          {kDecode, "is a symbolic link"},
                                          {kFrame, "is a device, pipe or socket"},
                                          {"large.txt", "is larger than 1024 KiB"},
                                          {".git", "is hidden or belongs to the system"}})
    EXPECT_EQ(reason_of(submission, "my work/" + path), reason);
  UnpackLimits few;
  few.entries = 3;
  EXPECT_TRUE(has(unpack(entry, allowed, no_step, few).fault, "more than 3 files"));
}

TEST(Overlay, lays_files_over_a_tree_that_the_sandbox_can_read_whatever_the_umask) {
  const test::TemporaryFolder tree, out;
  const fs::path to = out / "work";
  const mode_t before = ::umask(077);
  put(tree.path(), {{kQuad, "starter"}, {"CMakeLists.txt", "trusted"}});
  overlay(tree.path(), {{kQuad, "mine"}, {"labs/new/file.hpp", "new"}}, to);
  ::umask(before);
  for (const auto& [path, text] :
       Texts{{kQuad, "mine"}, {"labs/new/file.hpp", "new"}, {"CMakeLists.txt", "trusted"}}) {
    EXPECT_EQ(read_file(to / path), text);
    EXPECT_EQ(fs::status(to / path).permissions(), fs::perms(0644)) << path;
  }
  for (const char* name : {"", "labs", "labs/01_texture_quad", "labs/new"})
    EXPECT_EQ(fs::status(to / name).permissions(), fs::perms(0755)) << name;
  EXPECT_EQ(read_file(tree / kQuad), "starter");
  EXPECT_EQ(fs::status(tree / kQuad).permissions(), fs::perms(0600));
  EXPECT_THROW(overlay(tree.path(), {}, to), Error);  // not empty
  for (const char* path : {"../x", "/etc/x", "", "a/../../x", "labs/"})
    EXPECT_THROW(overlay(tree.path(), {{path, "x"}}, out / "other"), Error) << path;
  fs::create_symlink("/etc/passwd", tree / "link");
  EXPECT_THROW(overlay(tree.path(), {}, out / "linked"), Error);
}

}  // namespace
}  // namespace texel::grade
