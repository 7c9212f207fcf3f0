// SPDX-License-Identifier: MIT
#include "mesh/obj.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <span>
#include <unordered_set>

#include "core/error.hpp"
#include "core/files.hpp"
#include "mesh/polygon.hpp"
#include "text.hpp"

namespace texel::mesh {
namespace {

/// Beyond it float32 has no fractions: a texture coordinate there tells nothing of a place in the picture,
/// and differences of larger ones could overflow.
constexpr float greatest_texcoord = 16777216.0f;

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

class Parser {
 public:
  Parser(std::string_view text, const std::string& name, const ObjOptions& options)
      : text_(text), options_(options), lines_(text) {
    data_.name = name;
  }

  ObjData parse() {
    if (text_.empty()) throw Error::failed("the file is empty", {data_.name}, "choose an OBJ file");
    const std::size_t step = std::max<std::size_t>(text_.size() / 100, 1u << 20);
    std::size_t next_report = step;
    std::string_view line;
    while (lines_.next(line)) {
      parse_line(line);
      if (lines_.bytes_read() < next_report) continue;
      next_report += step;
      if (options_.progress)
        options_.progress(static_cast<double>(lines_.bytes_read()) / static_cast<double>(text_.size()));
    }
    finish();
    return std::move(data_);
  }

 private:
  [[nodiscard]] Place place(std::uint64_t line) const {
    return {data_.name, static_cast<int>(std::min<std::uint64_t>(line, INT32_MAX))};
  }

  [[noreturn]] void fail(const std::string& what, const std::string& remedy) const {
    throw Error::failed(what, place(lines_.line_number()), remedy);
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
    if (keyword == "mtllib") return static_cast<void>(data_.libraries.emplace_back(rest_of_line(line)));
    if (keyword == "p" || keyword == "l") return static_cast<void>(++data_.report.points_and_lines);
    if (whole.find('\0') != std::string_view::npos)
      fail("this is binary data, not text", "export the model as Wavefront OBJ in ASCII or UTF-8");
    if (data_.report.unknown_lines++ == 0) first_unknown_ = for_message(keyword);
  }

  [[noreturn]] void fail_no_number(std::string_view word) const {
    fail(for_message(word) + " is not a number", "write numbers as 1.5 or -2e-3");
  }

  /// The numbers on the rest of a line, of which there must be `least` to `most`.
  std::span<const float> numbers(std::string_view line, const char* keyword, std::size_t least,
                                 std::size_t most) {
    std::size_t count = 0;
    const char* at = line.data();
    const char* const end = at + line.size();
    finite_ = most;
    for (; skip_blanks(at, end); ++count) {
      if (count == most) fail(fmt::format("{} has more than {} numbers", keyword, most), "remove the rest");
      if (take_plain_number(at, end, numbers_[count])) continue;
      const std::string_view word(at, static_cast<std::size_t>(std::find_if(at, end, is_blank) - at));
      at += word.size();
      switch (parse_float(word, numbers_[count])) {
        case NumberStatus::ok:
          break;
        case NumberStatus::malformed:
          fail_no_number(word);
        case NumberStatus::repaired:
          // A comma alone on its line may part two numbers.
          if (count == 0 && word.find(',') != std::string_view::npos && !skip_blanks(at, end))
            fail_no_number(word);
          if (data_.report.repaired_numbers++ == 0)
            first_repaired_ = fmt::format("{}, read as {}", for_message(word), numbers_[count]);
          break;
        case NumberStatus::not_finite:
          numbers_[count] = 0.0f;
          finite_ = std::min(finite_, count);
      }
    }
    if (count < least)
      fail(fmt::format("{} has {} numbers and needs {}", keyword, count, least), "is the file cut off here?");
    if (finite_ < most && data_.report.not_finite_lines++ == 0) first_not_finite_ = lines_.line_number();
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
    if (data_.positions.size() >= no_index - 1) fail("more than 4294967294 positions", "split the model");
    data_.positions.push_back(position_from(n));
    if (finite_ < 3) not_finite_positions_.push_back(static_cast<std::uint32_t>(data_.positions.size() - 1));
    if ((n.size() == 4 || n.size() == 7) && n[3] != 1.0f) ++data_.report.ignored_weights;
    if (n.size() >= 6) {
      data_.colors.resize(data_.positions.size() - 1, glm::vec3(1.0f));
      data_.colors.emplace_back(n[n.size() - 3], n[n.size() - 2], n[n.size() - 1]);
      if (finite_ < n.size()) data_.colors.back() = glm::vec3(1.0f);
    }
  }

