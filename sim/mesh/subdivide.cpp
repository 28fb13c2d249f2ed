#include "sim/mesh/subdivide.h"

#include <cstdint>

namespace sim {

PointTable::PointTable(const Eigen::MatrixXd& X) : coarse_(static_cast<int>(X.cols())) {}

// FNV-1a over the pairs [Fowler, Noll & Vo].
std::size_t PointTable::Hash::operator()(const PointKey& key) const {
  std::uint64_t h = 14695981039346656037u;
  for (const auto& [node, weight] : key) {
    h = (h ^ static_cast<std::uint32_t>(node)) * 1099511628211u;
    h = (h ^ static_cast<std::uint32_t>(weight)) * 1099511628211u;
  }
  return h;
}

int PointTable::find(const PointKey& key) const {
  const auto it = numbers_.find(key);
  return it == numbers_.end() ? -1 : it->second;
}

int PointTable::add(const PointKey& key, const Vec3& X) {
  const int number = size();
  numbers_.emplace(key, number);
  added_.push_back(X);
  keys_.push_back(key);
  return number;
}

Eigen::MatrixXd PointTable::positions(const Eigen::MatrixXd& coarse) const {
  Eigen::MatrixXd X(coarse.rows(), size());
  X.leftCols(coarse_) = coarse;
  for (std::size_t i = 0; i < added_.size(); ++i) {
    for (Eigen::Index r = 0; r < X.rows(); ++r) X(r, coarse_ + static_cast<Eigen::Index>(i)) = added_[i][r];
  }
  return X;
}

Group finer_group(const Group& coarse, Eigen::MatrixXi facets, const Eigen::MatrixXi& elements, int per_element,
                  const PointTable& points) {
  Group fine;
  fine.name = coarse.name;
  fine.dimension = coarse.dimension;
  std::vector<char> member(points.size(), 0);
  for (const int n : coarse.nodes) member[n] = 1;
  if (facets.cols() == 0 && coarse.elements.empty()) {
    for (int n = points.coarse_size(); n < points.size(); ++n) {
      const PointKey& key = points.key(n);
      member[n] = std::all_of(key.begin(), key.end(), [&](const auto& k) { return k.second == 0 || member[k.first]; });
    }
  }
  for (const int n : facets.reshaped()) member[n] = 1;
  for (const int e : coarse.elements) {
    for (int c = 0; c < per_element; ++c) {
      fine.elements.push_back(e * per_element + c);
      for (const int n : elements.col(fine.elements.back())) member[n] = 1;
    }
  }
  for (int n = 0; n < points.size(); ++n) {
    if (member[n]) fine.nodes.push_back(n);
  }
  fine.facets = std::move(facets);
  return fine;
}

}  // namespace sim
