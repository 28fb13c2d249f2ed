// Bodies that go through each other, as no contact names them.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "sim/contact/crossing.h"
#include "sim/system.h"

namespace sim {

class Overlap {
 public:
  // The pairs of bodies that no contact of the system names; with itself a body may always overlap.
  explicit Overlap(const System& system);
  Overlap(const Overlap&) = delete;

  // Two of them whose surfaces cross at this state.
  std::optional<std::pair<std::string, std::string>> find(const State& state) const;

 private:
  std::vector<Couple> couples_;
  Skin skin_;                       // empty without couples
  std::vector<std::string> names_;  // of the skin's parts
  BroadPhase broad_phase_;
};

}  // namespace sim
