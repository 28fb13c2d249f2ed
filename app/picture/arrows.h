// Arrows for forces and velocities: neighbouring nodes of a body are joined to a few dozen places, so that a fine mesh
// has no more arrows than a coarse one.
#pragma once

#include <vector>

#include "app/scene/document.h"
#include "render/frame.h"
#include "sim/system.h"

namespace app {

class Arrows {
 public:
  // The first two arguments must outlive it; arrows are relative to the origin.
  Arrows(const sim::System& system, const Document& document, const Vec3& origin = Vec3::Zero());

  // Adds the arrows that the look asks for.
  void add(const sim::State& state, std::vector<render::Arrow>& arrows) const;

 private:
  using Place = std::vector<int>;  // nodes of the system

  void add_forces(const sim::State& state, const Eigen::VectorXd& forces, const render::Colour& colour,
                  std::vector<render::Arrow>& arrows) const;
  void add_velocities(const sim::State& state, std::vector<render::Arrow>& arrows) const;
  Vec3 at(const Eigen::VectorXd& x, int node) const;

  const sim::System& system_;
  const Look& look_;
  Vec3 origin_;
  std::vector<std::vector<Place>> places_, on_surface_;  // body by body: of all nodes, of those of the surface
  double force_scale_ = 0;                               // m/N
  double velocity_scale_ = 0;                            // s
};

}  // namespace app
