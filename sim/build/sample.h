// The elements that a cubature has chosen, as bodies of their own in which no two elements share a node.
#pragma once

#include <optional>

#include "sim/reduce/reduction.h"

namespace sim {

// Empty where no body has a cubature. A body without one keeps all of its elements.
std::optional<Sample> make_sample(const Model& full, const Lift& lift);

// Some elements of a body, apart from each other: the element k has the nodes k n ... k n + n - 1, in the order of
// `elements`. `number`: of the body, for messages.
struct ApartElements {
  std::unique_ptr<Body> body;                         // with these elements alone
  std::vector<std::unique_ptr<ElasticTerm>> elastic;  // one for each material that they have
  std::vector<int> nodes;                             // of the whole body, for each node of theirs
};
ApartElements elements_apart(const Body& body, std::size_t number, const std::vector<int>& elements,
                             const std::vector<double>& weights, int first_node, int node_count, int D);

}  // namespace sim
