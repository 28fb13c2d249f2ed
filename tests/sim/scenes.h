// Small scenes for the tests of the simulator.
#pragma once

#include <random>

#include "sim/build/parts.h"
#include "sim/element/element.h"
#include "sim/mesh/generate.h"
#include "sim/mesh/locate.h"
#include "sim/stepper.h"

namespace sim::test {

// Moves interior nodes of a generated mesh about, so that nothing is right by symmetry. Straight edges stay straight.
inline void disturb(Mesh& mesh, double amount, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-amount, amount);
  const ElementInfo& element = info(mesh.kind);
  const Eigen::VectorXd low = mesh.X.rowwise().minCoeff(), high = mesh.X.rowwise().maxCoeff();
  std::vector<bool> corner(mesh.node_count());
  for (int e = 0; e < mesh.element_count(); ++e)
    for (int a = 0; a < element.corners; ++a) corner[mesh.elements(a, e)] = true;
  for (int i = 0; i < mesh.node_count(); ++i)
    for (int c = 0; c < mesh.dimension(); ++c) {
      const bool inside = mesh.X(c, i) > low[c] + 1e-12 && mesh.X(c, i) < high[c] - 1e-12;
      if (corner[i] && inside) mesh.X(c, i) += uniform(random);
    }
  for (int e = 0; e < mesh.element_count(); ++e)
    for (const auto& [a, b, middle] : element.edges)
      if (middle >= 0)
        mesh.X.col(mesh.elements(middle, e)) = (mesh.X.col(mesh.elements(a, e)) + mesh.X.col(mesh.elements(b, e))) / 2;
}

struct Kind {
  const char* element;
  bool membrane;
};
inline constexpr Kind kinds[] = {{"tri3", false}, {"tri6", false}, {"quad4", false}, {"tri3", true},
                                 {"tri6", true},  {"tet4", false}, {"tet10", false}, {"hex8", false}};
inline constexpr const char* models[] = {"linear",          "corotated",   "stvk",
                                         "fixed-corotated", "neo-hookean", "stable-neo-hookean"};

// One free body of a few irregular elements, no gravity.
inline Scene free_body(const Kind& kind, const std::string& model, int cells = 2) {
  Scene scene;
  const ElementKind element = find_element(kind.element)->kind;
  Body body;
  body.name = "body";
  if (info(element).dimension == 3) {
    body.mesh = generate_box({1.2, 1, 0.9}, {cells, cells, cells}, {1, 1, 1}, element);
  } else if (kind.membrane) {
    body.mesh = generate_sheet({1.2, 1}, {cells, cells}, {1, 1}, element);
    body.thickness = 0.1;
  } else {
    body.mesh = generate_rectangle({1.2, 1}, {cells, cells}, {1, 1}, element);
    scene.dimension = 2;
  }
  disturb(body.mesh, 0.12 / cells, 7);
  body.materials = {MaterialSpec{model, 1e5, 0.3, 1000, ""}};
  scene.world.gravity = {0, 0, 0};
  scene.bodies = {body};
  return scene;
}

inline Eigen::VectorXd random_vector(Eigen::Index n, double amount, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-amount, amount);
  Eigen::VectorXd v(n);
  for (Eigen::Index i = 0; i < n; ++i) v[i] = uniform(random);
  return v;
}

}  // namespace sim::test
