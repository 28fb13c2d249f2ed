#include "sim/contact/box_tree.h"

#include <algorithm>
#include <numeric>

namespace sim {

namespace {

constexpr int leaf_size = 4;

}  // namespace

BoxTree::BoxTree(std::span<const Vec3> centres) : items_(centres.size()) {
  std::iota(items_.begin(), items_.end(), 0);
  if (!centres.empty()) grow(centres, 0, static_cast<int>(centres.size()));
}

// Halves at the median along the longest side; equal places are told apart by their numbers.
void BoxTree::grow(std::span<const Vec3> centres, int first, int last) {
  const std::size_t own = branches_.size();
  branches_.push_back({first, last, 0});
  if (last - first > leaf_size) {
    Bounds bounds;
    for (int i = first; i < last; ++i) bounds.extend(centres[items_[i]]);
    int axis;
    bounds.sizes().maxCoeff(&axis);
    const int middle = (first + last) / 2;
    std::nth_element(items_.begin() + first, items_.begin() + middle, items_.begin() + last,
                     [&](int a, int b) { return std::pair(centres[a][axis], a) < std::pair(centres[b][axis], b); });
    branches_[own] = {};
    grow(centres, first, middle);
    grow(centres, middle, last);
  }
  branches_[own].next = static_cast<int>(branches_.size());
}

void BoxTree::refit(std::span<const Bounds> items, std::vector<Bounds>& boxes) const {
  boxes.resize(branches_.size());
  for (std::size_t k = branches_.size(); k-- > 0;) {
    const Branch& branch = branches_[k];
    boxes[k].setEmpty();
    for (int i = branch.first; i < branch.last; ++i) boxes[k].extend(items[items_[i]]);
    if (branch.first < branch.last) continue;
    const std::size_t left = k + 1, right = static_cast<std::size_t>(branches_[left].next);
    boxes[k] = boxes[left].merged(boxes[right]);
  }
}

}  // namespace sim