  void texcoord_line(std::string_view line) {
    reserve_by(data_.texcoords, line.size(), 1);
    const glm::vec2 texcoord = texcoord_from(numbers(line, "vt", 1, 3));
    const glm::vec2 kept = glm::clamp(texcoord, -greatest_texcoord, greatest_texcoord);
    if (kept != texcoord) ++data_.report.great_texcoords;
    data_.texcoords.push_back(kept);
    if (finite_ < 2) not_finite_texcoords_.push_back(static_cast<std::uint32_t>(data_.texcoords.size() - 1));
  }

  void normal_line(std::string_view line) {
    reserve_by(data_.normals, line.size(), 1);
    const std::span<const float> n = numbers(line, "vn", 3, 3);
    // Without a direction: a generated one takes its place.
    data_.normals.push_back(finite_ < 3 ? glm::vec3(0.0f) : glm::vec3(n[0], n[1], n[2]));
  }

  static bool is_in(const std::vector<std::uint32_t>& list, std::uint32_t index) {
    return !list.empty() && std::binary_search(list.begin(), list.end(), index);
  }

  [[noreturn]] void fail_no_index(const char* at, const char* end, const char* list) const {
    const char* word_end = std::find_if(at, end, is_blank);
    fail(fmt::format("{} is not an index of {}", for_message({at, static_cast<std::size_t>(word_end - at)}),
                     list),
         "write corners as v, v/vt, v//vn or v/vt/vn");
  }

  [[noreturn]] void fail_index(std::int64_t written, std::size_t count, const char* list) const {
    if (written == 0) fail(fmt::format("index 0 of {}", list), "OBJ counts from 1, or backwards from -1");
    fail(fmt::format("index {} of {} is out of range: {} so far", written, list, count),
         "a face can use only lines above it");
  }

  /// One index of a corner as it is meant in a list of `count` entries, inside of it or not (as 0 never is);
  /// `at` stands on its first character.
  std::int64_t take_index(const char*& at, const char* end, std::size_t count, const char* list,
                          std::int64_t& written) const {
    const char* const begin = at;
    if (!take_integer(at, end, written)) fail_no_index(begin, end, list);
    return written == 0 ? -1 : resolve_index(written, static_cast<std::int64_t>(count));
  }

  /// An index of v or vt, which must be there. As index of vt some programs write 0 for none.
  std::uint32_t take_entry(const char*& at, const char* end, std::size_t count, const char* list,
                           bool may_be_none) const {
    std::int64_t written = 0;
    const std::int64_t index = take_index(at, end, count, list, written);
    if (may_be_none && written == 0) return no_index;
    if (index < 0 || index >= static_cast<std::int64_t>(count)) fail_index(written, count, list);
    return static_cast<std::uint32_t>(index);
  }

  /// An index of vn. Some programs write it without the list, or with one that is too short, or as 0, since a
  /// normal can be made: no_index then.
  std::uint32_t take_normal(const char*& at, const char* end) {
    std::int64_t written = 0;
    const auto count = static_cast<std::int64_t>(data_.normals.size());
    const std::int64_t index = take_index(at, end, data_.normals.size(), "vn", written);
    if (index >= 0 && index < count) return static_cast<std::uint32_t>(index);
    ++data_.report.lost_normals;
    return no_index;
  }

