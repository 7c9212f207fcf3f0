// SPDX-License-Identifier: MIT
// Functions of the shaders of labs 6, 8 and 9 by themselves, at the inputs at which such functions fail: run
// over tables, and compared with teach/truth in double precision and with their twins in teach/answers.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "../../labs/08_reflection/parameters.hpp"
#include "../../labs/09_bump/parameters.hpp"
#include "../support/directions.hpp"
#include "../support/oracles.hpp"
#include "../support/tolerance.hpp"
#include "answers/basis.hpp"
#include "app/lab.hpp"
#include "gl/context.hpp"
#include "gl/objects.hpp"
#include "gl/program.hpp"
#include "gl/target.hpp"
#include "gl/upload.hpp"
#include "procedural/cube_maps.hpp"
#include "truth/cube_map.hpp"
#include "truth/optics.hpp"

namespace texel::gl {
namespace {

using glm::dvec2;
using glm::dvec3;
using glm::vec3;
using glm::vec4;
using Table = std::vector<vec4>;

// The table is folded into rows of so many pixels: a single row would be wider than a texture may be.
constexpr int kWidth = 1024;

/// One column as a texture, its last row filled up with zeros.
Texture make_column(const Table& values, int height) {
  Table padded = values;
  padded.resize(static_cast<std::size_t>(kWidth) * static_cast<std::size_t>(height), vec4(0));
  Texture texture;
  const ScopedBinding binding(GL_TEXTURE_2D, texture);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, kWidth, height, 0, GL_RGBA, GL_FLOAT, padded.data());
  set_sampling(GL_TEXTURE_2D, {GL_NEAREST, GL_NEAREST});
  return texture;
}

std::string column_name(std::size_t column) {
  return std::string(1, static_cast<char>('a' + column));
}

/// One context for the file: making one takes longer than all of its tests.
class HardCase : public testing::Test {
 protected:
  static void SetUpTestSuite() { context_ = create_headless(); }
  static void TearDownTestSuite() { context_.reset(); }
  ~HardCase() override {
    for (const std::string& error : context_->take_errors()) ADD_FAILURE() << error;
  }

  /// Runs a step function in GLSL over a table of inputs and reads its values back exactly (32-bit floats).
  ///
  /// `file` below `shaders` holds the function; `expression` is a GLSL expression of type vec4 in which `a`,
  /// `b`, `c`, … (one for each column of the table, vec4 each) stand for the row's inputs:
  /// "vec4(decode_normal(a.rgb), 1.0)". All columns have the same length, which is that of the result.
  /// Functions that need derivatives (dFdx) cannot be asked so: a table has no neighbours.
  static Table values_of(const std::string& file, const std::string& expression,
                         const std::vector<Define>& defines, const std::vector<Table>& columns) {
    std::string uniforms, inputs;
    for (std::size_t i = 0; i < columns.size(); ++i) {
      uniforms += fmt::format("uniform sampler2D column_{};\n", column_name(i));
      inputs +=
          fmt::format("  vec4 {0} = texelFetch(column_{0}, ivec2(gl_FragCoord.xy), 0);\n", column_name(i));
    }
    const std::string fragment = fmt::format(
        "#version 330 core\n#include \"{}\"\nout vec4 result;\n{}void main() {{\n{}  result = {};\n}}\n",
        file, uniforms, inputs, expression);

    const auto vertex_source = std::make_shared<const ShaderSource>("shaders", "app/present.vert");
    const auto fragment_source = std::make_shared<const ShaderSource>("shaders", "probe", fragment);
    Program program(vertex_source, fragment_source, defines);
    program.use();

    const std::size_t count = columns.front().size();
    const int height = static_cast<int>((count + kWidth - 1) / kWidth);
    std::vector<Texture> textures;
    for (const Table& column : columns) textures.push_back(make_column(column, height));
    for (std::size_t i = 0; i < columns.size(); ++i) {
      bind(static_cast<int>(i), GL_TEXTURE_2D, textures[i]);
      program.set("column_" + column_name(i), static_cast<int>(i));
    }
    const Target target(Target::Kind::data, kWidth, height, 1);
    target.bind();
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    const VertexArray no_attributes;
    glBindVertexArray(no_attributes.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);

    const image::ImageF values = target.read_float();
    Table result(count);
    for (std::size_t i = 0; i < count; ++i)
      result[i] = {values.samples[4 * i], values.samples[4 * i + 1], values.samples[4 * i + 2],
                   values.samples[4 * i + 3]};
    return result;
  }

