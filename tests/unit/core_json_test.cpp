// SPDX-License-Identifier: MIT
#include "core/json.hpp"

#include <gtest/gtest.h>

using namespace texel;

TEST(Json, keeps_the_order_of_keys) {
  const std::string text = R"({"b":1,"a":[2.5,null],"c":{"z":true,"y":"s"}})";
  EXPECT_EQ(to_text(parse_json(text)), text);
  EXPECT_EQ(to_text(parse_json(R"({"b":1})"), 2), "{\n  \"b\": 1\n}");
}

TEST(Json, names_the_line_and_column_of_what_is_wrong) {
  try {
    parse_json("[1,\n 2,\n }");
    FAIL() << "it was read";
  } catch (const Json::exception& error) {
    EXPECT_NE(std::string(error.what()).find("line 3, column 2"), std::string::npos) << error.what();
  }
}

TEST(Json, is_null_where_a_text_is_none) {
  for (const char* text : {"", "{", "[1,]", "Segmentation fault", "{\"a\": 1} more", "\"\xFF\""})
    EXPECT_TRUE(json_or_null(text).is_null()) << text;
  EXPECT_EQ(json_or_null("[1]").size(), 1u);
}

TEST(Json, has_a_sign_for_bytes_that_are_no_text) {
  EXPECT_EQ(to_text(Json("a\xFFz")), "\"a\xEF\xBF\xBDz\"");
}
