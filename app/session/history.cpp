#include "app/session/history.h"

#include <algorithm>

namespace app {
namespace {

// Of the nine vectors that a state may hold.
std::size_t capacity_for(const sim::State& state) {
  constexpr std::size_t vectors = 9;
  const std::size_t each =
      std::max<std::size_t>(1, vectors * sizeof(double) * static_cast<std::size_t>(state.x.size()));
  return std::clamp<std::size_t>(History::bytes / each, 2, History::most);
}

}  // namespace

void History::push(const sim::State& state) {
  const std::size_t capacity = capacity_for(state);
  if (count_ == 0 && ring_.size() != capacity) {
    ring_.clear();
    ring_.resize(capacity);
    first_ = 0;
  }
  ring_[(first_ + count_) % ring_.size()] = state;
  if (count_ < ring_.size()) {
    ++count_;
  } else {
    first_ = (first_ + 1) % ring_.size();
  }
}

std::optional<sim::State> History::pop() {
  if (count_ == 0) return std::nullopt;
  --count_;
  return ring_[(first_ + count_) % ring_.size()];
}

}  // namespace app