  /// v, v/vt, v//vn or v/vt/vn; empty parts at the end are taken as not there.
  Corner take_corner(const char*& at, const char* end) {
    Corner corner;
    const auto at_index = [&] { return at != end && *at != '/' && !is_blank(*at); };
    corner.position = take_entry(at, end, data_.positions.size(), "v", false);
    if (at != end && *at == '/') {
      if (++at; at_index()) corner.texcoord = take_entry(at, end, data_.texcoords.size(), "vt", true);
      if (is_in(not_finite_texcoords_, corner.texcoord)) corner.texcoord = no_index;
      if (at != end && *at == '/')
        if (++at; at_index()) corner.normal = take_normal(at, end);
    }
    if (at != end && !is_blank(*at))
      fail("a corner has more than three indices or a stray sign", "write corners as v/vt/vn");
    return corner;
  }

  void face_line(std::string_view line) {
    ++data_.report.faces;
    face_.clear();
    const char* at = line.data();
    const char* const end = at + line.size();
    while (skip_blanks(at, end)) {
      const Corner corner = take_corner(at, end);
      if (!face_.empty() && face_.back().position == corner.position)
        ++data_.report.dropped_corners;
      else
        face_.push_back(corner);
      if (face_.size() > max_face_corners)
        fail(fmt::format("a face of more than {} corners", max_face_corners),
             "export the model as triangles");
    }
    while (face_.size() > 1 && face_.back().position == face_.front().position) {
      face_.pop_back();
      ++data_.report.dropped_corners;
    }
    if (face_.size() < 3) return static_cast<void>(++data_.report.dropped_faces);
    for (const Corner& corner : face_)
      if (is_in(not_finite_positions_, corner.position))
        return static_cast<void>(++data_.report.not_finite_faces);
    reserve_by(data_.corners, line.size(), 3 * (face_.size() - 2));
    if (data_.corners.size() + 3 * face_.size() >= no_index)
      fail("more than 4294967294 corners", "split the model");
    if (face_.size() == 3)
      data_.corners.insert(data_.corners.end(), face_.begin(), face_.end());
    else
      polygon();
  }

  void polygon() {
    ++data_.report.polygons;
    outline_.clear();
    for (const Corner& corner : face_) outline_.push_back(data_.positions[corner.position]);
    switch (triangulate(outline_, triangles_)) {
      case Cut::fan:
        break;
      case Cut::ears:
        ++data_.report.concave_polygons;
        break;
      case Cut::approximate:
        ++data_.report.approximate_polygons;
        break;
    }
    for (const Triangle& triangle : triangles_)
      for (const std::uint32_t corner : triangle) data_.corners.push_back(face_[corner]);
  }

  [[nodiscard]] std::uint32_t triangles_so_far() const {
    return static_cast<std::uint32_t>(data_.triangle_count());
  }

  void start_run(std::vector<NamedRun>& runs, std::string_view line) const {
    const std::string_view name = rest_of_line(line);
    if (!runs.empty() && runs.back().first_triangle == triangles_so_far())
      runs.back().name = name;  // the one before had no triangles
    else if (runs.empty() || runs.back().name != name)
      runs.push_back({std::string(name), triangles_so_far()});
  }

  /// Any number is a group; also -1 and what is too large, of which some digits are enough to tell it from
  /// others.
  void smoothing_line(std::string_view line) {
    const std::string word = lower(take_word(line));
    std::int64_t group = 0;
    const char* at = word.data();
    take_integer(at, at + word.size(), group);
    if (word == "on")
      group = 1;
    else if (word != "off" && at == word.data() && data_.report.unknown_smoothing++ == 0)
      first_smoothing_ = for_message(word);
    if (group < 0 || group > UINT32_MAX) group = 0x80000000u | static_cast<std::uint32_t>(group);
    if (data_.smoothing.empty() && group == 0) return;  // off is how it begins
    if (data_.smoothing.empty() && triangles_so_far() > 0) data_.smoothing.push_back({0, 0});
    data_.smoothing.push_back({static_cast<std::uint32_t>(group), triangles_so_far()});
  }

