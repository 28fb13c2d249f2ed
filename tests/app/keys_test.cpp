// The key table is whole and says the truth about its own fields; app/scene/README.md holds the reference made from it.
#include "app/scene/keys.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "app/scene/key_reference.h"
#include "tests/app/temporary_folder.h"

namespace app {
namespace {

bool has_value(const Key& key) {
  return key.kind != Kind::table && key.kind != Kind::list;
}

// A number that the range of the key contains.
double number_in(const Range& range) {
  for (const double x : {0.25, 3.0}) {
    if (range.contains(x)) return x;
  }
  return range.low;
}

// A value other than the default that the key accepts.
Value sample(const Key& key) {
  const double x = number_in(key.range);
  switch (key.kind) {
    case Kind::boolean:
      return true;
    case Kind::integer:
    case Kind::substeps:
      return std::int64_t{3};
    case Kind::number:
      return x;
    case Kind::choice:
      return std::string(key.choices().back());
    case Kind::axes:
      return std::string("xz");
    case Kind::integers:
    case Kind::numbers:
      return std::vector<double>(static_cast<std::size_t>(key.size[1]), 3.0);
    case Kind::joining:
      return 0.5;
    case Kind::names:
      return std::vector<std::string>{"one", "two"};
    case Kind::point:
      return std::vector<double>{1, 2, 3};
    case Kind::direction:
    case Kind::axis:
      return std::vector<double>{1, 0, 0};
    case Kind::box:
      return std::vector<double>{1, 2, 3, 4, 5, 6};
    case Kind::ball:
    case Kind::matrix:
      return std::vector<double>{1, 2, 3, 4};
    case Kind::points:
      return std::vector<double>{1, 2, 3, 4, 5, 6};
    default:
      return std::string("words");
  }
}

TEST(Keys, EveryEntryIsComplete) {
  std::set<std::string_view> seen;
  for (const Key& key : keys()) {
    SCOPED_TRACE(key.path);
    EXPECT_TRUE(seen.insert(key.path).second) << "twice";
    EXPECT_TRUE(parent(key.path).empty() || seen.contains(parent(key.path))) << "comes before its parent";
    EXPECT_TRUE(key.meaning.ends_with(".")) << "the meaning is a sentence";
    EXPECT_EQ(key.kind == Kind::choice, key.choices != nullptr);
    EXPECT_EQ(key.kind == Kind::list, key.path.ends_with("[]"));
    EXPECT_EQ(key.kind == Kind::table, key.binding.get == nullptr);
    EXPECT_EQ(key.kind == Kind::table, key.binding.set == nullptr);
  }
}

TEST(Keys, AlternativesAreKeys) {
  for (const Alternatives& group : alternatives()) {
    for (const std::string_view name : group.names) {
      EXPECT_NE(find_key(std::string(group.table) + "." + std::string(name)), nullptr) << group.table << " " << name;
    }
  }
}

TEST(Keys, WhatIsSetIsRead) {
  for (const Key& key : keys()) {
    if (!has_value(key) || key.path == "time.step") continue;  // time.step is turned into substeps
    Document document = blank_document();
    const Value value = sample(key);
    key.binding.set(document, {}, value);
    EXPECT_EQ(key.binding.get(document, {}), value) << key.path;
  }
}

TEST(Keys, DefaultsAreInRange) {
  const Document blank = blank_document();
  for (const Key& key : keys()) {
    if (!has_value(key) || key.required || !key.absent.empty()) continue;
    const std::optional<Value> value = key.binding.get(blank, {});
    ASSERT_TRUE(value) << key.path << " has neither a default nor words for its absence";
    if (const auto* x = std::get_if<double>(&*value)) {
      EXPECT_TRUE(key.range.contains(*x)) << key.path;
    }
    if (const auto* n = std::get_if<std::int64_t>(&*value)) {
      EXPECT_TRUE(key.range.contains(double(*n))) << key.path;
    }
    if (key.kind == Kind::choice) {
      EXPECT_EQ(std::ranges::count(key.choices(), std::get<std::string>(*value)), 1) << key.path;
    }
  }
}

TEST(Keys, PathsAndPatternsAreInverse) {
  Indices indices = {};
  const Key* key = find_key_at("body.2.pin.1.motion.keyframes.4.1.translate", indices);
  ASSERT_NE(key, nullptr);
  EXPECT_EQ(key->path, "body[].pin[].motion.keyframes[].1.translate");
  EXPECT_EQ(indices, (Indices{2, 1, 4}));
  EXPECT_EQ(path_at(key->path, indices), "body.2.pin.1.motion.keyframes.4.1.translate");
  EXPECT_EQ(find_key_at("body.2", indices)->path, "body[]");
  EXPECT_EQ(find_key_at("body.x.name", indices), nullptr);
  EXPECT_EQ(find_key_at("time.fsp", indices), nullptr);
}

TEST(Keys, RangesSayWhatTheyContain) {
  const Range poisson = find_key("body[].material.poisson")->range;
  EXPECT_EQ(poisson.text(), "in (-1, 0.5)");
  EXPECT_FALSE(poisson.contains(-1));
  EXPECT_TRUE(poisson.contains(0.4999));
  EXPECT_FALSE(poisson.contains(0.5));
  const Range young = find_key("body[].material.young")->range;
  EXPECT_EQ(young.text(), "> 0");
  EXPECT_FALSE(young.contains(0));
  const Range alpha = find_key("body[].damping.alpha")->range;
  EXPECT_EQ(alpha.text(), ">= 0");
  EXPECT_TRUE(alpha.contains(0));
  EXPECT_EQ(find_key("world.gravity")->range.text(), "");
}

// The longest step that divides the frame and is not longer than asked for.
TEST(Keys, StepBecomesSubsteps) {
  struct Case {
    double step;
    std::int64_t fps;
    int substeps;
  };
  for (const Case& c : {Case{0.004, 60, 5}, Case{0.1, 60, 1}, Case{1.0 / 60, 60, 1}, Case{1.0 / 180, 60, 3},
                        Case{0.005, 50, 4}, Case{1e-3, 30, 34}}) {
    Document document;
    find_key("time.fps")->binding.set(document, {}, c.fps);
    find_key("time.step")->binding.set(document, {}, c.step);
    EXPECT_EQ(document.scene.time.substeps, c.substeps) << c.step << " s at " << c.fps;
    EXPECT_LE(1.0 / (double(c.fps) * document.scene.time.substeps), c.step * (1 + 1e-9));
    ASSERT_EQ(document.remarks.size(), 1U);
    EXPECT_NE(document.remarks[0].find("h = "), std::string::npos);
  }
}

TEST(Keys, ReferenceHasARowForEveryKey) {
  const std::string reference = key_reference_markdown();
  for (const Key& key : keys()) {
    EXPECT_NE(reference.find("| `" + std::string(key.path) + "` |"), std::string::npos) << key.path;
  }
  EXPECT_NE(reference.find("| `body[].material.young` | a number | Pa | > 0 | `1e+06` |"), std::string::npos);
}

TEST(Keys, TheDocumentHoldsTheReference) {
  const std::string document = read_all(std::filesystem::path(RITZ_SOURCE_DIR) / "app/scene/README.md");
  const std::string begin = "<!-- keys -->\n";
  const std::string end = "<!-- /keys -->";
  const std::size_t first = document.find(begin);
  ASSERT_NE(first, std::string::npos) << "app/scene/README.md has no line " << begin;
  const std::size_t last = document.find(end, first);
  ASSERT_NE(last, std::string::npos) << "app/scene/README.md has no line " << end;
  EXPECT_TRUE(document.substr(first + begin.size(), last - first - begin.size()) == key_reference_markdown())
      << "put the output of `ritz explain --keys` between the two marks";
}

}  // namespace
}  // namespace app
