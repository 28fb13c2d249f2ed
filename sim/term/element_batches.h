// The elements of one region of a body, in batches of lanes: node numbers, shape gradients and weights, and the gather
// and scatter between them and the vectors of the system. The same for every material.
#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <span>
#include <vector>

#include "sim/math/block_matrix.h"
#include "sim/math/lanes.h"
#include "sim/math/mat.h"
#include "sim/term/chunks.h"

namespace sim {

// D: numbers per node; the element's own dimension M may be smaller (membranes).
template <class Element, int D>
struct ElementBatches {
  static constexpr int N = Element::nodes, M = Element::dimension, Q = static_cast<int>(Element::rule.size());

  std::vector<int> element;    // per batch and lane: number in the body's mesh; the last batch repeats its last one
  int count = 0;               // elements (the lanes beyond hold weight 0 and are not scattered)
  LargeArray<int> node;        // [batch][N][lane], node numbers of the system, rising within an element
  LargeArray<Lanes> gradient;  // [batch][Q][N-1][M]: G of nodes 1...N-1 [1/m]; node 0 has minus their sum
  LargeArray<Lanes> weight;    // [batch][Q]: w = quadrature weight x rest measure x thickness [m^3]
  std::vector<Mat<Lanes, D, D>> frame;  // [batch][Q]: rest tangents, then the normal, in columns; only where asked for
  LargeArray<int> slot;                 // [element][a <= b]: blocks of the matrix; empty where there is none
  std::unique_ptr<Chunks> chunks;

  int batch_count() const { return static_cast<int>(weight.size()) / Q; }
  int lanes_in(int batch) const { return std::min(lane_count, count - batch * lane_count); }
  const int* nodes(int batch) const { return node.data() + static_cast<std::size_t>(batch) * N * lane_count; }
  const int* slots(int batch) const {
    return slot.data() + static_cast<std::size_t>(batch) * lane_count * N * (N + 1) / 2;
  }
  const Lanes* G(int batch, int q) const {
    return gradient.data() + (static_cast<std::size_t>(batch) * Q + q) * (N - 1) * M;
  }
  const Lanes& w(int batch, int q) const { return weight[static_cast<std::size_t>(batch) * Q + q]; }

  // Positions of nodes 1...N-1 relative to node 0, so that a body far from the origin loses no digits.
  void gather(int batch, const double* x, Lanes (&relative)[N - 1][D]) const {
    const int* n = nodes(batch);
    for (int c = 0; c < D; ++c) {
      const Lanes origin([&](int k) { return x[n[k] * D + c]; });
      for (int a = 1; a < N; ++a)
        relative[a - 1][c] = Lanes([&](int k) { return x[n[a * lane_count + k] * D + c]; }) - origin;
    }
  }

  // F = x_e G
  static Mat<Lanes, D, M> deformation(const Lanes (&x)[N - 1][D], const Lanes* G) {
    Mat<Lanes, D, M> F;
    for (int c = 0; c < D; ++c)
      for (int m = 0; m < M; ++m) {
        Lanes sum = x[0][c] * G[m];
        for (int a = 1; a < N - 1; ++a) sum += x[a][c] * G[a * M + m];
        F(c, m) = sum;
      }
    return F;
  }

  // f_a += s P G_a^T, a = 1...N-1
  static void accumulate(const Mat<Lanes, D, M>& P, const Lanes* G, const Lanes& s, Lanes (&f)[N - 1][D]) {
    for (int a = 0; a < N - 1; ++a)
      for (int c = 0; c < D; ++c) {
        Lanes sum = P(c, 0) * G[a * M];
        for (int m = 1; m < M; ++m) sum += P(c, m) * G[a * M + m];
        f[a][c] += s * sum;
      }
  }

  // y += the lanes' f, node by node; node 0 gets minus the sum of the others.
  void scatter(int batch, const Lanes (&f)[N - 1][D], double* y) const {
    const int* n = nodes(batch);
    const int lanes = lanes_in(batch);
    for (int c = 0; c < D; ++c) {
      Lanes rest = -f[0][c];
      for (int a = 1; a < N - 1; ++a) rest -= f[a][c];
      for (int k = 0; k < lanes; ++k) y[n[k] * D + c] += rest[k];
      for (int a = 1; a < N; ++a)
        for (int k = 0; k < lanes; ++k) y[n[a * lane_count + k] * D + c] += f[a - 1][c][k];
    }
  }

  // Calls f(span of node numbers) for every element.
  template <class F>
  void for_each_element(const F& f) const {
    std::array<int, N> own;
    for (int e = 0; e < count; ++e) {
      const int* n = nodes(e / lane_count);
      for (int a = 0; a < N; ++a) own[a] = n[a * lane_count + e % lane_count];
      f(std::span<const int>(own));
    }
  }

  void bind(const BlockPattern& pattern) {
    slot.clear();
    for_each_element([&](std::span<const int> own) {
      for (int a = 0; a < N; ++a)
        for (int b = a; b < N; ++b) slot.push_back(pattern.slot(own[a], own[b]));
    });
  }
};

}  // namespace sim
