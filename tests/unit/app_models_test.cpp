// SPDX-License-Identifier: MIT
#include "app/models.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <string>

#include "../support/picture_files.hpp"
#include "app/assets.hpp"
#include "core/error.hpp"
#include "mesh/ply.hpp"

namespace texel::app {
namespace {

/// Equal to the last bit: no rounding is forgiven.
template <class Value>
bool is_same(const std::vector<Value>& a, const std::vector<Value>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Value)) == 0;
}

TEST(Models, that_are_bundled_are_what_the_reader_makes_of_their_obj_files) {
  const Assets assets;
  for (const char* name : {"ship", "gator"}) {
    SCOPED_TRACE(std::string("write it again: ./run lab 5 assets/models/") + name +
                 ".obj --method raw --mesh assets/models/" + name + ".ply");
    const Model bundled = load_model(assets, name), read = load_model(assets, assets.model(name).string());
    EXPECT_EQ(assets.mesh(name).extension(), ".ply");
    EXPECT_GT(bundled.mesh.triangle_count(), 10'000U);
    EXPECT_TRUE(is_same(bundled.mesh.positions, read.mesh.positions));
    EXPECT_TRUE(is_same(bundled.mesh.normals, read.mesh.normals));
    EXPECT_TRUE(is_same(bundled.mesh.texcoords, read.mesh.texcoords));
    EXPECT_TRUE(is_same(bundled.mesh.indices, read.mesh.indices));
    EXPECT_TRUE(read.notes.facts.empty() && read.notes.warnings.empty())
        << "nothing is said that would be lost";
  }
}

TEST(Models, from_a_ply_file_need_normals_and_texture_coordinates) {
  const test::TemporaryFolder folder;
  mesh::Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.indices = {0, 1, 2};
  const std::string file = (folder / "bare.ply").string();
  write_file(file, mesh::to_ply(mesh));
  EXPECT_THROW(load_model(Assets(), file), Error);
  mesh.normals.assign(3, {0, 0, 1});
  mesh.texcoords.assign(3, {0, 0});
  write_file(file, mesh::to_ply(mesh));
  EXPECT_TRUE(is_same(load_model(Assets(), file).mesh.positions, mesh.positions)) << "as it is";
}

}  // namespace
}  // namespace texel::app