 private:
  static inline std::unique_ptr<Context> context_;
};

/// What a lab's parameters are in its shaders.
template <class Parameters>
std::vector<Define> constants(std::initializer_list<std::pair<const char*, const char*>> settings) {
  Parameters parameters;
  params::Set set;
  parameters.declare(set);
  for (const auto& [name, value] : settings) set.at(name).set(value);
  return app::constants(set, app::View::color);
}

bool is_finite(const vec4& v) {
  return std::isfinite(v.x + v.y + v.z + v.w);
}

Table column_of(const std::vector<vec3>& directions) {
  Table column;
  for (const vec3& n : directions) column.emplace_back(n, 0);
  return column;
}

// ---- Lab 9: the frames of shaders/09_bump/frame.glsl.

class HardCaseOfFrames : public HardCase {
 protected:
  static std::vector<Define> method(const std::string& name) {
    return constants<bump::BumpParameters>({{"method", name.c_str()}});
  }

  static std::vector<glm::mat3> frames(const std::string& name, const std::vector<vec3>& directions) {
    std::vector<glm::mat3> result(directions.size());
    for (int i = 0; i < 3; ++i) {
      const Table column =
          values_of("09_bump/frame.glsl", "vec4(frame_at(a.xyz)[" + std::to_string(i) + "], 1.0)",
                    method(name), {column_of(directions)});
      for (std::size_t row = 0; row < column.size(); ++row) result[row][i] = vec3(column[row]);
    }
    return result;
  }
};

TEST_F(HardCaseOfFrames, are_their_twins_in_common_math) {
  const std::vector<vec3> directions = test::hard_directions();
  answers::for_each_basis([&](const std::string& name, auto twin) {
    const std::vector<glm::mat3> shader = frames(name, directions);
    for (std::size_t i = 0; i < directions.size(); ++i) {
      const vec3 n = directions[i];
      // The smallest floats, which graphics hardware counts as 0; and the two poles of cross-up.
      if (std::hypot(double{n.x}, double{n.z}) < 1e-15 && (name == "uv-aligned" || name == "cross-up"))
        continue;
      const glm::mat3 expected = twin(n);
      for (int c = 0; c < 3; ++c)
        // Measured 0 on llvmpipe; a division or root may be a rounding or two off elsewhere.
        ASSERT_BELOW(glm::distance(shader[i][c], expected[c]), 5e-7F)
            << name << " " << n.x << " " << n.y << " " << n.z;
    }
  });
}

TEST_F(HardCaseOfFrames, bend_the_normal_to_a_finite_one_at_every_strength) {
  const std::vector<vec3> directions = test::hard_directions();
  // The map's normal at strength 0, 1 and 100: steep, flat as 8 bits have it, and the lowest blue of a map.
  Table normals, bends;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    constexpr float kStrengths[] = {0, 1, 100};
    const float strength = kStrengths[i % 3];
    const vec3 texels[] = {{-1, 0.5F, 0.1F}, {1 / 255.0F, 1 / 255.0F, 1}, {0.7F, -0.7F, 1 / 255.0F}};
    normals.emplace_back(directions[i], 0);
    bends.emplace_back(texels[i / 3 % 3] * vec3(strength, strength, 1), 0);
  }
  for (const char* name : {"uv-aligned", "blinn", "duff", "sign-corrected", "hughes-moller"}) {
    const Table bent = values_of("09_bump/frame.glsl", "vec4(bent_normal(a.xyz, b.xyz), 1.0)", method(name),
                                 {normals, bends});
    for (const vec4& n : bent) ASSERT_WITHIN(glm::length(vec3(n)), 1, 4e-7) << name;
  }
  // The worksheet's is left as long as the map's normal is: finite, and not of unit length.
  const Table bent = values_of("09_bump/frame.glsl", "vec4(bent_normal(a.xyz, b.xyz), 1.0)",
                               method("rotate-to-normal"), {normals, bends});
  EXPECT_TRUE(std::all_of(bent.begin(), bent.end(), is_finite));
}

