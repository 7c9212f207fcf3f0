// SPDX-License-Identifier: MIT
// Lab 2: the number that each combination of two colours gives, and the levels that the two kinds of mipmaps
// hold.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "../support/tolerance.hpp"
#include "image/color.hpp"
#include "image/load.hpp"
#include "image/save.hpp"
#include "labs.hpp"

namespace texel::test {
namespace {

using Color = std::array<double, 3>;

constexpr std::array<std::uint8_t, 3> kFirst = {200, 100, 50};
constexpr std::array<std::uint8_t, 4> kSecond = {60, 120, 240, 64};
constexpr Color kFactor = {1, 0.5, 0.25};  // red, green and blue
constexpr double kMixFactor = 0.2;

/// A picture of one texel.
template <std::size_t Channels>
std::string one_texel(const std::filesystem::path& file, const std::array<std::uint8_t, Channels>& texel) {
  image::Image8 picture(1, 1, static_cast<int>(Channels));
  std::copy(texel.begin(), texel.end(), picture.samples.begin());
  image::save_png(file, picture);
  return file.string();
}

/// One channel of what the combination gives, in numbers that are decoded first and encoded again or not.
double combined(const std::string& combine, int channel, bool linear) {
  const auto decoded = [&](std::uint8_t sample) {
    return linear ? image::linear_from_srgb(sample / 255.0) : sample / 255.0;
  };
  const auto c = static_cast<std::size_t>(channel);
  const double first = kFactor[c] * decoded(kFirst[c]), second = decoded(kSecond[c]);
  const double alpha = kSecond[3] / 255.0;
  const double result = combine == "multiply" ? first * second
                        : combine == "mix"    ? (1 - kMixFactor) * first + kMixFactor * second
                        : combine == "add"    ? first + second
                                              : (1 - alpha) * first + alpha * second;
  const double clamped = std::min(result, 1.0);
  return 255 * (linear ? image::srgb_from_linear(clamped) : clamped);
}

TEST(CombinationOfLab2, gives_the_number_that_its_formula_does) {
  const TemporaryFolder folder(fmt::format("combine_{}", ::getpid()));
  const Settings pictures = {{"texture0", one_texel(folder / "first.png", kFirst)},
                             {"texture1", one_texel(folder / "second.png", kSecond)},
                             {"red", fmt::format("{}", kFactor[0])},
                             {"green", fmt::format("{}", kFactor[1])},
                             {"blue", fmt::format("{}", kFactor[2])},
                             {"mix_factor", fmt::format("{}", kMixFactor)}};
  const std::array<const char*, 4> combinations = {"multiply", "mix", "add", "decal"};
  const std::array<const char*, 3> methods = {"encoded", "linear", "premultiplied"};
  std::vector<Shot> shots;
  for (const char* combine : combinations)
    for (const char* method : methods)
      shots.push_back({fmt::format("{} {}", combine, method),
                       pictures + Settings{{"combine", combine}, {"method", method}}});
  draw("lab02_multi_texture", shots, folder);
  for (const char* combine : combinations)
    for (const std::string method : methods) {
      const image::Image8 picture = image::load8(folder / fmt::format("{} {}.png", combine, method));
      // Rounding, and the driver's own curve on writing: measured 0.65. Premultiplied, the texel is rounded
      // once more.
      const double tolerance = method == "premultiplied" ? 1.5 : 1.0;
      for (int channel = 0; channel < 3; ++channel)
        EXPECT_WITHIN(picture.at(64, 64, channel), combined(combine, channel, method != "encoded"), tolerance)
            << combine << " " << method << " " << channel;
    }
}

TEST(CombinationOfLab2, of_one_picture_is_that_picture) {
  const TemporaryFolder folder(fmt::format("alone_{}", ::getpid()));
  const Settings pictures = {{"texture0", one_texel(folder / "first.png", kFirst)},
                             {"texture1", one_texel(folder / "second.png", kSecond)}};
  draw("lab02_multi_texture",
       {{"alone0", pictures + Settings{{"unit1_on", "off"}}},
        {"alone1", pictures + Settings{{"unit0_on", "off"}}}},
       folder);
  const image::Image8 first = image::load8(folder / "alone0.png"),
                      second = image::load8(folder / "alone1.png");
  for (int channel = 0; channel < 3; ++channel) {
    EXPECT_EQ(first.at(64, 64, channel), kFirst[static_cast<std::size_t>(channel)]);
    EXPECT_EQ(second.at(64, 64, channel), kSecond[static_cast<std::size_t>(channel)]);
  }
}

TEST(MipmapsOfLab2, made_by_us_are_means_of_all_texels_of_odd_sizes_too) {
  const TemporaryFolder folder(fmt::format("mipmaps_{}", ::getpid()));
  // One white texel in the middle of nine: a driver may well take that one alone for the smaller level.
  image::Image8 dot(3, 3, 3);
  for (int channel = 0; channel < 3; ++channel) dot.at(1, 1, channel) = 255;
  image::save_png(folder / "dot.png", dot);
  const Settings far = {{"texture0", (folder / "dot.png").string()},
                        {"unit1_on", "off"},
                        {"texture_scale", "100"},
                        {"distance", "30"}};
  draw("lab02_multi_texture", {{"own", far + Settings{{"mipmaps", "own"}}}}, folder);
  EXPECT_WITHIN(image::load8(folder / "own.png").at(64, 64, 0), 255 * image::srgb_from_linear(1 / 9.0), 1);
}

}  // namespace
}  // namespace texel::test
