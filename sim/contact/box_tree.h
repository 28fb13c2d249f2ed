// A tree of bounding boxes over the primitives of a surface: built once from the shape at rest, its boxes refitted to
// every later one in place.
#pragma once

#include <Eigen/Geometry>
#include <span>
#include <vector>

#include "sim/math/vec3.h"

namespace sim {

using Bounds = Eigen::AlignedBox3d;

class BoxTree {
 public:
  // centres: of the items at rest
  explicit BoxTree(std::span<const Vec3> centres);

  // boxes: those of the tree, from those of the items
  void refit(std::span<const Bounds> items, std::vector<Bounds>& boxes) const;

  // Calls f(item) for every item whose leaf's box meets the query.
  template <class F>
  void visit(const std::vector<Bounds>& boxes, const Bounds& query, const F& f) const {
    for (std::size_t k = 0; k < branches_.size();) {
      const Branch& branch = branches_[k];
      if (!boxes[k].intersects(query)) {
        k = static_cast<std::size_t>(branch.next);
        continue;
      }
      for (int i = branch.first; i < branch.last; ++i) f(items_[i]);
      ++k;
    }
  }

 private:
  // Depth first: its children follow, `next` is what comes after the last of them. Leaves have items, others none.
  struct Branch {
    int first = 0, last = 0, next = 0;
  };
  void grow(std::span<const Vec3> centres, int first, int last);

  std::vector<int> items_;
  std::vector<Branch> branches_;
};

}  // namespace sim
