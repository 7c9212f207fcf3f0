// SPDX-License-Identifier: MIT
#include "mesh/obj.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <set>

#include "core/error.hpp"
#include "core/files.hpp"
#include "core/plain_text.hpp"
#include "core/stopwatch.hpp"
#include "mesh/polygon.hpp"
#include "text.hpp"

namespace texel::mesh {
namespace {

/// What stands before the next blank or the end.
std::string_view first_word(const char* at, const char* end) {
  return {at, static_cast<std::size_t>(std::find_if(at, end, is_blank) - at)};
}

/// Beyond it float32 has no fractions: a texture coordinate there tells nothing of a place in the picture,
/// and differences of larger ones could overflow.
constexpr float greatest_texcoord = 16777216.0F;

template <class Vector>
bool is_finite(const Vector& v) {
  return !glm::any(glm::isinf(v)) && !glm::any(glm::isnan(v));
}

/// Reads an integer off the front of [at, end); false when there is none or it has more than 18 digits.
inline bool take_integer(const char*& at, const char* end, std::int64_t& value) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  const char* next = at;  // a copy, which the compiler can keep in a register
  const bool negative = next != end && *next == '-';
  if (next != end && (*next == '-' || *next == '+')) ++next;
  const char* const first_digit = next;
  const char* const limit = end - next > 18 ? next + 18 : end;
  std::int64_t digits = 0;
  for (; next != limit && is_digit(*next); ++next) digits = 10 * digits + (*next - '0');
  value = negative ? -digits : digits;
  at = next;
  return next != first_digit && (next == end || !is_digit(*next));
}

/// What is repaired, ignored or missing, and how often. Nothing of it stops the import.
struct Trouble {
  std::string_view format;
  std::string text;
  std::uint64_t count = 0;
};

/// Says on standard error how far a large file is read, in one line that is written over.
class Progress {
 public:
  ~Progress() {
    if (has_said_) std::fputc('\n', stderr);
  }
  void say(const std::string& name, double part) {
    if (stopwatch_.milliseconds() < 500) return;
    std::fprintf(stderr, "\r%s: %.0f %% read", name.c_str(), 100 * part);
    has_said_ = true;
  }

 private:
  Stopwatch stopwatch_;
  bool has_said_ = false;
};

class Parser {
 public:
  Parser(std::string_view text, const std::string& name) : text_(text), name_(name), lines_(text) {}

  ObjData parse() {
    if (text_.empty()) throw Error::failed("the file is empty", {name_}, "choose an OBJ file");
    std::string_view line;
    {
      Progress progress;
      while (lines_.next(line)) {
        parse_line(line);
        if (lines_.lines_read() % (1U << 18U) == 0)
          progress.say(name_, static_cast<double>(lines_.bytes_read()) / static_cast<double>(text_.size()));
      }
    }
    finish();
    return std::move(data_);
  }

 private:
  [[nodiscard]] Place place(std::uint64_t line) const {
    return {name_, static_cast<int>(std::min<std::uint64_t>(line, INT32_MAX))};
  }

  [[noreturn]] void fail(const std::string& what, const std::string& remedy) const {
    throw Error::failed(what, place(lines_.line_number()), remedy);
  }

  /// Counts one more of a trouble; its warning says the `details` of the first.
  template <class... Details>
  [[gnu::cold]] void note(std::string_view format, const Details&... details) {
    auto found = std::ranges::find(troubles_, format, &Trouble::format);
    if (found == troubles_.end())
      found = troubles_.insert(found, Trouble{format, fmt::format(fmt::runtime(format), details...)});
    ++found->count;
  }

  void parse_line(std::string_view line) {
    const std::string_view whole = line;
    const std::string_view keyword = take_word(line);
    if (keyword.empty()) return;  // blank or a comment
    if (keyword == "v") return position_line(line);
    if (keyword == "f" || keyword == "fo") return face_line(line);
    if (keyword == "vt") return texcoord_line(line);
    if (keyword == "vn") return normal_line(line);
    if (keyword == "usemtl") return start_run(data_.material_runs, line);
    if (keyword == "g" || keyword == "o") return start_run(data_.group_runs, line);
    if (keyword == "s") return smoothing_line(line);
    if (keyword == "mtllib") return static_cast<void>(data_.libraries.emplace_back(trimmed(line)));
    if (keyword == "p" || keyword == "l") return note("points and lines ignored");
    if (whole.find('\0') != std::string_view::npos)
      fail("this is binary data, not text", "export the model as Wavefront OBJ in ASCII or UTF-8");
    ++unknown_lines_;
    note("lines with an unknown keyword, ignored; the first is {}", for_message(keyword));
  }

