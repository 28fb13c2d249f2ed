// What a scene is told before it runs: what touches or overlaps an obstacle, what nothing holds, what locks.
#include "sim/build/bending.h"
#include "tests/sim/stepping.h"

namespace sim::test {
namespace {

Scene block_on(const ObstacleShape& obstacle, const Vec3& translate) {
  Scene scene;
  Body body;
  body.name = "block";
  body.mesh = generate_box({1, 1, 1}, {2, 2, 2}, {1, 1, 1}, ElementKind::tet4);
  body.mesh.X.colwise() += translate;
  body.materials = {MaterialSpec{"stable-neo-hookean", 1e6, 0.45, 1000, ""}};
  scene.bodies = {body};
  scene.obstacles = {{obstacle, 0}};
  return scene;
}

std::string refusal(const Scene& scene) {
  try {
    const System system(scene, 1);
  } catch (const InputError& error) {
    return error.key + ": " + error.what();
  }
  return "";
}

TEST(Touching, ABodyOnAPlaneStaysWhereItIs) {
  for (const double height : {0.0, -1e-10, 4e6}) {
    Scene scene = block_on(Plane{{0, height == 4e6 ? height : 0, 0}, {0, 1, 0}}, {0, height, 0});
    scene.probes = {{"top", "block", {0.5, height + 1, 0.5}}};
    Stepped run(scene);
    run.steps(30);
    EXPECT_LT(std::abs(run.tip().y()), 0.01) << height;
  }
}

TEST(Touching, ABodyOnASphereAndOnSeveralPlanesRuns) {
  EXPECT_EQ(refusal(block_on(Sphere{{0.5, -0.5, 0.5}, 0.5}, {0, 0, 0})), "");
  Scene corner = block_on(Plane{{0, 0, 0}, {0, 1, 0}}, {0, 0, 0});
  corner.obstacles.push_back({Plane{{0, 0, 0}, {1, 0, 0}}, 0});
  EXPECT_EQ(refusal(corner), "");
}

TEST(Touching, AnOverlapNamesBodyDepthAndTheWayOut) {
  EXPECT_EQ(refusal(block_on(Plane{{0, 0.25, 0}, {0, 2, 0}}, {0, 0, 0})),
            "obstacle.0: \"block\" starts 0.25 m inside this obstacle: translate it by (0, 0.25, 0), or move the "
            "obstacle");
}

std::string static_failure(const Scene& scene) {
  const System system(scene, 1);
  State state = system.initial_state();
  return make_stepper(system, 1)->step(state).failure;
}

TEST(Held, StaticsOfABodyThatNothingHoldsFailsWithItsFreeMotions) {
  Scene scene = beam("tet4", 1);
  scene.time.integrator = "static";
  EXPECT_EQ(static_failure(scene), "");
  scene.bodies[0].pins.clear();
  EXPECT_EQ(static_failure(scene),
            "nothing holds \"beam\" against its load: 6 motions of a rigid body are free (along x, along y, along z, "
            "about x, about y, about z); pin it, or take an integrator that moves");
  // Held in y and z and against turning, it could move along x only, where no load acts.
  scene.bodies[0].pins = {Pin{Box{{-1, -1, -1}, {9, 9, 9}}, "yz", {}, {}}};
  EXPECT_EQ(static_failure(scene), "");
  scene.bodies[0].pins = {Pin{Box{{-1, -1, -1}, {9, 9, 9}}, "xy", {}, {}}};
  EXPECT_NE(static_failure(scene).find("1 motion of a rigid body is free (along z)"), std::string::npos);
}

TEST(Held, ALoadThatHingesCannotHoldIsFound) {
  Scene scene = beam("tet4", 1);
  scene.time.integrator = "static";
  scene.bodies[0].pins = {Pin{Box{{0, 0, 0}, {0, 0, 0}}, "xyz", {}, {}}};
  EXPECT_NE(static_failure(scene).find("3 motions of a rigid body are free (about x, about y, about z)"),
            std::string::npos)
      << static_failure(scene);
  scene.world.gravity = {0, 0, 0};
  EXPECT_EQ(static_failure(scene), "");
}

TEST(Held, DampingIsNoLoad) {
  Scene scene = beam("tet4", 1);
  scene.time.integrator = "static";
  const auto rest = [&] {
    const System system(scene);
    State state = system.initial_state();
    EXPECT_EQ(make_stepper(system, 1)->step(state).failure, "");
    return state.x;
  };
  const Eigen::VectorXd undamped = rest();
  scene.bodies[0].damping = {0.3, 0.1};
  EXPECT_EQ(rest(), undamped);
}

int remarks_naming(const Scene& scene, const std::string& part) {
  int count = 0;
  for (const std::string& remark : System(scene, 1).remarks()) count += remark.find(part) != std::string::npos;
  return count;
}

TEST(Locking, EveryElementThatLocksIsToldAndNoOther) {
  const std::pair<const char*, int> expected[] = {{"tet4", 1}, {"hex8", 1}, {"tet10", 0}};
  for (const auto& [element, count] : expected) {
    EXPECT_EQ(remarks_naming(beam(element, 2, 1e6, 0.499), "it will bend too little"), count) << element;
    EXPECT_EQ(remarks_naming(beam(element, 2, 1e6, 0.3), "it will bend too little"), 0) << element;
  }
  const std::pair<const char*, int> plane[] = {{"tri3", 1}, {"quad4", 1}, {"tri6", 0}};
  for (const auto& [element, count] : plane) {
    Scene scene = plate("backward-euler", 1);
    scene.bodies[0].mesh = generate_rectangle({2, 1}, {4, 2}, {1, 1}, find_element(element)->kind);
    scene.bodies[0].materials[0].poisson = 0.49;
    EXPECT_EQ(remarks_naming(scene, "locking"), count) << element;
  }
}

// A plane cantilever 10 m long and 1 m high: its stiffness against bending by what one column of its elements measures.
TEST(Locking, SlenderBendingIsToldWithItsExcess) {
  Scene scene = plate("backward-euler", 1);
  const auto remarks = [&](std::array<int, 2> cells, ElementKind kind, const char* text) {
    scene.bodies[0].mesh = generate_rectangle({10, 1}, cells, {1, 1}, kind);
    return remarks_naming(scene, text);
  };
  EXPECT_EQ(remarks({10, 1}, ElementKind::quad4, "are 1 times as long as it is high"), 1);
  EXPECT_EQ(remarks({10, 4}, ElementKind::quad4, "36 % too stiff"), 1);
  EXPECT_EQ(remarks({40, 4}, ElementKind::quad4, "slender"), 0);
  EXPECT_EQ(remarks({40, 1}, ElementKind::tri3, "slender"), 1);
  EXPECT_EQ(remarks({10, 1}, ElementKind::tri6, "slender"), 0);
}

// G a^2/12 of shear that bending has not, over E' H^2/12, E' = E/(1 - nu^2): what a column of bilinear elements of
// length a has too much, once it is fine across. [Cook et al. 2002, 6.6]
TEST(Bending, OfALongBilinearElementHasTheShearOfTextbooks) {
  const double nu = 0.3, a = 2, shear = a * a * (1 - nu * nu) / (2 * (1 + nu));
  EXPECT_NEAR(bending_excess(ElementKind::quad4, {{a, 1, 1}, {1, 40, 1}}, nu), shear, 0.01 * shear);
}

TEST(Bending, QuadraticElementsAreExactAndOthersConverge) {
  for (const ElementKind kind : {ElementKind::tri6, ElementKind::tet10})
    for (const bool confined : {false, true})
      EXPECT_NEAR(bending_excess(kind, {{1.5, 1, 0.7}, {2, 1, 2}, confined}, 0.45), 0, 1e-8);
  for (const ElementKind kind : {ElementKind::tri3, ElementKind::quad4, ElementKind::tet4, ElementKind::hex8}) {
    const double coarse = bending_excess(kind, {{1, 1, 1}, {2, 2, 2}}, 0.3),
                 fine = bending_excess(kind, {{1, 1, 1}, {4, 4, 4}}, 0.3);
    EXPECT_NEAR(coarse / fine, 4, 0.3) << info(kind).name;
  }
}

// Confined, what linear elements have too much grows with the bulk modulus, tenfold from 0.49 to 0.499.
TEST(Bending, OnlyElementsThatLockStiffenWithTheBulkModulus) {
  for (const ElementKind kind : {ElementKind::tri3, ElementKind::quad4, ElementKind::tet4, ElementKind::hex8}) {
    const BentBlock block{{1, 1, 1}, {4, 4, 4}, true};
    EXPECT_GT(bending_excess(kind, block, 0.499), 5 * bending_excess(kind, block, 0.49)) << info(kind).name;
  }
}

TEST(Held, ASceneInWhichNothingCanMoveSaysSo) {
  Scene scene = beam("tet4", 1);
  EXPECT_EQ(remarks_naming(scene, "nothing is left to move"), 0);
  scene.bodies[0].pins = {Pin{Box{{-1, -1, -1}, {9, 9, 9}}, "xyz", {}, {}}};
  EXPECT_EQ(remarks_naming(scene, "nothing is left to move"), 1);
  scene.bodies[0].pins[0].release = 1;
  EXPECT_EQ(remarks_naming(scene, "nothing is left to move"), 0);
}

TEST(Held, PinsThatDisagreeAreTold) {
  const auto moved = [](double t, double x) { return Keyframe{.t = t, .translate = {x, 0, 0}}; };
  const Box left{{-1, -1, -1}, {1e-6, 9, 9}};
  Scene scene = beam("tet4", 1);
  scene.bodies[0].pins = {Pin{left, "xyz", {}, {}}, Pin{left, "yz", {moved(0, 0), moved(0.2, 0.5)}, {}}};
  EXPECT_EQ(remarks_naming(scene, "for the same nodes"), 0) << "the second holds other components still";
  scene.bodies[0].pins[1].axes = "x";
  EXPECT_EQ(remarks_naming(scene,
                           "pin 0 of \"beam\" and pin 1 of \"beam\" prescribe other places for the same nodes, "
                           "from t = 0.2 s on and there 0.5 m apart"),
            1);
  scene.bodies[0].pins[0].release = 0.1;
  EXPECT_EQ(remarks_naming(scene, "for the same nodes"), 0) << "one has let go before";
  EXPECT_EQ(remarks_naming(scene, "first frame"), 0);
  scene.bodies[0].pins = {Pin{left, "xyz", {moved(0, 5), moved(0.2, 0.5)}, {}}};
  EXPECT_EQ(remarks_naming(scene, "the script of pin 0 of \"beam\" begins 5 m from where its nodes are at rest"), 1);
}

}  // namespace
}  // namespace sim::test
