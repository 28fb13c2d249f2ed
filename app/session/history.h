// The states before the last steps, to step back to.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "sim/state.h"

namespace app {

// Holds as many states as its memory does, at least 2; older ones are forgotten. How many is decided by sizes alone, so
// a replay steps back as far as the session did.
class History {
 public:
  static constexpr std::size_t bytes = std::size_t{256} << 20;
  static constexpr std::size_t most = 2000;

  void push(const sim::State& state);
  // The state that was pushed last, which is forgotten; none when nothing is held.
  std::optional<sim::State> pop();
  void clear() { count_ = 0; }
  std::size_t size() const { return count_; }

  // Calls f(state) for every state that is held.
  template <class F>
  void for_each(const F& f) {
    for (std::size_t k = 0; k < count_; ++k) f(ring_[(first_ + k) % ring_.size()]);
  }

 private:
  std::vector<sim::State> ring_;  // memory is kept and written over
  std::size_t first_ = 0, count_ = 0;
};

}  // namespace app
