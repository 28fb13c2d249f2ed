#include "sim/build/loads.h"

#include <algorithm>
#include <utility>

#include "sim/build/key_path.h"
#include "sim/mesh/locate.h"
#include "sim/term/spring.h"
#include "sim/term/traction.h"

namespace sim {
namespace {

// The nodes of the system that a point is the weighted sum of, and the weights.
std::pair<std::vector<int>, std::vector<double>> weighted_nodes(const ProbePlace& place) {
  std::vector<int> nodes;
  for (std::size_t a = 0; a < place.point.weights.size(); ++a)
    nodes.push_back(place.first_node + place.mesh->elements(static_cast<Eigen::Index>(a), place.point.element));
  return {nodes, place.point.weights};
}

}  // namespace

ProbePlace find_point(const Model& model, const std::string& key, const std::string& body, const Vec3& at) {
  const auto range =
      std::find_if(model.ranges.begin(), model.ranges.end(), [&](const BodyRange& r) { return r.name == body; });
  if (range == model.ranges.end()) throw InputError(key + ".body", "\"" + body + "\" is not the name of a body");
  const auto point = locate(*range->mesh, at);
  if (!point) throw InputError(key + ".at", "the point is outside the body \"" + body + "\"");
  return {range->first_node, range->mesh, *point};
}

void add_loads(Model& model, std::size_t b) {
  const Body& body = model.bodies[b];
  for (std::size_t k = 0; k < body.tractions.size(); ++k) {
    const std::string key = key_of("body", b) + "." + key_of("traction", k);
    const Eigen::MatrixXi facets = below(key, [&] { return facets_in(body.mesh, body.tractions[k].where); });
    if (facets.cols() == 0) throw InputError(key, "no boundary facet of \"" + body.name + "\" is in this region");
    model.terms.push_back(
        std::make_unique<TractionLoad>(body, body.tractions[k], facets, model.ranges[b].first_node, model.X, model.D));
  }
}

void add_springs(Model& model, const std::vector<Spring>& springs) {
  for (std::size_t k = 0; k < springs.size(); ++k) {
    const ProbePlace place = find_point(model, key_of("spring", k), springs[k].body, springs[k].at);
    const auto [nodes, weights] = weighted_nodes(place);
    model.terms.push_back(std::make_unique<SpringTerm>(springs[k], nodes, weights, model.D));
  }
}

}  // namespace sim