  void finish() {
    ObjReport& report = data_.report;
    report.lines = lines_.lines_read();
    if (data_.corners.empty() && report.not_finite_faces > 0)
      throw Error::failed("all faces use a v that is not finite or too large for a 32-bit float",
                          place(first_not_finite_),
                          "export the model again without NaN and infinity, and smaller than 1e38");
    if (data_.corners.empty())
      throw Error::failed(
          fmt::format("no face with three corners in {} lines ({} positions, {} faces, {} lines "
                      "not understood)",
                      report.lines, data_.positions.size(), report.faces, report.unknown_lines),
          {data_.name}, "is this an OBJ file, and was it exported with its faces?");
    if (!data_.colors.empty()) data_.colors.resize(data_.positions.size(), glm::vec3(1.0f));
    for (const Corner& corner : data_.corners) {
      if (corner.texcoord == no_index) ++report.missing_texcoords;
      if (corner.normal == no_index) ++report.missing_normals;
    }
    // A file that gives them to no corner simply has none.
    if (report.missing_texcoords == data_.corners.size())
      report.missing_texcoords = 0, data_.texcoords.clear();
    if (report.missing_normals == data_.corners.size()) report.missing_normals = 0, data_.normals.clear();
    const auto warn = [&report](std::uint64_t count, const std::string& text) {
      if (count > 0) report.warnings.push_back(fmt::format("{} {}", count, text));
    };
    warn(report.dropped_faces, "faces with fewer than three different corners, ignored");
    warn(report.dropped_corners, "corners that repeat the one before, ignored");
    warn(report.approximate_polygons,
         "polygons that cross themselves, have no area or are too large, cut roughly");
    warn(report.points_and_lines, "points and lines ignored");
    warn(report.ignored_weights, "weights (the fourth number of v) ignored");
    warn(report.missing_texcoords, "corners without vt, drawn with texture coordinate 0 0");
    warn(report.lost_normals, "corners whose vn is not above them in the file, with generated normals");
    warn(
        report.not_finite_lines,
        fmt::format("lines of v, vt and vn with NaN, infinity or more than a 32-bit float can hold, taken as "
                    "missing; the first is line {}",
                    first_not_finite_));
    warn(report.not_finite_faces, "faces that use such a v, ignored");
    warn(report.great_texcoords,
         fmt::format("vt beyond {}, where a 32-bit float has no fraction, clamped", greatest_texcoord));
    warn(report.repaired_numbers, "numbers in an unusual spelling; the first is " + first_repaired_);
    warn(report.missing_normals, "corners without vn, with generated normals");
    warn(report.unknown_smoothing,
         "smoothing groups (s) that are no number, taken as off; the first is " + first_smoothing_);
    warn(report.unknown_lines, "lines with an unknown keyword, ignored; the first is " + first_unknown_);
  }

