// The body that an exhibit is about, by its number in the system.
#pragma once

#include "app/scene/exhibits.h"
#include "sim/scene.h"
#include "sim/state.h"
#include "sim/system.h"

namespace app {

// Keeps a copy of the scene with that body alone: the exhibit may outlive the document that it was made from.
class ExhibitBody {
 public:
  // The body that the exhibit names, else the first. Throws sim::InputError (key "body") when there is none.
  explicit ExhibitBody(const ExhibitInput& input);

  int dimension() const { return scene_.dimension; }
  const sim::Body& body() const { return scene_.bodies[0]; }
  const sim::Mesh& mesh() const { return body().mesh; }
  const sim::BodyRange& range() const { return system_.bodies()[number_]; }
  const sim::System& system() const { return system_; }
  const sim::Scene& alone() const { return scene_; }
  std::size_t number() const { return number_; }
  double time(const sim::State& state) const { return system_.time(state.step); }
  // Positions of the body's nodes, D x nodes; velocities likewise.
  Eigen::MatrixXd nodes(const Eigen::VectorXd& x) const;
  // The same, with zeros at the nodes that are pinned: forces there are those of the pins, and much larger.
  Eigen::MatrixXd free_nodes(const Eigen::VectorXd& f, const sim::State& state) const;
  Eigen::MatrixXd element_nodes(int element, const sim::State& state) const;

 private:
  const sim::System& system_;
  std::size_t number_ = 0;
  sim::Scene scene_;
};

}  // namespace app
