// SPDX-License-Identifier: MIT
// Thousands of spoilt vertex streams: a mesh whose indices are sound, or one Error. The grader reads what
// students' programs write.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "../support/spoilt.hpp"
#include "core/error.hpp"
#include "mesh/ply.hpp"
#include "mesh/primitives.hpp"

namespace texel::mesh {
namespace {

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
      for (const std::uint32_t index : read.indices) ASSERT_LT(index, read.vertex_count());
      for_each_attribute(read, [&](const auto& values) {
        ASSERT_TRUE(values.empty() || values.size() == read.vertex_count());
        for (const auto& value : values)
          for (int k = 0; k < value.length(); ++k) ASSERT_TRUE(std::isfinite(value[k]));
      });
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
