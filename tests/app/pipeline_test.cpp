#include "app/record/pipeline.h"

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/app/temporary_folder.h"

namespace app {
namespace {

using Squares = Pipeline<int, int>;

Squares::MakeDraw square() {
  return [] { return [](int number) { return number * number; }; };
}

TEST(Pipeline, EverythingArrivesInOrder) {
  std::vector<int> written;
  Squares pipeline(square(), [&](int number) { written.push_back(number); });
  for (int i = 0; i < 1000; ++i) pipeline.push(i);
  pipeline.finish();
  ASSERT_EQ(written.size(), 1000U);
  for (int i = 0; i < 1000; ++i) EXPECT_EQ(written[static_cast<std::size_t>(i)], i * i);
}

TEST(Pipeline, TheFasterStageWaits) {
  std::atomic<int> pushed = 0, written = 0;
  std::atomic<int> furthest_ahead = 0;
  Squares pipeline(
      square(),
      [&](int) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        furthest_ahead = std::max(furthest_ahead.load(), pushed - written);
        ++written;
      },
      2);
  for (int i = 0; i < 50; ++i) {
    pipeline.push(i);
    ++pushed;
  }
  pipeline.finish();
  EXPECT_LE(furthest_ahead, 2 + 1 + 2 + 1);  // two queues of two, one item in each stage
}

TEST(Pipeline, DrawingIsMadeAndUsedAndEndedInOneThread) {
  std::vector<std::thread::id> ids;
  struct Context {
    std::vector<std::thread::id>& ids;
    explicit Context(std::vector<std::thread::id>& ids_) : ids(ids_) { ids.push_back(std::this_thread::get_id()); }
    ~Context() { ids.push_back(std::this_thread::get_id()); }
  };
  Squares pipeline(
      [&] {
        return [&ids, context = std::make_shared<Context>(ids)](int number) {
          ids.push_back(std::this_thread::get_id());
          return number;
        };
      },
      [](int) {});
  pipeline.push(1);
  pipeline.finish();
  ASSERT_EQ(ids.size(), 3U);
  EXPECT_EQ(ids[0], ids[1]);
  EXPECT_EQ(ids[0], ids[2]);
  EXPECT_NE(ids[0], std::this_thread::get_id());
}

TEST(Pipeline, WhatCannotBeginSaysSoAtOnce) {
  const auto make = []() -> Squares::Draw { throw std::runtime_error("no context"); };
  EXPECT_EQ(error_of([&] { Squares(make, [](int) {}); }), "no context");
}

// Pushes until the pipeline throws, which it must, instead of waiting for ever.
std::string error_while_pushing(Squares& pipeline) {
  return error_of([&] {
    for (int i = 0; i < 1000; ++i) pipeline.push(i);
    pipeline.finish();
  });
}

TEST(Pipeline, AnErrorInDrawingEndsTheRun) {
  std::vector<int> written;
  Squares pipeline(
      [] {
        return [](int number) {
          if (number == 5) throw std::runtime_error("cannot draw");
          return number;
        };
      },
      [&](int number) { written.push_back(number); });
  EXPECT_EQ(error_while_pushing(pipeline), "cannot draw");
  EXPECT_LE(written.size(), 5U);
}

TEST(Pipeline, AnErrorInWritingEndsTheRunAndIsThrownAgainAtTheEnd) {
  Squares pipeline(square(), [](int number) {
    if (number == 9) throw std::runtime_error("disk full");
  });
  EXPECT_EQ(error_while_pushing(pipeline), "disk full");
  EXPECT_EQ(error_of([&] { pipeline.finish(); }), "disk full");
}

TEST(Pipeline, WhatWasPushedIsWrittenWhenTheMainThreadThrows) {
  std::vector<int> written;
  EXPECT_EQ(error_of([&] {
              Squares pipeline(square(), [&](int number) { written.push_back(number); });
              pipeline.push(2);
              pipeline.push(3);
              throw std::runtime_error("main");
            }),
            "main");
  EXPECT_EQ(written, (std::vector<int>{4, 9}));
}

}  // namespace
}  // namespace app
