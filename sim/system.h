// The discrete system M v' = -grad U(x): built once from a scene, then const.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "sim/scene.h"
#include "sim/state.h"

namespace sim {

// Where a body's nodes and elements lie in the system's numbering.
struct BodyRange {
  std::string name;
  int first_node = 0, node_count = 0;
  int first_element = 0, element_count = 0;
  double size = 0;             // longest side of the rest bounding box, m
  const Mesh* mesh = nullptr;  // rest mesh, owned by the system; node and element numbers are the body's own
};

// One line of `ritz explain`: a term of the energy that this scene has.
struct TermInfo {
  std::string name;  // "elastic beam stable-neo-hookean tet4"
  std::string what;  // "1536 elements, 1536 points", "81 nodes"
};

// Energies [J], momenta [kg m/s, kg m^2/s about the origin].
struct Measures {
  double kinetic = 0, elastic = 0, potential = 0;  // potential: gravity, tractions, springs, obstacles
  Vec3 p = {0, 0, 0}, L = {0, 0, 0};
};

enum class Quantity {
  stress,
  stretch,
  energy,
  J
};  // von Mises Cauchy stress [Pa], largest principal stretch, Psi [J/m^3], det F

struct Counts {
  int nodes = 0, elements = 0, dofs = 0, free_dofs = 0;
  std::int64_t nonzeros = 0;  // of the matrix; 0 when the scene forms none
  std::int64_t bytes = 0;     // estimate of the memory a run needs
};

class System {
 public:
  // Throws InputError (with the key at fault) when the scene cannot be built.
  explicit System(const Scene& scene, int threads = 1);
  ~System();
  System(System&&) noexcept;

  int dimension() const;        // numbers per node: 2 or 3
  double step_seconds() const;  // h
  int steps_per_frame() const;
  double time(std::int64_t step) const;  // step / (fps * substeps), exact at frames
  std::span<const BodyRange> bodies() const;
  std::vector<TermInfo> terms() const;
  std::vector<std::string> remarks() const;  // what a user should know: locking, steps chosen, re-oriented elements
  Counts counts() const;
  double stable_step() const;  // largest stable h of the explicit schemes at rest [s]
  State initial_state() const;
  Measures measure(const State& state) const;
  // Position of probe k, dimension numbers (the third is 0 in 2D), and its displacement from rest.
  Vec3 probe_position(const State& state, int probe) const;
  Vec3 probe_displacement(const State& state, int probe) const;
  // One value per node of the system: element values averaged with the rest measure as weight.
  Eigen::VectorXd node_values(const State& state, Quantity quantity) const;
  std::vector<int> pinned_nodes(double t) const;

  struct Parts;  // what terms, solvers and steppers share: sim/parts.h
  const Parts& parts() const { return *parts_; }

 private:
  std::unique_ptr<Parts> parts_;
};

}  // namespace sim