  std::string_view text_;
  const ObjOptions& options_;
  LineReader lines_;
  ObjData data_;
  std::string first_unknown_, first_repaired_, first_smoothing_;
  std::size_t finite_ = 0;  // how many of the last line's numbers are finite before the first that is not
  std::uint64_t first_not_finite_ = 0;                                      // its line
  std::vector<std::uint32_t> not_finite_positions_, not_finite_texcoords_;  // indices, in ascending order
  std::array<float, 7> numbers_{};
  std::vector<Corner> face_;  // this and the next two are here to be allocated once
  std::vector<glm::vec3> outline_;
  std::vector<Triangle> triangles_;
};

using Path = std::filesystem::path;

/// The file that the rest of a line names, in the first of the folders that has it; "" if none does. The
/// folders in the name may be those of the machine that wrote it: then the file itself lies in one of ours.
Path find_file(std::string_view written, std::initializer_list<Path> folders) {
  std::string name(written);
  std::replace(name.begin(), name.end(), '\\', '/');
  Path found;
  longest_known(name, [&](std::string_view cut) {
    for (const Path& file : {Path(cut), Path(cut).filename()})
      for (const Path& folder : folders) {
        std::error_code ignored;
        found = folder / file;
        if (std::filesystem::is_regular_file(found, ignored)) return true;
      }
    found.clear();
    return false;
  });
  return found;
}

/// Reads one library and finds its pictures, beside it or beside the model; warns when it cannot.
void read_library(const Path& path, const Path& folder, ObjData& data) {
  std::vector<std::string>& warnings = data.report.warnings;
  try {
    for (Material& material : parse_mtl(MappedFile(path).bytes(), path.string(), warnings)) {
      if (!material.color_map.empty()) {
        const Path beside = path.parent_path(), picture = find_file(material.color_map, {beside, folder});
        if (picture.empty())
          warnings.push_back(fmt::format("material '{}' names a picture that does not exist: {}",
                                         material.name,
                                         std::filesystem::absolute(beside / material.color_map).string()));
        material.color_map = picture.empty() ? "" : std::filesystem::absolute(picture).string();
      }
      data.materials.push_back(std::move(material));
    }
  } catch (const Error& error) {
    warnings.push_back(fmt::format("material library not used: {}", error.what()));
  }
}

/// Cuts comments off the names of materials: where `usemtl` and `newmtl` agree without them only.
void match_names(ObjData& data) {
  std::unordered_set<std::string> used, defined;
  for (const NamedRun& run : data.material_runs)
    longest_known(run.name, [&](std::string_view cut) { return used.emplace(cut), false; });
  for (const Material& material : data.materials) defined.insert(material.name);
  for (Material& material : data.materials)
    material.name = std::string(longest_known(material.name, [&](std::string_view cut) {
      const std::string name(cut);
      return used.contains(name) && (name == material.name || !defined.contains(name));
    }));
  defined.clear();
  for (const Material& material : data.materials) defined.insert(material.name);
  std::set<std::string_view> unknown;
  for (NamedRun& run : data.material_runs) {
    run.name = std::string(
        longest_known(run.name, [&](std::string_view cut) { return defined.contains(std::string(cut)); }));
    if (!defined.contains(run.name)) unknown.insert(run.name);
  }
  if (!unknown.empty())
    data.report.warnings.push_back(fmt::format("{} materials are in no library; the first by name is {}",
                                               unknown.size(), for_message(*unknown.begin())));
}

void read_libraries(const Path& folder, ObjData& data) {
  std::set<Path> read;
  for (const std::string& names : data.libraries) {
    // A line may hold several names, or one with blanks in it.
    std::vector<Path> files;
    std::size_t missing = 0;
    std::string_view rest = names;
    for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest)) {
      files.push_back(find_file(word, {folder}));
      if (!files.back().empty()) continue;
      files.back() = folder / word;
      ++missing;
    }
    const Path whole = missing > 0 ? find_file(names, {folder}) : Path();
    if (!whole.empty())
      files = {whole};
    else if (missing == files.size())
      files = {folder / names};
    for (const Path& file : files)
      if (read.insert(file).second) read_library(file, folder, data);
  }
  if (!data.materials.empty()) match_names(data);
}

}  // namespace

ObjData parse_obj(std::string_view text, const std::string& name, const ObjOptions& options) {
  return Parser(text, name, options).parse();
}

ObjData load_obj(const std::filesystem::path& path, const ObjOptions& options) {
  const MappedFile file(path);
  ObjData data = parse_obj(file.bytes(), path.string(), options);
  read_libraries(path.parent_path(), data);
  return data;
}

}  // namespace texel::mesh
