// Letters beyond the usual ones are baked when words bring them, and what the font lacks is known.
#include "render/letters.h"

#include <gtest/gtest.h>

#include "render/imgui_setup.h"

namespace render {
namespace {

TEST(Letters, OnlyNewOnesAreNew) {
  Letters letters;
  EXPECT_FALSE(letters.learn("Plain words, Zürich, λ ≤ 3"));
  EXPECT_TRUE(letters.learn("Łódź, čeština, привет"));
  EXPECT_FALSE(letters.learn("приветźŁ"));
  EXPECT_TRUE(letters.learn("∑ ⇒ ∮"));
}

TEST(Letters, EveryOneOfAnAlphabetHasAGlyphOfItsOwn) {
  if (!has_dejavu()) GTEST_SKIP() << "fonts-dejavu-core is not installed";
  EXPECT_EQ(letters_that_lack("Łódź, čeština, привет, Ελληνικά, Tiếng Việt, ∀x∈ℝ ∑ ∮ ⇒ ↔ ≠"), "");
  EXPECT_EQ(letters_that_lack("a 橡 b 橡皮 c"), "橡皮");
  EXPECT_EQ(letters_that_lack("🙂"), "🙂");
}

}  // namespace
}  // namespace render
