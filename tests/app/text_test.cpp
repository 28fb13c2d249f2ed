// Text that is made of numbers and of other text, and the checksum of texts.
#include "app/base/text.h"

#include <gtest/gtest.h>

#include "sim/math/checksum.h"

namespace app {
namespace {

TEST(Text, FormattedIsAsLongAsItMustBe) {
  EXPECT_EQ(formatted("%d of %s", 3, "7"), "3 of 7");
  EXPECT_EQ(formatted("%s", ""), "");
  EXPECT_EQ(formatted("%1000d", 1).size(), 1000U);
  EXPECT_EQ(percent(0.0153), "1.5 %");
  EXPECT_EQ(hexadecimal(0xABC), "0000000000000abc");
}

TEST(Text, QuotedTextEscapesWhatTomlAndJsonForbid) {
  EXPECT_EQ(quoted_text("a \"b\" \\ \n \x01 \x7f \xc3\xa9"), "\"a \\\"b\\\" \\\\ \\n \\u0001 \\u007F \xc3\xa9\"");
}

TEST(Text, AQuotedFieldStaysInItsLine) {
  EXPECT_EQ(quoted_field("a, \"b\"\nc"), "\"a, \"\"b\"\" c\"");
}

// RFC 9923, test vectors of FNV-1a with 64 bits.
TEST(Checksum, IsFnv1a) {
  EXPECT_EQ(sim::checksum(""), 0xcbf29ce484222325U);
  EXPECT_EQ(sim::checksum("a"), 0xaf63dc4c8601ec8cU);
  EXPECT_EQ(sim::checksum("foobar"), 0x85944171f73967e8U);
  EXPECT_EQ(sim::checksum("bar", sim::checksum("foo")), sim::checksum("foobar"));
}

}  // namespace
}  // namespace app
