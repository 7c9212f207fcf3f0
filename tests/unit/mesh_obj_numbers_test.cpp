// SPDX-License-Identifier: MIT
// Every number of an OBJ file is the float32 nearest to its text: compared with std::from_chars over many
// texts, most of all those near the middle between two floats.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <string>
#include <vector>

#include "mesh/distinct.hpp"
#include "mesh/obj.hpp"

namespace texel::mesh {
namespace {

/// Reads all words as the numbers of `v` lines and compares the bits with what std::from_chars, which rounds
/// correctly, makes of them.
void expect_nearest(std::vector<std::string> words) {
  while (words.size() % 3 != 0) words.emplace_back("0");
  std::string text;
  for (std::size_t i = 0; i < words.size(); i += 3)
    text += fmt::format("v {} {} {}\n", words[i], words[i + 1], words[i + 2]);
  const ObjData data = parse_obj(text + "f 1 1 1\nv 0 0 0\nv 0 0 0\nf 1 -1 -2\n", "test.obj");
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    float expected = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), expected);
    ASSERT_TRUE(error == std::errc{} && end == word.data() + word.size()) << word;
    const float value = data.positions[i / 3][static_cast<int>(i % 3)];
    ASSERT_EQ(std::bit_cast<std::uint32_t>(value), std::bit_cast<std::uint32_t>(expected)) << word;
  }
}

class ObjNumbers : public testing::Test {
 protected:
  std::uint64_t random(std::uint64_t below) { return (state_ = mix(state_)) % below; }

 private:
  std::uint64_t state_ = 1;
};

TEST_F(ObjNumbers, are_nearest_for_digits_of_every_length_with_the_point_anywhere) {
  std::vector<std::string> words(300'000);
  for (std::string& word : words) {
    for (std::size_t length = 1 + random(22); length > 0; --length)
      word += static_cast<char>('0' + random(10));
    if (random(8) != 0) word.insert(random(word.size() + 1), ".");
    if (random(2) != 0) word.insert(0, "-");
  }
  expect_nearest(std::move(words));
}

TEST_F(ObjNumbers, are_nearest_around_the_middle_between_two_floats) {
  std::vector<std::string> words;
  for (int n = 0; n < 150'000; ++n) {
    // A float of 1e-5 to 1e9 and the next one; their middle is a double.
    const auto bits = static_cast<std::uint32_t>(0x3727C5ACU + random(0x4E6E6B28U - 0x3727C5ACU));
    const double middle = (double{std::bit_cast<float>(bits)} + double{std::bit_cast<float>(bits + 1)}) / 2;
    const int before_point = std::max(1, static_cast<int>(std::ceil(std::log10(middle))));
    // The middle itself, cut to 14 to 18 digits, and the numbers one up and down in the last of them.
    const int places = std::max(1, 14 + static_cast<int>(random(5)) - before_point);
    words.push_back(fmt::format("{:.{}f}", middle, places));
    for (const char digit : {'0', '1', '9'})
      words.push_back(words.back().substr(0, words.back().size() - 1) + digit);
    words.push_back(fmt::format("{:.60f}", middle));  // exactly
    words.push_back(words.back() + "1");
  }
  expect_nearest(std::move(words));
}

TEST_F(ObjNumbers, are_nearest_where_integers_leave_doubles_and_floats) {
  std::vector<std::string> words;
  for (const std::uint64_t middle : {std::uint64_t{1} << 24, std::uint64_t{1} << 25, std::uint64_t{1} << 53,
                                     std::uint64_t{1} << 54, std::uint64_t{9'999'999'999'999'999}})
    for (std::uint64_t i = middle - 200; i < middle + 200; ++i) {
      const std::string digits = fmt::format("{}", i);
      for (std::size_t point = 0; point <= digits.size(); ++point)
        words.push_back(digits.substr(0, point) + "." + digits.substr(point));
      words.push_back(digits);
      words.push_back(digits + "." + std::string(1 + i % 7, '0'));
    }
  expect_nearest(std::move(words));
}

TEST_F(ObjNumbers, are_nearest_with_exponents_zeros_and_signs) {
  std::vector<std::string> words = {"0",      "-0",       "0.",   ".0",      "-.0",   "00",
                                    "-00.00", "000001.5", "1e0",  "1E1",     "-1e-1", "1.e2",
                                    ".1e2",   "1e+2",     "0e0",  "0e99",    "1e38",  "-3.4e38",
                                    "1e-37",  "1e-10",    "1e10", "1.5e-38", "5.",    "-5."};
  for (int n = 0; n < 50'000; ++n)
    words.push_back(fmt::format("{}{}.{}e{}", random(2) == 0 ? "-" : "", random(10), random(1'000'000'000),
                                static_cast<int>(random(70)) - 37));
  expect_nearest(std::move(words));
}

}  // namespace
}  // namespace texel::mesh
