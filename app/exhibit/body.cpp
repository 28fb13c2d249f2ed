#include "app/exhibit/body.h"

#include "sim/mesh/input_error.h"
#include "sim/study/element_view.h"

namespace app {

ExhibitBody::ExhibitBody(const ExhibitInput& input) : system_(input.system), scene_(input.scene) {
  if (!input.spec.body.empty()) {
    while (number_ < scene_.bodies.size() && scene_.bodies[number_].name != input.spec.body) ++number_;
    if (number_ == scene_.bodies.size()) throw sim::InputError("body", "there is no body of this name");
  }
  if (scene_.bodies.empty()) throw sim::InputError("kind", "is about a body, and there is none");
  scene_.bodies = {scene_.bodies[number_]};
  scene_.springs.clear();
  scene_.probes.clear();
}

Eigen::MatrixXd ExhibitBody::nodes(const Eigen::VectorXd& x) const {
  const int D = dimension();
  return x.segment(Eigen::Index{D} * range().first_node, Eigen::Index{D} * range().node_count)
      .reshaped(D, range().node_count);
}

Eigen::MatrixXd ExhibitBody::free_nodes(const Eigen::VectorXd& f, const sim::State& state) const {
  Eigen::MatrixXd all = nodes(f);
  for (const int node : system_.pinned_nodes(time(state))) {
    const int own = node - range().first_node;
    if (own >= 0 && own < range().node_count) all.col(own).setZero();
  }
  return all;
}

Eigen::MatrixXd ExhibitBody::element_nodes(int element, const sim::State& state) const {
  return sim::element_nodes(mesh(), element, range().first_node, state.x);
}

}  // namespace app
