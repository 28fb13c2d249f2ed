#include "sim/build/sample.h"

#include <algorithm>
#include <numeric>

#include "sim/build/materials.h"

namespace sim {

ApartElements elements_apart(const Body& body, std::size_t number, const std::vector<int>& elements,
                             const std::vector<double>& weights, int first_node, int node_count, int D) {
  const Eigen::Index n = body.mesh.elements.rows(), count = std::ssize(elements);
  ApartElements apart;
  apart.body = std::make_unique<Body>();
  apart.body->name = body.name;
  apart.body->thickness = body.thickness;
  Mesh& mesh = apart.body->mesh;
  mesh.kind = body.mesh.kind;
  mesh.X.resize(body.mesh.X.rows(), n * count);
  mesh.elements = Eigen::VectorXi::LinSpaced(n * count, 0, static_cast<int>(n * count) - 1).reshaped(n, count);
  for (const int e : elements)
    for (Eigen::Index a = 0; a < n; ++a) {
      mesh.X.col(std::ssize(apart.nodes)) = body.mesh.X.col(body.mesh.elements(a, e));
      apart.nodes.push_back(body.mesh.elements(a, e));
    }
  const std::vector<int> material = material_of_elements(body, number);
  for (std::size_t m = 0; m < body.materials.size(); ++m) {
    ElasticInput input{*apart.body, body.materials[m], {}, first_node, node_count, {}};
    for (std::size_t k = 0; k < elements.size(); ++k)
      if (material[static_cast<std::size_t>(elements[k])] == static_cast<int>(m)) {
        input.elements.push_back(static_cast<int>(k));
        if (!weights.empty()) input.counts.push_back(weights[k]);
      }
    if (!input.elements.empty()) apart.elastic.push_back(make_elastic(input, D));
  }
  return apart;
}

namespace {

// The elements of a body that are summed, and how often: all of them once where it has no cubature.
Cubature cubature_of(const Body& body) {
  if (body.basis->vectors->cubature) return *body.basis->vectors->cubature;
  Cubature all;
  all.elements.resize(static_cast<std::size_t>(body.mesh.element_count()));
  std::iota(all.elements.begin(), all.elements.end(), 0);
  return all;
}

}  // namespace

std::optional<Sample> make_sample(const Model& full, const Lift& lift) {
  if (std::none_of(full.bodies.begin(), full.bodies.end(),
                   [](const Body& body) { return body.basis->vectors->cubature.has_value(); }))
    return {};
  Sample sample;
  std::vector<Cubature> cubatures;
  int node_count = 0;
  for (const Body& body : full.bodies) {
    cubatures.push_back(cubature_of(body));
    node_count += static_cast<int>(body.mesh.elements.rows() * std::ssize(cubatures.back().elements));
  }
  const int D = full.D;
  Lift::Rows U(static_cast<Eigen::Index>(node_count) * D, lift.coordinates());
  Eigen::VectorXd X(static_cast<Eigen::Index>(node_count) * D);
  int first = 0;
  for (std::size_t b = 0; b < full.bodies.size(); ++b) {
    ApartElements apart =
        elements_apart(full.bodies[b], b, cubatures[b].elements, cubatures[b].weights, first, node_count, D);
    for (const int node : apart.nodes) {
      const Eigen::Index from = static_cast<Eigen::Index>(full.ranges[b].first_node + node) * D;
      U.middleRows(static_cast<Eigen::Index>(first) * D, D) = lift.U().middleRows(from, D);
      X.segment(static_cast<Eigen::Index>(first) * D, D) = full.X.segment(from, D);
      ++first;
    }
    for (auto& term : apart.elastic) {
      sample.elastic.push_back(std::move(term));
      sample.body.push_back(static_cast<int>(b));
    }
    sample.bodies.push_back(std::move(apart.body));
    sample.from.push_back(std::move(cubatures[b].elements));
  }
  sample.lift = std::make_unique<Lift>(std::move(U), std::move(X));
  return sample;
}

}  // namespace sim
