#include "app/base/json.h"

#include <gtest/gtest.h>

#include <limits>

namespace app {
namespace {

TEST(Json, NestsIndentsAndSeparates) {
  Json json;
  json.open_object().member("name", "bear").member("count", 3).key("list").open_array();
  json.value(0.1).value(true).close_array().key("empty").open_object().close_object().close_object();
  EXPECT_EQ(json.text(),
            "{\n  \"name\": \"bear\",\n  \"count\": 3,\n  \"list\": [\n    0.1,\n    true\n  ],\n  \"empty\": {}\n}\n");
}

TEST(Json, EscapesText) {
  Json json;
  json.value("a\"b\\c\nd\x01 \xc3\xa9");
  EXPECT_EQ(json.text(), "\"a\\\"b\\\\c\\nd\\u0001 \xc3\xa9\"");
}

TEST(Json, NumbersThatJsonLacksBecomeNull) {
  Json json;
  json.open_array().value(std::numeric_limits<double>::quiet_NaN()).value(-std::numeric_limits<double>::infinity());
  json.value(std::numeric_limits<std::uint64_t>::max()).close_array();
  EXPECT_EQ(json.text(), "[\n  null,\n  null,\n  18446744073709551615\n]\n");
}

}  // namespace
}  // namespace app