// ---- Lab 6: the worksheet's coordinates and the cube's faces.

class HardCaseOfCoordinates : public HardCase {};

TEST_F(HardCaseOfCoordinates, two_angles_are_exact_up_to_the_poles_and_on_both_sides_of_the_seam) {
  std::vector<vec3> directions = test::hard_directions();
  for (const float z : {-1.0F, -1e-3F, -1e-20F})
    for (const float x : {-1e-6F, -1e-30F, -0.0F, 0.0F, 1e-30F, 1e-6F}) directions.emplace_back(x, 0.3F, z);
  // Lab 6's, and the one that the labs after it have.
  for (const char* file : {"06_cube_map/sphere_texcoord.glsl", "lib/sphere_coordinates.glsl"}) {
    const Table texcoords =
        values_of(file, "vec4(sphere_texcoord(a.xyz), 0.0, 1.0)", {}, {column_of(directions)});
    for (std::size_t i = 0; i < directions.size(); ++i) {
      const vec3 n = directions[i];
      const dvec2 got(texcoords[i]), expected = truth::worksheet_texcoord(n);
      ASSERT_LE(std::abs(got.x), 0.5 + 1e-7) << n.x << " " << n.y << " " << n.z;
      // llvmpipe's arc tangent is a polynomial: measured 1.2e-6 and 6e-7, a thousandth of a texel of the
      // pictures.
      ASSERT_WITHIN(got.y, expected.y, 2e-6) << n.x << " " << n.y << " " << n.z;
      // At the poles any u will do; beside the seam, -1/2 and 1/2 are the same place.
      if (std::hypot(double{n.x}, double{n.z}) < 1e-18) continue;
      ASSERT_WITHIN(std::remainder(got.x - expected.x, 1), 0, 1e-6) << n.x << " " << n.y << " " << n.z;
    }
  }
}

TEST_F(HardCaseOfCoordinates, their_derivative_has_no_seam_and_is_finite_at_the_poles) {
  const std::vector<vec3> directions = test::hard_directions();
  Table steps;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const double angle = 0.1 * static_cast<double>(i);
    steps.emplace_back(vec3(dvec3(std::cos(angle), std::sin(angle), std::cos(2 * angle))) * 0.004F, 0);
  }
  const Table gradients =
      values_of("lib/sphere_differences.glsl", "vec4(sphere_gradient(a.xyz, b.xyz), 0.0, 1.0)", {},
                {column_of(directions), steps});
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const vec3 n = directions[i];
    ASSERT_TRUE(is_finite(gradients[i])) << n.x << " " << n.y << " " << n.z;
    const double from_pole = std::hypot(double{n.x}, double{n.z});
    if (from_pole < 1e-5) continue;  // a large one is near enough
    const dvec2 expected = truth::worksheet_gradient(n, {dvec3(steps[i]), dvec3(0)}).dx;
    // du is a difference of two products of up to |n_xz| |step|, divided by |n_xz|^2: a few roundings of
    // that.
    ASSERT_WITHIN(gradients[i].x, expected.x, 3e-7 * 0.004 / from_pole) << n.x << " " << n.y << " " << n.z;
    ASSERT_WITHIN(gradients[i].y, expected.y, 3e-7 * 0.004) << n.x << " " << n.y << " " << n.z;
  }
}

