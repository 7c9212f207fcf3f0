// SPDX-License-Identifier: MIT
// Wrong declarations do not compile: see tests/compile_fail.
#include <gtest/gtest.h>

#include "../support/said.hpp"
#include "params/set.hpp"

namespace texel::params {
namespace {

enum class Method { nearest, gram_schmidt, mikktspace };
constexpr Item methods[] = {{"nearest", "The nearest texel"},
                            {"gram-schmidt", "Orthogonal to the normal"},
                            {"mikktspace", "As most baking programs"}};
constexpr Item pictures[] = {{"brick", "A wall"}, {"wood", "Boards"}};

struct Look {
  bool normal_map{};
  int count{};
  float tilt{}, scale{};
  Method method{};
  std::string texture;
  Set set;

  Look() {
    set.section("Surface");
    set.add(normal_map, {"normal_map", true, "Bumps on or off"});
    set.add(count, {"count", 8, 3, 64, "segments", "How finely the sphere is cut"});
    set.section("View");
    set.add(tilt, {"tilt", 60, -89, 89, "degrees", "How far the quad leans back"});
    set.add(scale, {"scale", 0.1, 0.1, 10, "", "How often it repeats", Scale::logarithmic});
    set.add(method, {"method", Method::gram_schmidt, methods, "How the frame is made"});
    set.add(texture, {"texture", "brick", pictures, "The picture"});
  }
};

TEST(Parameters, start_at_their_defaults_and_set_the_variable_that_they_stand_for) {
  Look look;
  EXPECT_TRUE(look.normal_map);
  EXPECT_EQ(look.count, 8);
  EXPECT_EQ(look.tilt, 60.0F);
  EXPECT_EQ(look.scale, 0.1F);
  EXPECT_EQ(look.method, Method::gram_schmidt);
  EXPECT_EQ(look.texture, "brick");
  EXPECT_EQ(look.set.key(), "");
  EXPECT_EQ(look.set.flags(), "");

  look.set.at("normal_map").set("off");
  look.set.at("count").set("12");
  look.set.at("tilt").set("-12.5");  // in degrees: radians are made where a shader's uniform is set
  look.set.at("method").set("mikktspace");
  look.set.at("texture").set("photos/wall.png");
  EXPECT_FALSE(look.normal_map);
  EXPECT_EQ(look.count, 12);
  EXPECT_EQ(look.tilt, -12.5F);
  EXPECT_EQ(look.method, Method::mikktspace);
  EXPECT_EQ(look.texture, "photos/wall.png");
  look.set.reset();
  EXPECT_EQ(look.set.key(), "");
}

TEST(Parameters, have_a_section_a_unit_and_a_value_as_a_number) {
  Look look;
  look.set.at("method").set_value(2);
  EXPECT_EQ(look.method, Method::mikktspace);
  EXPECT_EQ(look.set.at("method").value(), 2);
  EXPECT_EQ(look.set.at("method").most, 2);
  EXPECT_EQ(look.set.at("normal_map").value(), 1);
  EXPECT_EQ(look.set.at("normal_map").flag(), "normal-map");
  EXPECT_EQ(look.set.at("tilt").value(), 60);
  EXPECT_EQ(look.set.at("tilt").unit, "degrees");
  EXPECT_EQ(look.set.at("count").section, "Surface");
  EXPECT_EQ(look.set.at("tilt").section, "View");
}

TEST(Parameters, take_the_ends_of_their_range) {
  Look look;
  for (const char* end : {"-89", "89", "+89"}) EXPECT_NO_THROW(look.set.at("tilt").set(end)) << end;
  // 0.1 as a float lies a little above 0.1 as a double, 1e-1 the same: both are the bound itself.
  EXPECT_NO_THROW(look.set.at("scale").set("0.1"));
  EXPECT_NO_THROW(look.set.at("scale").set("1e-1"));
}

TEST(Parameters, keep_their_value_and_say_what_they_take_when_one_is_refused) {
  const std::string choices = "--method takes one of nearest, gram-schmidt, mikktspace, not ";
  std::vector<std::tuple<const char*, const char*, std::string>> rows = {
      {"tilt", "90", "--tilt takes a number from -89 to 89 degrees, not '90'"},
      {"count", "7.5", "--count takes a whole number from 3 to 64 segments, not '7.5'"},
      {"method", "gram-schmit", choices + "'gram-schmit'; did you mean 'gram-schmidt'?"},
      {"method", "zzz", choices + "'zzz'"},
      {"normal_map", "yes", "--normal-map takes on or off, not 'yes'"},
      {"texture", "", "--texture takes one of brick, wood, or a path"}};
  for (const char* bad : {"", "nan", "-nan", "inf", "1e999", "12x", " 12", "0x10", "++5", "1,5"})
    rows.emplace_back("tilt", bad, "--tilt takes a number");
  for (const auto& [name, value, says] : rows) {
    Look look;
    Parameter& parameter = look.set.at(name);
    const std::string message = test::error_of([&, to = value] { parameter.set(to); }, Exit::usage);
    EXPECT_EQ(message.substr(0, says.size()), says) << value;
    EXPECT_TRUE(says.ends_with("number") || message == says) << message;
    EXPECT_EQ(look.set.key(), "") << value;
  }
}

TEST(Parameters, have_names_of_their_own_and_the_nearest_is_suggested) {
  Look look;
  EXPECT_EQ(test::error_of([&] { static_cast<void>(look.set.at("texure")); }, Exit::usage),
            "there is no parameter 'texure'; did you mean 'texture'?");
  EXPECT_EQ(look.set.find("texure"), nullptr);
  bool again{};
  EXPECT_THROW(look.set.add(again, {"tilt", true, "Once more"}), std::logic_error);
}

TEST(Key, and_flags_hold_what_is_not_the_default_in_declaration_order) {
  Look look;
  look.set.at("texture").set("wood");
  look.set.at("tilt").set("1.25");
  look.set.at("normal_map").set("off");
  EXPECT_EQ(look.set.key(), "normal_map=off tilt=1.25 texture=wood");
  EXPECT_EQ(look.set.flags(), "--normal-map off --tilt 1.25 --texture wood");
  look.set.at("tilt").set("60.0");
  EXPECT_EQ(look.set.key(), "normal_map=off texture=wood");
}

TEST(Flags, are_quoted_where_a_shell_needs_it) {
  Look look;
  look.set.at("texture").set("my wall's $(reboot).png");
  EXPECT_EQ(look.set.flags(), R"(--texture 'my wall'\''s $(reboot).png')");
  EXPECT_EQ(shell_quoted("a/b-c_d.png"), "a/b-c_d.png");
  EXPECT_EQ(shell_quoted(""), "''");
  EXPECT_EQ(shell_quoted("~/x"), "'~/x'");
}

}  // namespace
}  // namespace texel::params
