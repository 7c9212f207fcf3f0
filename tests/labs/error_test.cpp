// SPDX-License-Identifier: MIT
// The view `error`: each method against the exact answer, in figures that an independent reasoning gives as
// well.
#include "../support/tolerance.hpp"
#include "labs.hpp"

namespace texel::test {
namespace {

// ---- Lab 1: 8-bit steps against the mean over each pixel.

TEST(ErrorOfLab1, falls_from_nearest_to_supersampled_on_a_fine_checker) {
  const Settings tilted = {{"texture", "checker"}, {"tilt", "75"}, {"texture_scale", "12"}};
  const auto mean = [&](const char* method) {
    return measured("lab01_texture_quad", tilted + Settings{{"method", method}}).mean;
  };
  // Fields are narrower than pixels far away: without mipmaps black or white stands where grey should (188 of
  // 255 in linear light). Measured 118, 117, 11.7 and 6.2.
  const double nearest = mean("nearest"), bilinear = mean("bilinear"), trilinear = mean("trilinear"),
               supersampled = mean("supersampled");
  EXPECT_ABOVE(nearest, bilinear);
  EXPECT_ABOVE(bilinear, 5 * trilinear);
  EXPECT_ABOVE(trilinear, 1.5 * supersampled);
  EXPECT_BELOW(supersampled, 8);
}

TEST(ErrorOfLab1, is_that_of_the_wrap_mode_and_place_that_are_asked_for) {
  // Tiles lie as in the method, or whole fields would be wrong, which are a half of the picture by 255 steps.
  // The fields' edges are as soft as a texel of the small mipmap levels: measured 6.1 at most, whatever tile
  // the coordinates begin in.
  for (const char* wrap : {"repeat", "mirrored", "clamp"})
    for (const char* offset : {"0", "1", "3"})
      EXPECT_BELOW(measured("lab01_texture_quad", {{"texture", "checker"},
                                                   {"method", "trilinear"},
                                                   {"texture_scale", "2"},
                                                   {"wrap", wrap},
                                                   {"texture_offset", offset}})
                       .mean,
                   12)
          << wrap << " " << offset;
}

TEST(ErrorOfLab1, shows_that_a_large_coordinate_has_lost_its_fraction) {
  // A float32 of 1e6 counts in steps of 1/16 of the texture: half a cell of the label grid. Measured 73
  // steps by llvmpipe, 165 by softpipe.
  EXPECT_ABOVE(measured("lab01_texture_quad", {{"texture", "label_grid"}, {"texture_offset", "1e6"}}).mean,
               30);
}

// ---- Lab 5: degrees between the lit normal and the exact relief's.

const Settings kBumps = {{"normal_map", "bump"}};

TEST(ErrorOfLab5, of_a_flat_map_is_what_8_bits_cannot_hold) {
  // 128 decodes to 0.0039 in x and in y: atan(0.0039 sqrt(2)) is 0.318 degrees, at every pixel of a face. At
  // the cube's edge a pixel or two belong to the other face by rounding, so the 99th percentile stands for
  // all.
  const Settings flat = {{"normal_map", "flat"}};
  EXPECT_WITHIN(measured("lab05_normal_map", flat).p99, 0.3178, 0.0005);
  EXPECT_BELOW(measured("lab05_normal_map", flat + Settings{{"decode", "exact-flat"}}).p99, 5e-5);
}

TEST(ErrorOfLab5, of_every_tangent_frame_is_small_where_the_texture_keeps_right_angles) {
  // Quad and cube: both truths are the same. Measured 0.18 and 0.31 by Mesa 22, 0.13 by
  // Mesa 25: 8 bits (up to 0.3 degrees) and the filter.
  for (const char* model : {"quad", "cube"})
    for (const char* method :
         {"cotangent", "averaged", "gram-schmidt", "angle-weighted", "mikktspace", "analytic"})
      for (const char* truth : {"baked-map", "height-field"})
        EXPECT_BELOW(measured("lab05_normal_map",
                              kBumps + Settings{{"model", model}, {"method", method}, {"truth", truth}})
                         .mean,
                     0.7)
            << model << " " << method << " " << truth;
}

TEST(ErrorOfLab5, of_screen_axes_is_tens_of_degrees) {
  // Measured 41 on the turned cube: the model's turn is applied twice, and the frame follows the screen.
  EXPECT_ABOVE(
      measured("lab05_normal_map", kBumps + Settings{{"method", "screen-axes"}, {"turn", "50"}}).mean, 20);
}

TEST(ErrorOfLab5, tells_the_height_field_from_the_baked_map_where_the_texture_is_stretched) {
  // The torus is 2 to 3.3 times as long along s as along t. A unit frame knows nothing of that, as bakers
  // want it; the derivative frame keeps it. Each has one truth, 0.2 to 0.3 degrees away, and the other at 6.4
  // degrees.
  const auto mean = [](const char* method, const char* truth) {
    return measured("lab05_normal_map",
                    kBumps + Settings{{"model", "torus"}, {"method", method}, {"truth", truth}})
        .mean;
  };
  EXPECT_BELOW(mean("mikktspace", "baked-map"), 0.4);
  EXPECT_ABOVE(mean("mikktspace", "height-field"), 4);
  EXPECT_BELOW(mean("cotangent", "height-field"), 0.4);
  EXPECT_ABOVE(mean("cotangent", "baked-map"), 4);
}

TEST(ErrorOfLab5, knows_no_truth_for_a_model_from_a_file) {
  const Result result = run_lab("lab05_normal_map", "--measure - --model ship");
  expect_error(result, 3, "lab05_normal_map", {"no exact answer", "choose"});
}

// ---- Lab 6: 8-bit steps against the function that the pictures were made from.

TEST(ErrorOfLab6, of_the_right_faces_is_small_and_of_the_worksheet_s_order_is_not) {
  const Settings smooth = {{"cube_map", "smooth"}};
  // Rounding to 8 bits in the file and again in the picture: 0.25 steps each for one channel, more for the
  // largest of three. Measured 0.60; the worksheet's order and flip 89.
  EXPECT_BELOW(measured("lab06_cube_map", smooth).mean, 1);
  EXPECT_BELOW(
      measured("lab06_cube_map", smooth + Settings{{"tilt", "30"}, {"turn", "50"}, {"pitch", "20"}}).mean, 1);
  EXPECT_ABOVE(measured("lab06_cube_map", smooth + Settings{{"method", "worksheet"}}).mean, 40);
}

TEST(ErrorOfLab6, of_one_picture_by_two_angles_is_larger_with_the_naive_seam) {
  const Settings seam = {
      {"mapping", "sphere-2d"}, {"picture", "brick"}, {"turn", "180"}, {"tilt", "50"}, {"yaw", "10"}};
  // A line of pixels a few wide through 256: measured 4.20 against 4.45 in the mean.
  const double analytic = measured("lab06_cube_map", seam).mean;
  EXPECT_BELOW(analytic, 6);
  EXPECT_ABOVE(measured("lab06_cube_map", seam + Settings{{"seam_method", "naive"}}).mean, analytic + 0.1);
}

// ---- Lab 7: degrees between each pixel's direction and the camera's ray.

TEST(ErrorOfLab7, of_the_analytic_ray_is_2e_5_degrees_at_most_at_every_near_and_far) {
  for (const auto& [near, far] :
       {std::pair("1", "20"), {"0.1", "100"}, {"0.0001", "1000"}, {"0.00001", "100"}}) {
    const Figures error =
        measured("lab07_environment", {{"near", near}, {"far", far}, {"yaw", "30"}, {"pitch", "20"}});
    // A unit vector in float32 is good to about 3e-8, or 2e-6 degrees, a component. Measured 8.1e-6 at most
    // by llvmpipe, 1.2e-5 by softpipe.
    EXPECT_BELOW(error.most, 2.2e-5) << near << " " << far;
    EXPECT_GT(error.mean, 0);
    EXPECT_EQ(error.non_finite, 0);
    EXPECT_GT(error.pixels, 256 * 256 / 2);
  }
}

TEST(ErrorOfLab7, of_unproject_grows_as_near_gets_smaller) {
  const auto mean = [](const char* near) {
    return measured("lab07_environment",
                    {{"near", near}, {"method", "unproject"}, {"yaw", "30"}, {"pitch", "20"}})
        .mean;
  };
  // The point lies `near` in front of an eye at 2.5, whose float32 has steps of 2e-7: about 1e-7 / near
  // radians, ten times as much each time. Measured 4.8e-5, 4.1e-4, 0.069 and 0.69 for 0.1, 0.01, 1e-4 and
  // 1e-5.
  EXPECT_BELOW(mean("0.1"), 2e-4);
  EXPECT_ABOVE(mean("0.01"), 2e-4);
  EXPECT_ABOVE(mean("0.00001"), 0.1);
}

// ---- Lab 8: degrees between the reflected ray and that of the exact ball.

TEST(ErrorOfLab8, of_rays_per_fragment_with_the_analytic_normal_is_float32_s) {
  // The normal is that of the sphere, whatever the triangles are: measured 2e-5 to 5e-5 in the mean, and 0.11
  // in one pixel at the rim, where the root of a difference near 0 loses half of the digits.
  for (const Settings& look : {Settings{},
                               {{"distance", "4"}},
                               {{"rings", "8"}, {"segments", "12"}},
                               {{"stretch", "4"}, {"tilt", "30"}},
                               {{"distance", "0.5"}, {"surface", "refraction"}}}) {
    const Figures error = measured("lab08_reflection", look);
    EXPECT_BELOW(error.mean, 2e-4) << flags(look);
    EXPECT_BELOW(error.most, 0.5) << flags(look);
    EXPECT_EQ(error.non_finite, 0) << flags(look);
  }
}

TEST(ErrorOfLab8, of_one_ray_for_the_whole_ball_is_9_7_degrees) {
  // The angle at the eye between the ball's middle and the point that is seen, asin(1 / 4) = 14.48 at the
  // rim. Its mean over the ball's disc: with r = 4 sin(angle) even over the disc's area, about 2/3 of the
  // rim's. Measured 9.722.
  const Figures error = measured("lab08_reflection", {{"method", "constant-eye"}, {"distance", "4"}});
  EXPECT_WITHIN(error.mean, 9.72, 0.02);
  EXPECT_WITHIN(error.most, 14.47, 0.05);
}

TEST(ErrorOfLab8, of_interpolated_normals_is_that_of_the_triangles) {
  // 64 segments are 5.6 degrees wide. Measured 0.27 made unit again, 0.40 not.
  const double unit = measured("lab08_reflection", {{"normal_method", "renormalised"}}).mean;
  EXPECT_ABOVE(unit, 0.1);
  EXPECT_ABOVE(measured("lab08_reflection", {{"normal_method", "interpolated"}}).mean, 1.2 * unit);
}

TEST(ErrorOfLab8, of_the_model_matrix_for_normals_is_tens_of_degrees_on_a_stretched_ball) {
  // Measured 48.
  EXPECT_ABOVE(
      measured("lab08_reflection", {{"stretch", "4"}, {"tilt", "30"}, {"normal_matrix", "model"}}).mean, 30);
}

// ---- Lab 9: degrees between the reflected ray and that at the exact relief.

TEST(ErrorOfLab9, is_no_larger_where_the_map_begins_and_ends) {
  const auto mean = [](const char* yaw) {
    return measured("lab09_bump", {{"yaw", yaw}, {"pitch", "0"}}).mean;
  };
  // The seam stands upright behind the ball. Measured 0.01 less than in front; with a coarse level along it
  // 0.1 more.
  EXPECT_LT(mean("165"), mean("15") + 0.05);
}

TEST(ErrorOfLab9, of_the_frame_along_u_and_v_is_small_for_a_map_and_blinn_s_for_a_height_field) {
  const auto mean = [](const char* method, const char* truth) {
    return measured("lab09_bump", {{"method", method}, {"truth", truth}}).mean;
  };
  // 8 bits, 0.3 degrees at most and doubled by reflection, less by the strength of 0.4; and the ball's
  // triangles, 0.07. Measured 0.14 and 0.12; across, 3.4: around the equator a map is twice as long in u as
  // in v.
  EXPECT_BELOW(mean("uv-aligned", "baked-map"), 0.25);
  EXPECT_BELOW(mean("blinn", "height-field"), 0.25);
  EXPECT_ABOVE(mean("uv-aligned", "height-field"), 2);
  EXPECT_ABOVE(mean("blinn", "baked-map"), 2);
  // A frame from the normal alone turns the bumps by any angle. Measured 22.
  EXPECT_ABOVE(mean("duff", "baked-map"), 10);
  EXPECT_ABOVE(mean("rotate-to-normal", "baked-map"), 10);
}

}  // namespace
}  // namespace texel::test