TEST_F(HardCaseOfCoordinates, a_direction_on_an_edge_or_corner_of_the_cube_has_one_face_and_its_border) {
  // All ties: the middles of the faces, the edges and the corners of the cube, at several lengths.
  std::vector<vec3> directions = test::hard_directions();
  for (const float length : {1e-15F, 0.3F, 1.0F, 1e15F})
    for (int x = -1; x <= 1; ++x)
      for (int y = -1; y <= 1; ++y)
        for (int z = -1; z <= 1; ++z)
          if (x != 0 || y != 0 || z != 0) directions.push_back(length * vec3(x, y, z));
  const Table values = values_of("lib/cube_coordinates.glsl", "vec4(cube_texcoord(a.xyz), 0.0, 1.0)", {},
                                 {column_of(directions)});
  const Table majors = values_of("lib/cube_coordinates.glsl", "vec4(cube_face_axes(a.xyz)[2], 1.0)", {},
                                 {column_of(directions)});
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const vec3 n = directions[i];
    // On a tie x goes before y and y before z, as in image/cube_faces.hpp.
    const image::FaceCoordinate expected = image::face_coordinate(n);
    ASSERT_EQ(dvec3(majors[i]), procedural::direction(expected.face, 0.5, 0.5))
        << n.x << " " << n.y << " " << n.z;
    // Two roundings. Measured 4.5e-8.
    ASSERT_WITHIN(values[i].x, expected.s, 1.2e-7) << n.x << " " << n.y << " " << n.z;
    ASSERT_WITHIN(values[i].y, expected.t, 1.2e-7) << n.x << " " << n.y << " " << n.z;
    ASSERT_LE(std::max(std::abs(values[i].x - 0.5F), std::abs(values[i].y - 0.5F)), 0.5F);
  }
}

// ---- Lab 8: the rays at a surface with the normal +z, in the plane of x and z.

class HardCaseOfRays : public HardCase {
 protected:
  static std::vector<Define> surface(const char* name) {
    return constants<reflection::ReflectionParameters>({{"surface", name}});
  }

  struct Cases {
    Table incidents;  ///< unit, towards the surface; w: cosine of the angle of incidence
    Table etas;       ///< x: index here divided by that beyond
  };

  /// From straight on to grazing, at and around Brewster's and the critical angle, for each ratio of indices.
  static Cases cases() {
    Cases result;
    for (const double eta : {1 / 3.0, 1 / 1.5, 1 / 1.33, 1.0, 1.33, 1.5, 2.5, 3.0}) {
      std::vector<double> angles = {
          0, 1e-7, 1e-4, 0.1, 0.5, 1, 1.4, 1.57, 0.5 * std::numbers::pi - 1e-4, 0.5 * std::numbers::pi};
      std::vector<double> around = {std::atan(1 / eta)};
      if (eta > 1) around.push_back(std::asin(1 / eta));
      for (const double angle : around)
        for (const double off : {-1e-2, -1e-3, -1e-5, 0.0, 1e-5, 1e-3, 1e-2}) angles.push_back(angle + off);
      for (const double angle : angles) {
        // At exactly a right angle the float cosine would be 6e-17.
        const double cosine = angle == 0.5 * std::numbers::pi ? 0 : std::cos(angle);
        result.incidents.emplace_back(dvec3(std::sin(angle), 0, -cosine), cosine);
        result.etas.emplace_back(eta, 0, 0, 0);
      }
    }
    return result;
  }
};

TEST_F(HardCaseOfRays, refraction_follows_snell_s_law_to_the_critical_angle_and_grazing) {
  const auto [incidents, etas] = cases();
  const Table refracted =
      values_of("08_reflection/rays.glsl", "vec4(refracted_ray(a.xyz, vec3(0, 0, 1), b.x), 1.0)",
                surface("refraction"), {incidents, etas});
  int total_reflections = 0;
  for (std::size_t i = 0; i < refracted.size(); ++i) {
    const double eta = etas[i].x;
    const vec3 incident(incidents[i]);
    SCOPED_TRACE(testing::Message() << "eta " << eta << " cosine " << incidents[i].w);
    ASSERT_TRUE(is_finite(refracted[i]));
    const double along = eta * incident.x;  // Snell: sin t = eta sin i
    const double cos_t_squared = 1 - along * along;
    // The shader's square of the cosine is off by a few roundings, and its root by more the smaller it is.
    const double rounding = 4e-7 * std::max(1.0, eta * eta);
    if (refracted[i] == vec4(0, 0, 0, 1)) {
      EXPECT_LT(cos_t_squared, rounding);
      ++total_reflections;
      continue;
    }
    EXPECT_GT(cos_t_squared, -rounding);
    EXPECT_WITHIN(refracted[i].x, along, 3e-7);
    const double cos_t = std::sqrt(std::max(cos_t_squared, 0.0));
    EXPECT_WITHIN(refracted[i].z, -cos_t,
                  std::min(rounding / std::max(cos_t, 1e-9), std::sqrt(rounding)) + 1e-7);
    EXPECT_EQ(refracted[i].y, 0.0F);
  }
  EXPECT_GT(total_reflections, 30);
}