  /// The numbers on the rest of a line, of which there must be `least` to `most`.
  std::span<const float> numbers(std::string_view line, const char* keyword, std::size_t least,
                                 std::size_t most) {
    std::size_t count = 0;
    const char* at = line.data();
    const char* const end = at + line.size();
    bool all_finite = true;
    for (; skip_blanks(at, end); ++count) {
      if (count == most) fail(fmt::format("{} has more than {} numbers", keyword, most), "remove the rest");
      if (take_plain_number(at, end, numbers_[count])) continue;
      const std::string_view word = first_word(at, end);
      at += word.size();
      const NumberStatus status = parse_float(word, numbers_[count]);
      const bool has_comma = word.find(',') != std::string_view::npos;
      // A comma alone on its line may part two numbers.
      if (status == NumberStatus::malformed || (has_comma && count == 0 && !skip_blanks(at, end)))
        fail(for_message(word) + " is not a number", "write numbers as 1.5 or -2e-3");
      if (status == NumberStatus::repaired)
        note("numbers in an unusual spelling; the first is {}, read as {}", for_message(word),
             numbers_[count]);
      if (status == NumberStatus::not_finite) all_finite = false;
    }
    if (count < least)
      fail(fmt::format("{} has {} numbers and needs {}", keyword, count, least), "is the file cut off here?");
    if (!all_finite) {
      if (first_not_finite_ == 0) first_not_finite_ = lines_.line_number();
      note(
          "lines of v, vt and vn with NaN, infinity or more than a 32-bit float can hold, taken as missing; "
          "the first is line {}",
          first_not_finite_);
    }
    return {numbers_.data(), count};
  }

  /// Room for as many entries as the rest of the file can have when its lines are as long as this one. Memory
  /// that is reserved and not written costs nothing, and a list that need not grow is never copied.
  template <class Value>
  void reserve_by(std::vector<Value>& list, std::size_t line_length, std::size_t per_line) const {
    if (list.empty()) list.reserve(per_line * (1 + (text_.size() - lines_.bytes_read()) / (line_length + 2)));
  }

  void position_line(std::string_view line) {
    reserve_by(data_.positions, line.size(), 1);
    const std::span<const float> n = numbers(line, "v", 3, 7);
    if (n.size() == 5) fail("v has 5 numbers", "write x y z, x y z w or x y z r g b");
    data_.positions.push_back(position_from(n));
    if ((n.size() == 4 || n.size() == 7) && n[3] != 1.0F) note("weights (the fourth number of v) ignored");
  }

  void texcoord_line(std::string_view line) {
    reserve_by(data_.texcoords, line.size(), 1);
    const glm::vec2 texcoord = texcoord_from(numbers(line, "vt", 1, 3));
    const glm::vec2 kept =
        is_finite(texcoord) ? glm::clamp(texcoord, -greatest_texcoord, greatest_texcoord) : texcoord;
    if (kept != texcoord)
      note("vt beyond {}, where a 32-bit float has no fraction, clamped", greatest_texcoord);
    data_.texcoords.push_back(kept);
  }

  void normal_line(std::string_view line) {
    reserve_by(data_.normals, line.size(), 1);
    const std::span<const float> n = numbers(line, "vn", 3, 3);
    data_.normals.emplace_back(n[0], n[1], n[2]);
  }

  [[noreturn]] void fail_no_index(const char* at, const char* end, const char* list) const {
    fail(fmt::format("{} is not an index of {}", for_message(first_word(at, end)), list),
         "write corners as v, v/vt, v//vn or v/vt/vn");
  }

  /// What an index means that is outside of its list. One of v must be there, and one of vt too, but some
  /// programs write 0 for none. An index of vn may be any, since a normal can be made: some programs write it
  /// without the list, or with one too short.
  std::uint32_t outside(std::int64_t written, std::size_t count, std::string_view list) {
    if (list == "vn") note("corners whose vn is not above them in the file, with generated normals");
    if (list == "vn" || (list == "vt" && written == 0)) return no_index;
    if (written == 0) fail(fmt::format("index 0 of {}", list), "OBJ counts from 1, or backwards from -1");
    fail(fmt::format("index {} of {} is out of range: {} so far", written, list, count),
         "a face can use only lines above it");
  }

  /// The entry that an index of a corner means in a list of `count` entries; `at` stands on its first
  /// character.
  std::uint32_t take_entry(const char*& at, const char* end, std::size_t count, const char* list) {
    const char* const begin = at;
    std::int64_t written = 0;
    if (!take_integer(at, end, written)) fail_no_index(begin, end, list);
    const std::int64_t index = written == 0 ? -1 : resolve_index(written, static_cast<std::int64_t>(count));
    if (index >= 0 && index < static_cast<std::int64_t>(count)) return static_cast<std::uint32_t>(index);
    return outside(written, count, list);
  }

