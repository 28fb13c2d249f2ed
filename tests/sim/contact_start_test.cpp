// Starts in which bodies of a contact cross or touch: refused, with the places and the way out.
#include "sim/contact/meeting.h"
#include "sim/contact/start_error.h"
#include "tests/sim/contact_support.h"
#include "tests/sim/stepping.h"

namespace sim {
namespace {

struct Refusal {
  std::string text;
  std::vector<Vec3> places;
};

Refusal refusal_of(const Scene& scene) {
  try {
    System system(scene);
  } catch (const StartError& error) {
    return {error.key + ": " + error.what(), error.places};
  }
  return {};
}

// Two boxes of 1 m on each other whose sides share their planes, as high above each other as `gap`.
Scene stacked(int dimension, double gap, int cells) {
  Scene scene;
  scene.dimension = dimension;
  for (const double low : {0.0, 1 + gap}) {
    Body body = test::box_body(low == 0 ? "low" : "top", {1, 1, 1}, cells, {0, low, 0});
    if (dimension == 2) {
      body.mesh = generate_rectangle({1, 1}, {cells, cells}, {1, 1}, ElementKind::tri3);
      translate(body.mesh, {0, low, 0});
    }
    scene.bodies.push_back(body);
  }
  scene.contacts = {Contact{}};
  return scene;
}

bool has(const Refusal& refusal, const char* words) {
  return refusal.text.find(words) != std::string::npos;
}

TEST(ContactStart, CrossingsAreToldWithTheWayOut) {
  const Refusal it = refusal_of(test::two_boxes(2, -0.3));
  EXPECT_TRUE(has(it, "contact.0: \"low\" and \"top\" cross each other at the start, at ")) << it.text;
  // 0.3 m up, and the barrier's width.
  EXPECT_TRUE(has(it, "; \"top\" is free where it is moved by (0, 0.301, 0) m: bodies")) << it.text;
  EXPECT_GT(it.places.size(), 2U);
  for (const Vec3& place : it.places) EXPECT_TRUE(place.y() > 0.4 && place.y() < 1.3) << place;
}

// No edge goes through a face where sides share their planes: such blocks were said to touch.
TEST(ContactStart, BlocksWithSidesInOnePlaneCrossOrTouch) {
  for (const int dimension : {2, 3})
    for (const int cells : {1, 3}) {
      const Refusal deep = refusal_of(stacked(dimension, -0.1, cells)),
                    touch = refusal_of(stacked(dimension, 0, cells));
      EXPECT_TRUE(has(deep, "cross each other")) << deep.text;
      EXPECT_TRUE(has(deep, dimension == 2 ? "moved by (0, 0.101) m" : "moved by (0, 0.101, 0) m")) << deep.text;
      EXPECT_TRUE(has(touch, "\"low\" and \"top\" touch at the start, at ")) << touch.text;
      EXPECT_TRUE(has(touch, dimension == 2 ? "moved by (0, 0.001) m" : "moved by (0, 0.001, 0) m")) << touch.text;
      for (const Vec3& place : touch.places) EXPECT_NEAR(place.y(), 1, 1e-12);
    }
}

// What is said to be the way out is one, and a gap as small as round-off allows is a gap.
TEST(ContactStart, TheWayOutIsOneAndTinyGapsAreGaps) {
  Scene scene = stacked(3, -0.1, 2);
  translate(scene.bodies[1].mesh, {0, 0.101, 0});
  EXPECT_EQ(refusal_of(scene).text, "");
  for (const double gap : {1e-3, 1e-6, 1e-9}) EXPECT_EQ(refusal_of(stacked(3, gap, 2)).text, "") << gap;
  EXPECT_TRUE(has(refusal_of(stacked(3, 1e-12, 2)), "touch at the start"));
  EXPECT_TRUE(has(refusal_of(stacked(3, -1e-6, 2)), "cross each other"));
}

TEST(ContactStart, ABodyInsideAnotherAndOneInARoom) {
  Scene scene;
  scene.bodies = {test::box_body("large", {1, 1, 1}, 2, {0, 0, 0}),
                  test::box_body("small", {0.2, 0.2, 0.2}, 1, {0.4, 0.4, 0.4})};
  scene.contacts = {Contact{}};
  EXPECT_TRUE(has(refusal_of(scene), "\"large\" and \"small\" cross each other")) << refusal_of(scene).text;
  Scene room;
  room.bodies = {test::box_body("box", {0.2, 0.2, 0.2}, 1, {0.4, 0.4, 0.4})};
  room.obstacles = {test::surface_obstacle(test::box_mesh({1, 1, 1}, {0, 0, 0}))};
  EXPECT_EQ(refusal_of(room).text, "");
}

TEST(ContactStart, AnObstacleStaysAndTheBodyIsMoved) {
  Scene scene;
  scene.bodies = {test::box_body("box", {1, 1, 1}, 2, {0, -0.1, 0})};
  scene.obstacles = {test::surface_obstacle(test::box_mesh({4, 1, 4}, {-1.3, -1, -1.4}))};
  scene.obstacles[0].name = "table";
  const Refusal it = refusal_of(scene);
  EXPECT_TRUE(it.text.starts_with("obstacle.0: \"box\" and \"table\" cross each other")) << it.text;
  EXPECT_TRUE(has(it, "\"box\" is free where it is moved by (0, 0.101, 0) m")) << it.text;
}

// Every pair that does not start apart is counted, and all places are told.
TEST(ContactStart, OtherPairsAreCounted) {
  Scene scene = stacked(3, -0.1, 1);
  scene.bodies.push_back(test::box_body("third", {1, 1, 1}, 1, {0, 1.8, 0}));
  EXPECT_TRUE(has(refusal_of(scene), "; 1 more pair does not start apart")) << refusal_of(scene).text;
}

}  // namespace
}  // namespace sim
