#include "sim/mesh/tangle.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "sim/element/element.h"

namespace sim {

namespace {

// The corners that share an edge of the element with corner `a`.
std::vector<int> neighbours(const ElementInfo& element, int a) {
  std::vector<int> others;
  for (const auto& [i, j, middle] : element.edges) {
    if (i == a) others.push_back(j);
    if (j == a) others.push_back(i);
  }
  return others;
}

// Elements close a ring around an edge or node when each of their sides there is a side of two of them.
template <class Wedge>
bool is_closed(const std::vector<Wedge>& around) {
  std::map<int, int> uses;
  for (const Wedge& w : around) {
    ++uses[w.p];
    ++uses[w.q];
  }
  return std::all_of(uses.begin(), uses.end(), [](const auto& use) { return use.second == 2; });
}

}  // namespace

Eigen::Vector3d Tangle::at(const Eigen::VectorXd& x, int node) const {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  point.head(D_) = x.segment(static_cast<Eigen::Index>(node) * D_, D_);
  return point;
}

double Tangle::angle(const Eigen::VectorXd& x, const Wedge& w) const {
  const Eigen::Vector3d a = at(x, w.a);
  const Eigen::Vector3d axis = D_ == 2 ? Eigen::Vector3d::UnitZ().eval() : (at(x, w.b) - a).stableNormalized().eval();
  const Eigen::Vector3d p = at(x, w.p) - a, q = at(x, w.q) - a;
  const Eigen::Vector3d p_across = p - axis.dot(p) * axis, q_across = q - axis.dot(q) * axis;
  return std::atan2(axis.dot(p_across.cross(q_across)), p_across.dot(q_across));
}

double Tangle::volume(const Eigen::VectorXd& x, const Wedge& w) const {
  const Eigen::Vector3d a = at(x, w.a), p = at(x, w.p) - a, q = at(x, w.q) - a;
  return D_ == 2 ? p.cross(q).z() : (at(x, w.b) - a).dot(p.cross(q));
}

Tangle::Tangle(const Mesh& mesh, const Component& part, int first_node, int D) : D_(D), start_{0} {
  const ElementInfo& element = info(mesh.kind);
  if (element.dimension < D) return;
  Eigen::VectorXd X = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(first_node + mesh.node_count()) * D);
  X.tail(mesh.X.size()) = mesh.X.reshaped();
  std::map<std::pair<int, int>, std::vector<Wedge>> rings;
  for (const int e : part.elements) {
    const auto node = [&](int local) { return first_node + mesh.elements(local, e); };
    for (int a = 0; a < element.corners; ++a) {
      const std::vector<int> others = neighbours(element, a);
      for (std::size_t k = 0; k < (D == 2 ? 1 : others.size()); ++k) {
        Wedge w{node(a), node(a), node(others[0]), node(others[1])};
        if (D == 3) w = {node(a), node(others[k]), node(others[(k + 1) % 3]), node(others[(k + 2) % 3])};
        if (volume(X, w) < 0) std::swap(w.p, w.q);
        if (k == 0) corners_.push_back(w);
        if (w.a <= w.b) rings[{w.a, w.b}].push_back(w);
      }
    }
    corners_of_element_.push_back(element.corners);
  }
  for (const auto& [place, around] : rings) {
    if (!is_closed(around)) continue;
    wedges_.insert(wedges_.end(), around.begin(), around.end());
    start_.push_back(static_cast<int>(wedges_.size()));
  }
}

Tangle::Count Tangle::count(const Eigen::VectorXd& x) const {
  Count count;
  const Wedge* corner = corners_.data();
  for (const int n : corners_of_element_) {
    if (std::any_of(corner, corner + n, [&](const Wedge& w) { return !(volume(x, w) > 0); })) ++count.inverted;
    corner += n;
  }
  for (std::size_t k = 0; k + 1 < start_.size(); ++k) {
    double sum = 0;
    for (int w = start_[k]; w < start_[k + 1]; ++w) sum += angle(x, wedges_[w]);
    if (!(std::abs(sum - 2 * std::numbers::pi) < 1)) ++count.wound;
  }
  return count;
}

}  // namespace sim
