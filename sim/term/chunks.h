// Batches of elements in chunks, chunks in colours: two chunks of one colour share no node, so threads may scatter into
// nodes and matrix blocks at once, and every sum is taken in the same order whatever the number of threads.
#pragma once

#include <span>
#include <vector>

namespace sim {

class Chunks {
 public:
  // nodes: entries per batch x batches, node numbers below node_count (a batch may name a node more than once).
  Chunks(std::span<const int> nodes, int entries_per_batch, int node_count);

  int batch_count() const { return batch_start_.back(); }

  // Calls f(batch) for every batch.
  template <class F>
  void for_each_batch(int threads, const F& f) const {
#pragma omp parallel num_threads(threads)
    for (std::size_t colour = 0; colour + 1 < colour_start_.size(); ++colour) {
#pragma omp for schedule(dynamic)
      for (int k = colour_start_[colour]; k < colour_start_[colour + 1]; ++k)
        for (int batch = batch_start_[chunk_[k]]; batch < batch_start_[chunk_[k] + 1]; ++batch) f(batch);
    }
  }

 private:
  std::vector<int> batch_start_;   // chunk c holds batches batch_start_[c] ... batch_start_[c+1]-1
  std::vector<int> colour_start_;  // colour k holds chunk_[colour_start_[k]] ... chunk_[colour_start_[k+1]-1]
  std::vector<int> chunk_;
};

}  // namespace sim