  /// Whether the list has something else than numbers there, which is rare.
  template <class Value>
  bool is_missing(const std::vector<Value>& list, std::uint32_t index) const {
    return first_not_finite_ > 0 && index != no_index && !is_finite(list[index]);
  }

  /// v, v/vt, v//vn or v/vt/vn; empty parts at the end are taken as not there.
  Corner take_corner(const char*& at, const char* end) {
    Corner corner;
    const auto at_index = [&] { return at != end && *at != '/' && !is_blank(*at); };
    corner.position = take_entry(at, end, data_.positions.size(), "v");
    if (at != end && *at == '/') {
      if (++at; at_index()) corner.texcoord = take_entry(at, end, data_.texcoords.size(), "vt");
      if (is_missing(data_.texcoords, corner.texcoord)) corner.texcoord = no_index;
      if (at != end && *at == '/')
        if (++at; at_index()) corner.normal = take_entry(at, end, data_.normals.size(), "vn");
    }
    if (at != end && !is_blank(*at))
      fail("a corner has more than three indices or a stray sign", "write corners as v/vt/vn");
    return corner;
  }

  void face_line(std::string_view line) {
    constexpr std::string_view repeated = "corners that repeat the one before, ignored";
    ++faces_;
    face_.clear();
    const char* at = line.data();
    const char* const end = at + line.size();
    while (skip_blanks(at, end)) {
      const Corner corner = take_corner(at, end);
      if (!face_.empty() && face_.back().position == corner.position)
        note(repeated);
      else
        face_.push_back(corner);
      if (face_.size() > max_face_corners)
        fail(fmt::format("a face of more than {} corners", max_face_corners),
             "export the model as triangles");
    }
    while (face_.size() > 1 && face_.back().position == face_.front().position) {
      face_.pop_back();
      note(repeated);
    }
    if (face_.size() < 3) return note("faces with fewer than three different corners, ignored");
    for (const Corner& corner : face_)
      if (is_missing(data_.positions, corner.position)) {
        all_faces_are_finite_ = false;
        return note("faces that use such a v, ignored");
      }
    reserve_by(data_.corners, line.size(), 3 * (face_.size() - 2));
    if (face_.size() == 3)
      return static_cast<void>(data_.corners.insert(data_.corners.end(), face_.begin(), face_.end()));
    outline_.clear();
    for (const Corner& corner : face_) outline_.push_back(data_.positions[corner.position]);
    if (!triangulate(outline_, triangles_))
      note("polygons that cross themselves, have no area or are too large, cut roughly");
    for (const Triangle& triangle : triangles_)
      for (const std::uint32_t corner : triangle) data_.corners.push_back(face_[corner]);
  }

  [[nodiscard]] std::uint32_t triangles_so_far() const {
    return static_cast<std::uint32_t>(data_.triangle_count());
  }

  void start_run(std::vector<NamedRun>& runs, std::string_view line) const {
    const std::string_view name = trimmed(line);
    if (!runs.empty() && runs.back().first_triangle == triangles_so_far())
      runs.back().name = name;  // the one before had no triangles
    else if (runs.empty() || runs.back().name != name)
      runs.push_back({std::string(name), triangles_so_far()});
  }

  /// Any number is a group; also -1 and what is too large, of which some digits are enough to tell it from
  /// others.
  void smoothing_line(std::string_view line) {
    const std::string word = lower_case(take_word(line));
    std::int64_t group = 0;
    const char* at = word.data();
    take_integer(at, at + word.size(), group);
    if (word == "on")
      group = 1;
    else if (word != "off" && at == word.data())
      note("smoothing groups (s) that are no number, taken as off; the first is {}", for_message(word));
    if (group < 0 || group > UINT32_MAX) group = 0x80000000U | static_cast<std::uint32_t>(group);
    if (data_.smoothing.empty() && group == 0) return;  // off is how it begins
    if (data_.smoothing.empty() && triangles_so_far() > 0) data_.smoothing.push_back({0, 0});
    data_.smoothing.push_back({static_cast<std::uint32_t>(group), triangles_so_far()});
  }

  void finish() {
    if (data_.corners.empty() && !all_faces_are_finite_)
      throw Error::failed("all faces use a v that is not finite or too large for a 32-bit float",
                          place(first_not_finite_),
                          "export the model again without NaN and infinity, and smaller than 1e38");
    if (data_.corners.empty())
      throw Error::failed(
          fmt::format("no face with three corners in {} lines ({} positions, {} faces, {} lines "
                      "not understood)",
                      lines_.lines_read(), data_.positions.size(), faces_, unknown_lines_),
          {name_}, "is this an OBJ file, and was it exported with its faces?");
    // A file that gives them to no corner simply has none.
    const auto tell_missing = [&](auto& list, std::uint32_t Corner::*index, const char* text) {
      const auto missing = static_cast<std::size_t>(std::ranges::count(data_.corners, no_index, index));
      if (missing == data_.corners.size()) return list.clear();
      if (missing > 0) troubles_.push_back({{}, text, missing});
    };
    tell_missing(data_.texcoords, &Corner::texcoord, "corners without vt, drawn with texture coordinate 0 0");
    tell_missing(data_.normals, &Corner::normal, "corners without vn, with generated normals");
    for (const Trouble& trouble : troubles_)
      data_.warnings.push_back(fmt::format("{} {}", trouble.count, trouble.text));
  }

