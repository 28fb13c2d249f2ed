// What is sharp, thin or fast, in steps that are far too long for it: nothing passes, whatever becomes of the motion.
#include "tests/sim/contact_support.h"
#include "tests/sim/stepping.h"

namespace sim {
namespace {

MaterialSpec soft(double young, double poisson = 0.3) {
  return {"stable-neo-hookean", young, poisson, 1000, ""};
}

Body thin_sheet(const char* name, const Eigen::Vector2d& size, std::array<int, 2> cells, const Vec3& at) {
  Body sheet;
  sheet.name = name;
  sheet.mesh = generate_sheet(size, cells, {1, 1}, ElementKind::tri3);
  rotate(sheet.mesh, {1, 0, 0}, -90);  // into the plane of x and z, which runs down
  translate(sheet.mesh, at);
  sheet.thickness = 1e-3;
  sheet.materials = {soft(1e6)};
  return sheet;
}

Pin moving(const Region& where, const Keyframe& end) {
  Pin pin{where, "xyz", {}, {}};
  pin.motion = {Keyframe{}, end};
  return pin;
}

// One half is laid over the other, and on below it.
Scene folded_sheet() {
  Scene scene;
  Body sheet = thin_sheet("sheet", {1, 0.5}, {10, 5}, {0, 0, 0});
  Keyframe over;
  over.t = 0.6;
  over.translate = {-0.95, 1.5e-3, 0};
  over.centre = {1, 0, 0};
  over.degrees = 170;
  sheet.pins = {Pin{Box{{-1e-6, -1, -1}, {1e-6, 1, 1}}, "xyz", {}, {}},
                moving(Box{{1 - 1e-6, -1, -1}, {1 + 1e-6, 1, 1}}, over)};
  scene.bodies = {sheet};
  scene.contacts = {Contact{{"sheet", "sheet"}, 0.2, {}, {}, {}}};
  return scene;
}

// 0.3 m long, drawn to a point below, at 20 m/s onto a sheet that is held along its rim.
Scene needle_on_sheet() {
  Scene scene;
  Body needle = test::box_body("needle", {0.02, 0.3, 0.02}, 1, {0, 0, 0}, 1e7);
  needle.mesh = generate_box({0.02, 0.3, 0.02}, {1, 6, 1}, {1, 1, 1}, ElementKind::tet4);
  for (Eigen::Index i = 0; i < needle.mesh.X.cols(); ++i)
    for (const int axis : {0, 2}) needle.mesh.X(axis, i) *= 0.01 + needle.mesh.X(1, i) / 0.3;
  translate(needle.mesh, {0.47, 0.1, -0.23});
  needle.velocity = {0, -20, 0};
  Body sheet = thin_sheet("sheet", {1, 0.5}, {8, 4}, {0, 0, 0});
  sheet.pins = {
      Pin{Box{{-1e-6, -1, -1}, {1e-6, 1, 1}}, "xyz", {}, {}}, Pin{Box{{1 - 1e-6, -1, -1}, {2, 1, 1}}, "xyz", {}, {}},
      Pin{Box{{-1, -1, -1e-6}, {2, 1, 1}}, "xyz", {}, {}}, Pin{Box{{-1, -1, -1}, {2, 1, -0.5 + 1e-6}}, "xyz", {}, {}}};
  scene.bodies = {sheet, needle};
  scene.contacts = {Contact{}};
  return scene;
}

// Four teeth of 20 mm on a back: a box without the cells between them.
Mesh comb_mesh() {
  const Mesh whole = generate_box({0.5, 0.5, 0.2}, {25, 5, 1}, {1, 1, 1}, ElementKind::tet4);
  std::vector<int> number(static_cast<std::size_t>(whole.node_count()), -1), kept;
  Mesh mesh;
  int nodes = 0;
  for (int e = 0; e < whole.element_count(); ++e) {
    Vec3 middle = Vec3::Zero();
    for (int a = 0; a < 4; ++a) middle += whole.X.col(whole.elements(a, e)) / 4;
    if (middle.y() > 0.1 && std::fmod(middle.x(), 0.12) > 0.02) continue;
    kept.push_back(e);
    for (int a = 0; a < 4; ++a)
      if (int& own = number[static_cast<std::size_t>(whole.elements(a, e))]; own < 0) own = nodes++;
  }
  mesh.X.resize(3, nodes);
  for (int i = 0; i < whole.node_count(); ++i)
    if (number[static_cast<std::size_t>(i)] >= 0) mesh.X.col(number[static_cast<std::size_t>(i)]) = whole.X.col(i);
  mesh.elements.resize(4, static_cast<Eigen::Index>(kept.size()));
  for (std::size_t k = 0; k < kept.size(); ++k)
    for (int a = 0; a < 4; ++a)
      mesh.elements(a, static_cast<Eigen::Index>(k)) = number[static_cast<std::size_t>(whole.elements(a, kept[k]))];
  return mesh;
}

// One comb falls between the teeth of another that is held, and into them, turned a little.
Scene combs() {
  Scene scene;
  for (const char* name : {"low", "top"}) {
    Body comb;
    comb.name = name;
    comb.mesh = comb_mesh();
    comb.materials = {soft(1e6)};
    scene.bodies.push_back(comb);
  }
  scene.bodies[0].pins = {Pin{Box{{-1, -1e-6, -1}, {1, 1e-6, 1}}, "xyz", {}, {}}};
  rotate(scene.bodies[1].mesh, {0, 0, 1}, 180);
  rotate(scene.bodies[1].mesh, {0, 1, 0}, 2);
  translate(scene.bodies[1].mesh, {0.54, 1.02, 0.01});
  scene.bodies[1].velocity = {0.5, -8, 0};
  scene.contacts = {Contact{{}, 0.3, {}, {}, {}}};
  return scene;
}

// Two rods side by side, their ends turned about the line between them: they wind around each other.
Scene twisted_rods() {
  Scene scene;
  for (const double side : {-1.0, 1.0}) {
    Body rod = test::box_body(side < 0 ? "left" : "right", {1, 0.05, 0.05}, 1, {0, 0, 0});
    rod.mesh = generate_box({1, 0.05, 0.05}, {20, 1, 1}, {1, 1, 1}, ElementKind::tet4);
    translate(rod.mesh, {0, -0.025 + 0.03 * side, -0.025});
    rod.materials = {soft(1e5)};
    for (const double end : {0.0, 1.0}) {
      Keyframe turned;
      turned.t = 2;
      turned.axis = {1, 0, 0};
      turned.degrees = end == 0 ? -540 : 540;
      rod.pins.push_back(moving(Box{{end - 1e-6, -1, -1}, {end + 1e-6, 1, 1}}, turned));
    }
    scene.bodies.push_back(rod);
  }
  scene.contacts = {Contact{}};
  return scene;
}

// A small block at 40 m/s through a sheet, were it let.
Scene block_on_sheet() {
  Scene scene = needle_on_sheet();
  scene.bodies[1].mesh = test::box_mesh({0.06, 0.06, 0.06}, {0.47, 0.1, -0.23});
  rotate(scene.bodies[1].mesh, {1, 0, 1}, 10);
  scene.bodies[1].velocity = {0, -40, 0};
  return scene;
}

struct Extreme {
  const char* name;
  Scene (*scene)();
  double seconds;
  double lowest = -1e9;  // m: how low the last body may be within 0.2 s, which it would leave below if it passed
};

// In steps of a film's frame and of a fifth of a second: nothing crosses, all is finite, and a step that cannot be
// taken says why.
TEST(ContactExtremes, NothingCrosses) {
  for (const Extreme& it : {Extreme{"sheet folded on itself", folded_sheet, 0.8},
                            {"needle on a sheet", needle_on_sheet, 1, -0.9},
                            {"block on a sheet", block_on_sheet, 1, -0.9},
                            {"combs", combs, 1},
                            {"twisted rods", twisted_rods, 2}})
    for (const int fps : {24, 5}) {
      SCOPED_TRACE(std::string(it.name) + ", h = 1/" + std::to_string(fps) + " s");
      Scene scene = it.scene();
      scene.time.fps = fps;
      const System system(scene);
      State state = system.initial_state();
      const auto stepper = make_stepper(system, 1);
      int newton = 0, most = 0, unsolved = 0, touching = 0;
      const auto steps = static_cast<int>(it.seconds * fps);
      std::string failure;
      for (int k = 0; k < steps && failure.empty(); ++k) {
        const StepReport report = stepper->step(state);
        failure = report.failure;
        newton += report.newton;
        most = std::max(most, report.newton);
        unsolved += !report.converged;
        for (const ContactReport& contact : system.contacts(state)) touching += contact.pairs > 0;
        ASSERT_TRUE(state.x.allFinite() && state.v.allFinite()) << "step " << k;
        // Crushed elements turn inside out: of a body with itself only where the scene says so.
        const bool own = !scene.contacts.empty() && !scene.contacts[0].between.empty();
        ASSERT_EQ(test::count_crossings(scene, state.x, own), 0) << "step " << k;
        const BodyRange& last = system.bodies().back();
        if (k + 1 <= 0.2 * fps) {
          EXPECT_GT(state.x[3 * last.first_node + 1], it.lowest) << "step " << k;
        }
      }
      std::printf("%s at h = 1/%d s: %d iterations, %d at most, %d unsolved, %d touches%s%s\n", it.name, fps, newton,
                  most, unsolved, touching, failure.empty() ? "" : ", stopped: ", failure.c_str());
      std::fflush(stdout);
      EXPECT_EQ(failure, "");
      if (fps > 5) {
        EXPECT_GT(touching, 0);
      }
    }
}

}  // namespace
}  // namespace sim
