#include "sim/build/loads.h"

#include <algorithm>
#include <utility>

#include "sim/build/key_path.h"
#include "sim/element/element.h"
#include "sim/mesh/boundary.h"
#include "sim/mesh/locate.h"
#include "sim/term/point_force.h"
#include "sim/term/pressure.h"
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

void add_pressure(Model& model, std::size_t b, const Pressure& pressure, const std::string& key) {
  const Body& body = model.bodies[b];
  const bool solid = info(body.mesh.kind).dimension == model.D;
  const Eigen::MatrixXi facets = below(key, [&]() -> Eigen::MatrixXi {
    if (pressure.where) return facets_in(body.mesh, *pressure.where);
    return solid ? boundary_facets(body.mesh) : surface_facets(body.mesh);
  });
  if (facets.cols() == 0)
    throw InputError(key, "no boundary facet of \"" + body.name + "\" is in this region; " + span_text(body.mesh));
  if (!solid && facets.rows() != body.mesh.elements.rows())
    throw InputError(key, "there are edges of \"" + body.name + "\" in this region, but no face to press on");
  below(key, [&] {
    model.terms.push_back(
        std::make_unique<PressureLoad>(body, pressure, facets, model.ranges[b].first_node, model.X, model.D));
  });
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
  for (std::size_t k = 0; k < body.loads.tractions.size(); ++k) {
    const std::string key = key_of("body", b) + "." + key_of("traction", k);
    const Eigen::MatrixXi facets = below(key, [&] { return facets_in(body.mesh, body.loads.tractions[k].where); });
    if (facets.cols() == 0)
      throw InputError(key, "no boundary facet of \"" + body.name + "\" is in this region; " + span_text(body.mesh));
    model.terms.push_back(std::make_unique<TractionLoad>(body, body.loads.tractions[k], facets,
                                                         model.ranges[b].first_node, model.X, model.D));
  }
  for (std::size_t k = 0; k < body.loads.pressures.size(); ++k)
    add_pressure(model, b, body.loads.pressures[k], key_of("body", b) + "." + key_of("pressure", k));
  for (std::size_t k = 0; k < body.loads.forces.size(); ++k) {
    const PointForce& force = body.loads.forces[k];
    const auto [nodes, weights] =
        weighted_nodes(find_point(model, key_of("body", b) + "." + key_of("force", k), body.name, force.at));
    model.terms.push_back(std::make_unique<PointLoad>(body.name, force, nodes, weights, model.D));
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