TEST_F(HardCaseOfRays, fresnel_is_right_straight_on_at_brewster_s_angle_at_the_critical_one_and_grazing) {
  const auto [incidents, etas] = cases();
  const Table reflected = values_of("08_reflection/fresnel.glsl", "vec4(fresnel(a.w, b.x))",
                                    surface("fresnel"), {incidents, etas});
  for (std::size_t i = 0; i < reflected.size(); ++i) {
    const double eta = etas[i].x, cosine = incidents[i].w;
    SCOPED_TRACE(testing::Message() << "eta " << eta << " cosine " << cosine);
    // Where total reflection begins the value rises to 1 like a square root: a rounding of 1e-7 counts 0.002.
    const double cos_t_squared = 1 - eta * eta * (1 - cosine * cosine);
    const double tolerance = 1e-6 + 1e-6 * eta * eta / std::sqrt(std::max(cos_t_squared, 2e-7));
    ASSERT_WITHIN(reflected[i].x, test::fresnel(cosine, eta, 1), tolerance);
    if (cosine == 1) {
      EXPECT_WITHIN(reflected[i].x, std::pow((eta - 1) / (eta + 1), 2), 1e-7);
    }
    if (cosine == 0) {
      EXPECT_EQ(reflected[i].x, 1.0F);
    }
  }
  // At Brewster's angle, tan i = 1 / eta, only half of the light is reflected at all: that across the plane.
  const double eta = 1 / 1.5, brewster = std::atan(1 / eta), across = std::cos(2 * brewster);
  const Table value = values_of("08_reflection/fresnel.glsl", "vec4(fresnel(a.w, b.x))", surface("fresnel"),
                                {{vec4(0, 0, 0, std::cos(brewster))}, {vec4(static_cast<float>(eta))}});
  EXPECT_WITHIN(value[0].x, 0.5 * across * across, 1e-7);
}

TEST_F(HardCaseOfRays, schlick_s_reflectance_is_finite_and_at_most_so_far_from_fresnel_s) {
  Cases c = cases();
  // A unit vector's dot product with itself may be a rounding above 1; its fifth power must not be of less
  // than 0.
  c.incidents.emplace_back(0, 0, -1, 1.0000002F);
  c.etas.emplace_back(1 / 1.5F);
  const Table reflected = values_of("08_reflection/fresnel.glsl", "vec4(fresnel(a.w, b.x))",
                                    surface("schlick"), {c.incidents, c.etas});
  double worst = 0;
  for (std::size_t i = 0; i < reflected.size(); ++i) {
    const double eta = c.etas[i].x, cosine = c.incidents[i].w;
    ASSERT_TRUE(reflected[i].x >= 0 && reflected[i].x <= 1) << eta << " " << cosine;
    if (std::abs(eta - 1 / 1.5) < 1e-6)
      worst = std::max(worst, std::abs(reflected[i].x - test::fresnel(std::min(cosine, 1.0), eta, 1)));
  }
  // Glass from outside: 0.023 at most here, at 80 degrees. Between equal media it reflects near grazing,
  // (1 - cos)^5, where nothing should be.
  EXPECT_ABOVE(worst, 0.015);
  EXPECT_BELOW(worst, 0.03);
}

}  // namespace
}  // namespace texel::gl
