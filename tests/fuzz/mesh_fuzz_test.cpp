// SPDX-License-Identifier: MIT
// Changes small files at random (always the same changes) and expects of each either a usable mesh or one
// Error. Of vertex streams too: the grader reads what students' programs write.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

#include "../support/spoilt.hpp"
#include "core/error.hpp"
#include "mesh/distinct.hpp"
#include "mesh/normals.hpp"
#include "mesh/obj.hpp"
#include "mesh/ply.hpp"
#include "mesh/primitives.hpp"
#include "mesh/tangents.hpp"
#include "mesh/texcoords.hpp"
#include "mesh/weld.hpp"

namespace texel::mesh {
namespace {

/// What parsers stumble over.
std::vector<std::string> stumbling_blocks() {
  std::istringstream all(
      "0|-1|1e308|nan|-inf|99999999999999999999|/|//|\\\n|\r|\n|#|f |v |vt |vn |s 1\n|usemtl x\n|+|-|.|e|"
      " |1e30|1,5|\xEF\xBB\xBF|f 1 2 3 4 5 6 7\n|f -1 -2 -3 -4\n|newmtl y\n|map_Kd -s |\xFF|1e-400|"
      "f 1 2\\\n|1.5D+2|1.#QNAN|s null\n|\\ \n|v inf 0 0\n|vn nan 0 0\n|f 1//9 2//9 3//9\n");
  std::vector<std::string> pieces = {std::string(1, '\0'), "0." + std::string(400, '0') + "1"};
  for (std::string piece; std::getline(all, piece, '|');) pieces.push_back(piece);
  return pieces;
}

/// The text of a seed with one to six changes: a byte, a cut, a copied piece, or a stumbling block.
std::string mutate(std::string text, std::uint64_t seed) {
  test::Random random(seed);
  static const std::vector<std::string> pieces = stumbling_blocks();
  for (std::size_t changes = 1 + random.below(6); changes > 0; --changes) {
    const std::size_t at = random.below(text.size() + 1);
    const std::size_t length = std::min(random.below(12), text.size() - at);
    switch (random.below(5)) {
      case 0:
        if (at < text.size()) text[at] = static_cast<char>(random.below(256));
        break;
      case 1:
        text.erase(at, length);
        break;
      case 2:
        text.insert(at, text.substr(random.below(text.size() + 1), random.below(40)));
        break;
      case 3:
        text.insert(at, pieces[random.below(pieces.size())]);
        break;
      default:
        if (random.below(8) == 0) text.resize(at);
    }
  }
  return text;
}

const std::string obj =
    "# a model\nmtllib a.mtl\no body\nv 0 0 0\nv 1.5 0 0\nv 1 1e0 0\nv 0 1 0.25\nv 0.5 0.2 .1 1 0.5 0\n"
    "vt 0 0\nvt 1 0 0\nvt 1 1\nvn 0 0 1\nvn 0.6 0 0.8\nusemtl red\ns 1\nf 1/1/1 2/2/1 3/3/2\n"
    "f -5 -4 \\\n -3 -2\ng tail\ns off\nf 1//1 2//2 3//1 4//2 5//1\nf 1/1 3/2 4/3\nl 1 2\np 3\n";

const std::string mtl =
    "newmtl red\nKd 1 0.5 0\nmap_Kd -s 2 2 2 -clamp on brick wall.png\nnewmtl b\nmap_Bump -bm 1 b.png\nnorm "
    "n.png\n";

void expect_whole(const Mesh& mesh) {
  for (const std::uint32_t index : mesh.indices) ASSERT_LT(index, mesh.vertex_count());
  for_each_attribute(mesh, [&](const auto& values) {
    ASSERT_TRUE(values.empty() || values.size() == mesh.vertex_count());
    for (const auto& value : values)
      for (int k = 0; k < value.length(); ++k) ASSERT_TRUE(std::isfinite(value[k]));
  });
  std::size_t grouped = 0;
  for (const Group& group : mesh.groups) grouped += group.index_count;
  ASSERT_TRUE(mesh.groups.empty() || grouped == mesh.indices.size());
}

TEST(Fuzz, obj_gives_a_usable_mesh_or_one_error) {
  int parsed = 0, refused = 0;
  for (std::uint64_t seed = 0; seed < 6000; ++seed) {
    const std::string text = mutate(obj, seed);
    try {
      ObjData data = parse_obj(text, "fuzz.obj");
      if (seed % 3 == 0) remove_normals(data);
      Mesh mesh = weld(std::move(data));
      if (mesh.normals.empty()) smooth_normals(mesh, seed % 2 == 0 ? Weighting::area : Weighting::angle);
      generate_texcoords(mesh, static_cast<Projection>(seed % 4));
      compute_tangents(mesh, static_cast<TangentMethod>(seed / 4 % 4));
      expect_whole(mesh);
      ++parsed;
    } catch (const Error& error) {
      EXPECT_EQ(error.exit_code(), Exit::failed);
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << "one line";
      ++refused;
    }
  }
  // Both ways are taken often, or the changes test nothing.
  EXPECT_GT(parsed, 500);
  EXPECT_GT(refused, 1000);
}

TEST(Fuzz, mtl_gives_materials_whatever_its_lines_are) {
  for (std::uint64_t seed = 0; seed < 6000; ++seed) {
    std::vector<std::string> warnings;
    for (const Material& material : parse_mtl(mutate(mtl, seed), "fuzz.mtl", warnings))
      for (int k = 0; k < 3; ++k) EXPECT_TRUE(std::isfinite(material.diffuse[k]));
    EXPECT_LE(warnings.size(), 2U);
  }
}

TEST(PlyFuzz, gives_a_sound_mesh_or_an_error_when_bytes_are_spoilt) {
  Mesh mesh = torus(0.7F, 0.3F, 6, 4);
  mesh.tangents.assign(mesh.vertex_count(), {1, 0, 0, 1});
  const std::string with_tangents = to_ply(mesh);
  mesh.tangents.clear();
  const std::string seeds[] = {with_tangents, to_ply(mesh), to_ply({})};
  int meshes = 0, errors = 0;
  for (std::uint64_t i = 0; i < 20'000; ++i) {
    test::Random random(i);
    SCOPED_TRACE(i);
    try {
      const Mesh read = parse_ply(test::mutated(seeds[i % 3], random), "spoilt");
      ++meshes;
      expect_whole(read);
    } catch (const Error& error) {
      ++errors;
      ASSERT_EQ(error.exit_code(), Exit::failed);
      ASSERT_NE(std::string(error.what()).find("spoilt"), std::string::npos) << error.what();
    }
  }
  // Most changes of a number leave a sound file; most others none.
  EXPECT_GT(meshes, 1000);
  EXPECT_GT(errors, 1000);
}

}  // namespace
}  // namespace texel::mesh
