// One linear simplex looked into: every quantity on the way from its nodes to their forces, in the lecture's letters.
//   D_m, D_s: edges from node 1 at rest and now; F = D_s D_m^-1; P = dPsi/dF; [f_2 f_3 (f_4)] = -P D_m^-T V
#pragma once

#include <Eigen/Core>

#include "sim/material/tangent.h"
#include "sim/scene.h"

namespace sim {

struct ElementView {
  Eigen::MatrixXd X, x;  // m, D x nodes
  Eigen::MatrixXd Dm, Dm_inverse, Ds;
  double measure = 0;         // m^3: V, with the thickness
  Eigen::MatrixXd F, P;       // P in Pa
  double J = 1, psi = 0;      // psi in J/m^3
  Eigen::MatrixXd U, V;       // F = U diag(stretches) V^T, rotations
  Eigen::VectorXd stretches;  // signed: the last one has the sign of J
  Eigen::MatrixXd f;          // N, D x nodes
  Eigen::VectorXd force_sum;  // N
  double torque = 0;          // N m about the origin: its length in space, signed in the plane

  double energy() const { return measure * psi; }
};

// Element `number` of the body with its nodes at x (D x nodes). Throws InputError (key "element") where the body's
// elements are not tri3 in the plane or tet4, or where there is none of that number.
ElementView view_element(const Body& body, int number, const Eigen::MatrixXd& x);

// The element's stiffness, D numbers per node, with the eigenvalues of dP/dF made definite.
Eigen::MatrixXd element_stiffness(const Body& body, int number, const Eigen::MatrixXd& x, Definiteness fix);

// Positions of the element's nodes in a vector of the system, D x nodes.
Eigen::MatrixXd element_nodes(const Mesh& mesh, int number, int first_node, const Eigen::VectorXd& x);

}  // namespace sim
