// Pressure that follows the surface, and forces at points.
#include <numbers>

#include "sim/build/parts.h"
#include "sim/mesh/refine.h"
#include "sim/solve/model.h"
#include "sim/term/enclosed.h"
#include "tests/sim/mesh_support.h"
#include "tests/sim/stepping.h"

namespace sim::test {
namespace {

template <class Facet, int D>
void expect_derivatives() {
  using E = Enclosed<Facet, D>;
  std::srand(3);
  const typename E::Nodes x = E::Nodes::Random(), dx = E::Nodes::Random();
  constexpr double e = 1e-6;
  const double slope = (E::volume(x + e * dx) - E::volume(x - e * dx)) / (2 * e);
  EXPECT_NEAR(E::gradient(x).cwiseProduct(dx).sum(), slope, 1e-9);
  const typename E::Nodes bend = (E::gradient(x + e * dx) - E::gradient(x - e * dx)) / (2 * e);
  typename E::Nodes product = E::Nodes::Zero();
  for (int a = 0; a < Facet::nodes; ++a)
    for (int b = 0; b < Facet::nodes; ++b) {
      product.col(a) += E::hessian(x, a, b) * dx.col(b);
      EXPECT_LT((E::hessian(x, a, b) - E::hessian(x, b, a).transpose()).norm(), 1e-14);
    }
  EXPECT_LT((product - bend).norm(), 1e-8);
}

TEST(Enclosed, DerivativesAreThoseOfTheVolume) {
  expect_derivatives<Edge2, 2>();
  expect_derivatives<Edge3, 2>();
  expect_derivatives<Tri3, 3>();
  expect_derivatives<Tri6, 3>();
  expect_derivatives<Quad4, 3>();
}

// Over a closed surface, curved or not, the gradient of the volume is the force of a unit pressure.
template <class Facet, int D>
void expect_closed(ElementKind kind) {
  const Mesh mesh = bent(sample(kind));
  const Eigen::MatrixXi facets = boundary_facets(mesh);
  Eigen::MatrixXd by_volume = Eigen::MatrixXd::Zero(D, mesh.node_count()), by_normals = by_volume;
  double volume = 0;
  for (const auto& nodes : facets.colwise()) {
    const auto x = gather<Facet, D>(mesh.X, nodes.data());
    volume += Enclosed<Facet, D>::volume(x);
    const auto g = Enclosed<Facet, D>::gradient(x), f = Enclosed<Facet, D>::pressed(x);
    for (int a = 0; a < Facet::nodes; ++a) {
      by_volume.col(nodes[a]) += g.col(a);
      by_normals.col(nodes[a]) += f.col(a);
    }
  }
  EXPECT_NEAR(volume, total_measure(mesh), 1e-12) << info(kind).name;
  EXPECT_LT((by_volume - by_normals).norm(), 1e-13) << info(kind).name;
  EXPECT_GT(by_normals.norm(), 0.1);
}

TEST(Enclosed, IsTheVolumeAndItsGradientThePressure) {
  expect_closed<Tri3, 3>(ElementKind::tet4);
  expect_closed<Tri6, 3>(ElementKind::tet10);
  expect_closed<Quad4, 3>(ElementKind::hex8);
  expect_closed<Edge2, 2>(ElementKind::quad4);
  expect_closed<Edge3, 2>(ElementKind::tri6);
}

Mesh sphere_surface(double radius, int times) {
  Mesh mesh;
  mesh.kind = ElementKind::tri3;
  mesh.X.resize(3, 6);
  mesh.X << 1, -1, 0, 0, 0, 0, 0, 0, 1, -1, 0, 0, 0, 0, 0, 0, 1, -1;
  mesh.elements.resize(3, 8);
  mesh.elements << 0, 2, 1, 3, 2, 1, 3, 0, 2, 1, 3, 0, 0, 2, 1, 3, 4, 4, 4, 4, 5, 5, 5, 5;
  for (int k = 0; k < times; ++k) mesh = refine(mesh);
  for (auto x : mesh.X.colwise()) x = (radius * x.normalized()).eval();
  return mesh;
}

constexpr double radius = 0.1, thickness = 1e-3;

Scene balloon(const std::string& material, int times) {
  Scene scene;
  Body body;
  body.name = "balloon";
  body.mesh = sphere_surface(radius, times);
  body.thickness = thickness;
  body.materials = {MaterialSpec{material, 1e6, 0.45, 1000, ""}};
  body.loads.pressures = {Pressure{{}, 1, 0}};
  scene.world.gravity.setZero();
  scene.bodies = {body};
  return scene;
}

// Psi'(l) of equal stretches: U of a flat membrane of 1 m^2 and 1 m, by differences.
double stress_like(const std::string& material, double l) {
  Scene scene;
  Body body;
  body.name = "sheet";
  body.mesh = generate_sheet({1, 1}, {1, 1}, {1, 1}, ElementKind::tri3);
  body.thickness = 1;
  body.materials = {MaterialSpec{material, 1e6, 0.45, 1000, ""}};
  scene.bodies = {body};
  const System system(scene, 1);
  const Model& model = parts_of(system).model;
  const auto energy = [&](double stretch) {
    const Eigen::VectorXd x = stretch * model.X, v = Eigen::VectorXd::Zero(x.size());
    return model.elastic[0].term->energy({x, v}, *model.elastic[0].term->make_store(1));
  };
  constexpr double e = 1e-5;
  return (energy(l + e) - energy(l - e)) / (2 * e);
}

// The pressure at which a sphere of this mesh is in balance at stretch l, by virtual work of the uniform stretch.
double balancing(const System& system, double l) {
  const Model& model = parts_of(system).model;
  const Eigen::VectorXd x = l * model.X, v = Eigen::VectorXd::Zero(x.size());
  double elastic = 0, pressed = 0;
  for (const auto& term : model.terms) {
    Eigen::VectorXd f = Eigen::VectorXd::Zero(x.size());
    term->add_forces({x, v, 1, 0}, *term->make_store(1), f);
    (term->role() == Role::elastic ? elastic : pressed) += f.dot(model.X);
  }
  return -elastic / pressed;
}

TEST(Pressure, ABalloonFollowsItsCurve) {
  for (const char* material : {"stvk", "corotated", "fixed-corotated", "neo-hookean", "stable-neo-hookean"}) {
    const System system(balloon(material, 4), 1);
    for (const double l : {1.05, 1.25, 1.5, 2.0}) {
      const double right = thickness / radius * stress_like(material, l) / (l * l);
      EXPECT_NEAR(balancing(system, l) / right, 1, 0.01) << material << " " << l;
    }
  }
}

// Where p = (t/r) Psi'(l)/l^2 has its maximum up to l = 3; the end where it only grows.
TEST(Pressure, CurvesHaveTheirMaximaWhereTheSceneSaysSo) {
  const auto highest = [](const char* material) {
    double best = 0, where = 0;
    for (double l = 1.02; l <= 3; l += 0.02) {
      const double p = thickness / radius * stress_like(material, l) / (l * l);
      if (p > best) {
        best = p;
        where = l;
      }
    }
    return std::pair{where, best};
  };
  EXPECT_NEAR(highest("neo-hookean").first, 1.504, 0.011);
  EXPECT_NEAR(highest("neo-hookean").second, 5266, 1);
  EXPECT_NEAR(highest("corotated").first, 2, 0.011);
  EXPECT_NEAR(highest("corotated").second, 9091, 1);
  for (const char* growing : {"stvk", "fixed-corotated", "stable-neo-hookean"})
    EXPECT_GT(highest(growing).first, 2.97) << growing;
}

TEST(Pressure, ABalloonComesToRestOnItsCurve) {
  Scene scene = balloon("stvk", 2);
  scene.bodies[0].loads.pressures[0].value = thickness / radius * stress_like("stvk", 1.3) / (1.3 * 1.3);
  scene.bodies[0].pins = {Pin{Box{{-1, -1, radius - 1e-6}, {1, 1, 1}}, "xy", {}, {}}};
  scene.time.integrator = "backward-euler";
  scene.bodies[0].damping.alpha = 20;
  Stepped run(scene);
  run.steps(60);
  double mean = 0;
  const Eigen::Map<const Eigen::Matrix3Xd> x(run.state.x.data(), 3, run.state.x.size() / 3);
  const Vec3 middle = x.rowwise().mean();
  for (const auto& point : x.colwise()) mean += (point - middle).norm() / radius / static_cast<double>(x.cols());
  EXPECT_NEAR(mean, 1.3, 0.03);
}

TEST(Pressure, InsideOutBalloonsAreBlownUpAllTheSame) {
  Scene scene = balloon("stvk", 2);
  const double right = balancing(System(scene, 1), 1.2);
  scene.bodies[0].mesh.elements.row(0).swap(scene.bodies[0].mesh.elements.row(1));
  EXPECT_NEAR(balancing(System(scene, 1), 1.2), right, 1e-9 * right);
  std::swap(scene.bodies[0].mesh.elements(0, 3), scene.bodies[0].mesh.elements(1, 3));
  EXPECT_THROW(System(scene, 1), InputError);
}

// Each for itself, wherever it faces.
TEST(Pressure, OfTwoBalloonsInOneBodyEachIsBlownUp) {
  Scene scene = balloon("stvk", 2);
  const double right = balancing(System(scene, 1), 1.2);
  Mesh& mesh = scene.bodies[0].mesh;
  const Mesh one = mesh;
  mesh.X.conservativeResize(3, 2 * one.node_count());
  mesh.X.rightCols(one.node_count()) = one.X.colwise() + Eigen::Vector3d(1, 2, 3);
  mesh.elements.conservativeResize(3, 2 * one.element_count());
  mesh.elements.rightCols(one.element_count()) = one.elements.array() + one.node_count();
  mesh.elements.rightCols(one.element_count()).row(0).swap(mesh.elements.rightCols(one.element_count()).row(1));
  EXPECT_NEAR(balancing(System(scene, 1), 1.2), right, 1e-9 * right);
}

// Under equal pressure on all sides a solid block shrinks by p (1 - 2 nu)/E in every direction.
TEST(Pressure, PressesOnASolidFromOutside) {
  Scene scene = beam("hex8", 2, 1e6, 0.3);
  scene.world.gravity.setZero();
  scene.bodies[0].pins = {Pin{Box{{-1e-6, -1, -1}, {1e-6, 2, 2}}, "x", {}, {}},
                          Pin{Box{{-1, -1e-6, -1}, {9, 1e-6, 2}}, "y", {}, {}},
                          Pin{Box{{-1, -1, -1e-6}, {9, 2, 1e-6}}, "z", {}, {}}};
  scene.bodies[0].materials[0].model = "linear";
  scene.bodies[0].loads.pressures = {Pressure{{}, 100, 0}};
  scene.time.integrator = "static";
  scene.solver.tolerance = 1e-9;
  Stepped run(scene);
  run.steps(1);
  EXPECT_NEAR(run.tip().x(), -4 * 100 * 0.4 / 1e6, 3e-8);  // a share of p/E is not linear
}

// A cantilever whose top is pressed on bends down, and its load stays normal: it also pulls along.
TEST(Pressure, AtAFreeRimTheForceIsThatOfTheNormals) {
  Scene scene = beam("tet4", 1);
  scene.world.gravity.setZero();
  scene.bodies[0].loads.pressures = {Pressure{InGroup{"top"}, 500, 0}};
  const System system(scene, 1);
  const Model& model = parts_of(system).model;
  const Term& term = *model.terms[1];
  const Eigen::VectorXd v = Eigen::VectorXd::Zero(model.dofs());
  const Eigen::VectorXd x = model.X + random_vector(model.dofs(), 0.05, 4);
  const auto store = term.make_store(1);
  term.begin_step({x, v, 0, 0}, *store);
  Eigen::VectorXd f = v;
  term.add_forces({x, v, 0, 0}, *store, f);
  Eigen::VectorXd right = v;
  const Eigen::MatrixXi top = facets_in(model.bodies[0].mesh, InGroup{"top"});
  for (const auto& nodes : top.colwise()) {
    const Vec3 a = x.segment<3>(3 * nodes[0]), b = x.segment<3>(3 * nodes[1]), c = x.segment<3>(3 * nodes[2]);
    for (const int node : nodes) right.segment<3>(3 * node) -= 500 * (b - a).cross(c - a) / 6;
  }
  EXPECT_LT((f - right).norm(), 1e-10 * right.norm());
}

TEST(Pressure, WhereNoFacetIsTheEntryIsNamed) {
  Scene scene = beam("tet4", 1);
  scene.bodies[0].loads.pressures = {Pressure{{}, 1, 0}, Pressure{Box{{5, 5, 5}, {6, 6, 6}}, 1, 0}};
  try {
    System(scene, 1);
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_EQ(error.key, "body.0.pressure.1");
  }
}

TEST(PointForce, BendsABeamAsMuchAsTheSameLoadOnItsEnd) {
  Scene spread = beam("tet4", 1, 1e7), point = spread;
  spread.world.gravity.setZero();
  point.world.gravity.setZero();
  spread.time.integrator = point.time.integrator = "static";
  spread.bodies[0].loads.tractions = {Traction{InGroup{"right"}, {0, 0, -100}, 0}};
  point.bodies[0].loads.forces = {PointForce{{4, 0.5, 0.5}, {0, 0, -100}, 0}};
  Stepped a(spread), b(point);
  a.steps(1);
  b.steps(1);
  EXPECT_NEAR(a.tip().z() / b.tip().z(), 1, 0.02);
  EXPECT_LT(a.tip().z(), 0);
  point.bodies[0].loads.forces[0].at = {5, 0, 0};
  EXPECT_THROW(System(point, 1), InputError);
}

}  // namespace
}  // namespace sim::test
