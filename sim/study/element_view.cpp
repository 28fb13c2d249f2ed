#include "sim/study/element_view.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "sim/element/list.h"
#include "sim/material/lame.h"
#include "sim/material/list.h"
#include "sim/math/svd.h"
#include "sim/mesh/geometry.h"
#include "sim/mesh/input_error.h"
#include "sim/mesh/locate.h"
#include "sim/mesh/region.h"

namespace sim {

namespace {

// The last material that names a group with this element, else the body's own.
const MaterialSpec& material_of(const Body& body, int number) {
  for (std::size_t m = body.materials.size(); m-- > 1;) {
    const Group group = find_group(body.mesh, {body.materials[m].group}, GroupPart::elements);
    if (std::binary_search(group.elements.begin(), group.elements.end(), number)) return body.materials[m];
  }
  return body.materials.front();
}

// Calls f(material, std::integral_constant<int, D>{}) for the material of the element.
template <class F>
void visit_material(const Body& body, int number, const F& f) {
  const Mesh& mesh = body.mesh;
  const bool plane = mesh.kind == ElementKind::tri3 && mesh.dimension() == 2;
  if (!plane && mesh.kind != ElementKind::tet4)
    throw InputError("element", "only tri3 in the plane and tet4 can be looked into");
  if (number < 0 || number >= mesh.element_count())
    throw InputError("element", "the body has elements 0 to " + std::to_string(mesh.element_count() - 1));
  const MaterialSpec& spec = material_of(body, number);
  const Lame constants = lame(spec.young, spec.poisson, false);
  for_each_type(Materials{}, [&]<class Material>(std::type_identity<Material>) {
    if (Material::name != spec.model) return;
    if (plane)
      f(Material(constants, 2), std::integral_constant<int, 2>{});
    else
      f(Material(constants, 3), std::integral_constant<int, 3>{});
  });
}

template <int R, int C>
Mat<double, R, C> to_mat(const Eigen::MatrixXd& A) {
  Mat<double, R, C> B;
  for (int i = 0; i < R; ++i)
    for (int j = 0; j < C; ++j) B(i, j) = A(i, j);
  return B;
}
template <int R, int C>
Eigen::MatrixXd to_eigen(const Mat<double, R, C>& A) {
  Eigen::MatrixXd B(R, C);
  for (int i = 0; i < R; ++i)
    for (int j = 0; j < C; ++j) B(i, j) = A(i, j);
  return B;
}

// Edges from the first node, in columns.
Eigen::MatrixXd edges(const Eigen::MatrixXd& x) {
  return x.rightCols(x.cols() - 1).colwise() - x.col(0);
}

// Rest geometry and F; what follows from the material is filled in later.
ElementView geometry(const Body& body, int number, const Eigen::MatrixXd& x) {
  const Mesh& mesh = body.mesh;
  ElementView view;
  view.X.resize(mesh.dimension(), mesh.elements.rows());
  for (Eigen::Index a = 0; a < view.X.cols(); ++a) view.X.col(a) = mesh.X.col(mesh.elements(a, number));
  view.x = x;
  view.Dm = edges(view.X);
  view.Dm_inverse = view.Dm.inverse();
  view.Ds = edges(x);
  const bool plane = mesh.dimension() == 2;
  view.measure = std::abs(view.Dm.determinant()) / (plane ? 2 : 6) * (plane ? body.thickness : 1);
  view.F = view.Ds * view.Dm_inverse;
  return view;
}

}  // namespace

ElementView view_element(const Body& body, int number, const Eigen::MatrixXd& x) {
  ElementView view;
  visit_material(body, number, [&]<int D>(const auto& material, std::integral_constant<int, D>) {
    view = geometry(body, number, x);
    const Mat<double, D, D> F = to_mat<D, D>(view.F);
    const Svd<double, D, D> s = svd(F);
    view.U = to_eigen(s.U);
    view.V = to_eigen(s.V);
    view.stretches = Eigen::Map<const Eigen::VectorXd>(s.s, D);
    view.J = determinant(F);
    view.psi = material.psi(F);
    view.P = to_eigen(material.P(F));
  });
  const Eigen::MatrixXd others = -view.measure * view.P * view.Dm_inverse.transpose();
  view.f.resize(view.x.rows(), view.x.cols());
  view.f.rightCols(others.cols()) = others;
  view.f.col(0) = -others.rowwise().sum();
  view.force_sum = view.f.rowwise().sum();
  Vec3 torque = Vec3::Zero();
  for (Eigen::Index a = 0; a < view.x.cols(); ++a) {
    Vec3 arm = Vec3::Zero(), force = Vec3::Zero();
    arm.head(view.x.rows()) = view.x.col(a);
    force.head(view.x.rows()) = view.f.col(a);
    torque += arm.cross(force);
  }
  view.torque = view.x.rows() == 2 ? torque.z() : torque.norm();
  return view;
}

Eigen::MatrixXd element_stiffness(const Body& body, int number, const Eigen::MatrixXd& x, Definiteness fix) {
  Eigen::MatrixXd K;
  visit_material(body, number, [&]<int D>(const auto& material, std::integral_constant<int, D>) {
    const ElementView view = geometry(body, number, x);
    Mat<double, D, D> P;
    Tangent<double, D, D> tangent;
    material.linearise(to_mat<D, D>(view.F), P, tangent);
    make_definite(tangent, fix);
    // Rows of G: the gradients of the shape functions; r = V^T G.
    Eigen::MatrixXd G(D + 1, D);
    G.bottomRows(D) = view.Dm_inverse;
    G.row(0) = -view.Dm_inverse.colwise().sum();
    const Eigen::MatrixXd r = G * to_eigen(tangent.V);
    K.resize((D + 1) * D, (D + 1) * D);
    for (int a = 0; a <= D; ++a)
      for (int b = 0; b <= D; ++b) {
        const Eigen::VectorXd ra = view.measure * r.row(a).transpose(), rb = r.row(b).transpose();
        K.block(a * D, b * D, D, D) = to_eigen(stiffness_block<double, D, D>(tangent, ra.data(), rb.data()));
      }
  });
  return K;
}

Eigen::MatrixXd element_nodes(const Mesh& mesh, int number, int first_node, const Eigen::VectorXd& x) {
  const Eigen::Index D = mesh.dimension();
  Eigen::MatrixXd nodes(D, mesh.elements.rows());
  for (Eigen::Index a = 0; a < nodes.cols(); ++a)
    nodes.col(a) = x.segment((first_node + mesh.elements(a, number)) * D, D);
  return nodes;
}

}  // namespace sim