  std::string_view text_;
  const std::string& name_;
  LineReader lines_;
  ObjData data_;
  std::vector<Trouble> troubles_;  // in the order in which they were met
  std::uint64_t faces_ = 0, unknown_lines_ = 0;
  bool all_faces_are_finite_ = true;
  std::uint64_t first_not_finite_ = 0;  // the line of the first number that is not; 0 for none
  std::array<float, 7> numbers_{};
  std::vector<Corner> face_;  // this and the next two are here to be allocated once
  std::vector<glm::vec3> outline_;
  std::vector<Triangle> triangles_;
};

using Path = std::filesystem::path;

bool is_file(const Path& path) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(path, ignored);
}

/// The file that the rest of a line names, in the first of the folders that has it; where it should be in the
/// first folder if none does. The folders in the name may be those of the machine that wrote it: then the
/// file itself lies in one of ours.
Path find_file(std::string_view written, std::initializer_list<Path> folders) {
  std::string name(written);
  std::replace(name.begin(), name.end(), '\\', '/');
  Path found = *folders.begin() / name;
  longest_known(name, [&](std::string_view cut) {
    for (const Path& file : {Path(cut), Path(cut).filename()})
      for (const Path& folder : folders)
        if (is_file(folder / file)) return found = folder / file, true;
    return false;
  });
  return found;
}

/// Reads one library and finds its pictures, beside it or beside the model; warns when it cannot.
void read_library(const Path& path, const Path& folder, ObjData& data) {
  try {
    for (Material& material : parse_mtl(MappedFile(path).bytes(), path.string(), data.warnings)) {
      if (!material.color_map.empty()) {
        const Path picture =
            std::filesystem::absolute(find_file(material.color_map, {path.parent_path(), folder}));
        material.color_map = is_file(picture) ? picture.string() : "";
        if (material.color_map.empty())
          data.warnings.push_back(fmt::format("material '{}' names a picture that does not exist: {}",
                                              material.name, picture.string()));
      }
      data.materials.push_back(std::move(material));
    }
  } catch (const Error& error) {
    data.warnings.push_back(fmt::format("material library not used: {}", error.what()));
  }
}

/// Cuts comments off the names of materials: where `usemtl` and `newmtl` agree without them only.
void match_names(ObjData& data) {
  std::set<std::string, std::less<>> used, defined;
  for (const NamedRun& run : data.material_runs)
    longest_known(run.name, [&](std::string_view cut) { return used.emplace(cut), false; });
  for (const Material& material : data.materials) defined.insert(material.name);
  for (Material& material : data.materials)
    material.name = std::string(longest_known(material.name, [&](std::string_view cut) {
      return used.contains(cut) && (cut == material.name || !defined.contains(cut));
    }));
  defined.clear();
  for (const Material& material : data.materials) defined.insert(material.name);
  std::set<std::string_view> unknown;
  for (NamedRun& run : data.material_runs) {
    run.name =
        std::string(longest_known(run.name, [&](std::string_view cut) { return defined.contains(cut); }));
    if (!defined.contains(run.name)) unknown.insert(run.name);
  }
  if (!unknown.empty())
    data.warnings.push_back(fmt::format("{} materials are in no library; the first by name is {}",
                                        unknown.size(), for_message(*unknown.begin())));
}

void read_libraries(const Path& folder, ObjData& data) {
  std::set<Path> read;
  for (const std::string& names : data.libraries) {
    // A line holds one name, which may have blanks in it, or several.
    std::vector<Path> files;
    std::string_view rest = names;
    for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest))
      files.push_back(find_file(word, {folder}));
    if (const Path whole = find_file(names, {folder}); is_file(whole)) files = {whole};
    for (const Path& file : files)
      if (read.insert(file).second) read_library(file, folder, data);
  }
  if (!data.materials.empty()) match_names(data);
}

}  // namespace

ObjData parse_obj(std::string_view text, const std::string& name) {
  return Parser(text, name).parse();
}

ObjData load_obj(const Path& path) {
  const MappedFile file(path);
  ObjData data = parse_obj(file.bytes(), path.string());
  read_libraries(path.parent_path(), data);
  return data;
}

}  // namespace texel::mesh
