#include "sim/term/chunks.h"

#include <algorithm>

namespace sim {

namespace {

// Greedy colouring: each chunk takes the first colour that no chunk before it with a common node has.
std::vector<int> colours(std::span<const int> nodes, int entries, const std::vector<int>& batch_start, int node_count) {
  const int chunks = static_cast<int>(batch_start.size()) - 1;
  std::vector<std::vector<int>> at_node(node_count);  // colours met at each node
  std::vector<int> colour(chunks), seen;
  for (int c = 0; c < chunks; ++c) {
    const auto mine = nodes.subspan(static_cast<std::size_t>(batch_start[c]) * entries,
                                    static_cast<std::size_t>(batch_start[c + 1] - batch_start[c]) * entries);
    seen.clear();
    for (const int node : mine) seen.insert(seen.end(), at_node[node].begin(), at_node[node].end());
    std::sort(seen.begin(), seen.end());
    seen.erase(std::unique(seen.begin(), seen.end()), seen.end());
    int k = 0;
    while (k < static_cast<int>(seen.size()) && seen[k] == k) ++k;
    colour[c] = k;
    for (const int node : mine)
      if (at_node[node].empty() || at_node[node].back() != k) at_node[node].push_back(k);
  }
  return colour;
}

}  // namespace

Chunks::Chunks(std::span<const int> nodes, int entries_per_batch, int node_count) {
  const int batches = static_cast<int>(nodes.size()) / entries_per_batch;
  // Small enough for a few dozen chunks to share out, large enough that their surfaces do not dominate.
  const int size = std::clamp(batches / 64, 2, 64);
  for (int first = 0; first < batches; first += size) batch_start_.push_back(first);
  batch_start_.push_back(batches);
  const std::vector<int> colour = colours(nodes, entries_per_batch, batch_start_, node_count);
  const int count = colour.empty() ? 0 : *std::max_element(colour.begin(), colour.end()) + 1;
  colour_start_.push_back(0);
  for (int k = 0; k < count; ++k) {
    for (int c = 0; c < static_cast<int>(colour.size()); ++c)
      if (colour[c] == k) chunk_.push_back(c);
    colour_start_.push_back(static_cast<int>(chunk_.size()));
  }
}

}  // namespace sim
