#include "sim/study/sample.h"

#include "sim/build/parts.h"
#include "sim/element/element.h"
#include "sim/fill/carry.h"
#include "sim/mesh/input_error.h"
#include "sim/mesh/locate.h"

namespace sim {
namespace {

// Where the point is at rest; z = 0 in 2D.
Vec3 at(const SamplePoints& points, int p) {
  Vec3 X = Vec3::Zero();
  X.head(points.dimension) = points.X.col(p);
  return X;
}

std::optional<MaterialPoint> place_in(const Mesh& mesh, const Vec3& X, bool or_near) {
  constexpr double far = 4;  // heights of its element
  if (auto place = locate(mesh, X)) return place;
  if (!or_near || !info(mesh.kind).simplex() || info(mesh.kind).dimension != 3) return std::nullopt;
  const std::vector<MaterialPoint> near = carry(mesh, X);
  if (farthest_outside(near) > far) return std::nullopt;
  return near.front();
}

}  // namespace

SamplePoints sample_points(const System& system) {
  const Model& model = parts_of(system).model;
  SamplePoints points;
  points.dimension = model.D;
  points.X = Eigen::Map<const Eigen::MatrixXd>(model.X.data(), model.D, model.body_nodes);
  points.mass.resize(model.body_nodes);
  points.size.resize(model.body_nodes);
  for (std::size_t b = 0; b < model.ranges.size(); ++b) {
    const BodyRange& range = model.ranges[b];
    Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(model.dofs());
    model.masses[b].add_diagonal(1, diagonal, model.D);
    for (int i = range.first_node; i < range.first_node + range.node_count; ++i) {
      points.mass[i] = diagonal[static_cast<Eigen::Index>(i) * model.D];
      points.size[i] = range.size;
      points.body.push_back(static_cast<int>(b));
    }
    auto shares = points.mass.segment(range.first_node, range.node_count);
    shares *= model.masses[b].total() / shares.sum();
  }
  return points;
}

Sampler::Sampler(const System& system, const SamplePoints& points) : dimension_(system.dimension()) {
  std::vector<int> first(system.bodies().size(), -1);  // sample point of each body
  for (int p = 0; p < points.count(); ++p) {
    const int b = points.body[p];
    if (first[b] < 0) first[b] = p;
    const BodyRange& range = system.bodies()[b];
    const Mesh& mesh = *range.mesh;
    const int same = p - first[b];  // refinement keeps the numbers of nodes
    if (same < mesh.node_count() && mesh.X.col(same) == points.X.col(p)) {
      node_.push_back(range.first_node + same);
      weight_.push_back(1);
    } else {
      const auto place = place_in(mesh, at(points, p), points.ride_on_nearest);
      if (!place)
        throw InputError("body." + std::to_string(b) + ".mesh", "a point of the scene's mesh lies in no element of it");
      for (std::size_t a = 0; a < place->weights.size(); ++a) {
        node_.push_back(range.first_node + mesh.elements(static_cast<Eigen::Index>(a), place->element));
        weight_.push_back(place->weights[a]);
      }
    }
    start_.push_back(static_cast<int>(node_.size()));
  }
}

Eigen::VectorXd Sampler::positions(const State& state) const {
  const Eigen::Map<const Eigen::MatrixXd> x(state.x.data(), dimension_, state.x.size() / dimension_);
  Eigen::MatrixXd sampled = Eigen::MatrixXd::Zero(dimension_, static_cast<Eigen::Index>(start_.size()) - 1);
  for (Eigen::Index p = 0; p < sampled.cols(); ++p)
    for (int k = start_[p]; k < start_[p + 1]; ++k) sampled.col(p) += weight_[k] * x.col(node_[k]);
  return sampled.reshaped();
}

}  // namespace sim
