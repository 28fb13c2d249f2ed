// The discrete system M v' = -grad U(x): built once from a scene, then const.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sim/body/body_range.h"
#include "sim/contact/contact_report.h"
#include "sim/mesh/input_error.h"
#include "sim/report.h"
#include "sim/scene.h"
#include "sim/state.h"

namespace sim {

struct Parts;  // sim/build/parts.h

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
  // The numbers of the nodes of bodies, in front of those of obstacles: of positions or velocities.
  Eigen::Ref<const Eigen::VectorXd> of_bodies(const Eigen::VectorXd& all) const;
  double mass(std::size_t body) const;  // kg
  std::vector<TermInfo> terms() const;
  // Where an obstacle of the scene is, none after its release.
  std::optional<ObstacleShape> obstacle(const State& state, std::size_t k) const;
  // Every pair of bodies that may touch, and how many there are: none where the scene names no contact.
  int contact_pairs() const;
  std::vector<ContactReport> contacts(const State& state) const;
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

  // For steppers and for what studies a system from outside.
  friend const Parts& parts_of(const System& system);

 private:
  std::unique_ptr<Parts> parts_;
};

// Where and why a step could not be taken: "step 12, t = 0.2 s, element 7: the forces are not finite".
std::string failure_text(const System& system, const StepReport& report);

}  // namespace sim
