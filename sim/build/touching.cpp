#include "sim/build/touching.h"

#include <algorithm>
#include <limits>
#include <sstream>
#include <variant>

#include "sim/element/element.h"
#include "sim/mesh/input_error.h"
#include "sim/mesh/locate.h"

namespace sim {
namespace {

// The patch that is deepest in the obstacle.
struct Deepest {
  double distance = std::numeric_limits<double>::infinity();  // m
  Vec3 out = {0, 0, 0};                                       // normal of the obstacle there
  double largest = 0;                                         // m, of all coordinates of the body
};

std::vector<Patch> patches_of(const ObstacleTerm& term, const BodyRange& body, const Model& model) {
  std::vector<Patch> patches;
  for (const ObstacleTerm::Contact& contact : term.contacts())
    if (contact.node[0] >= body.first_node && contact.node[0] < body.first_node + body.node_count)
      patches.push_back(term.patch(model.x_start, contact));
  return patches;
}

Deepest find_deepest(const ObstacleTerm::Shape& obstacle, const std::vector<Patch>& patches) {
  Deepest deepest;
  for (const Patch& at : patches) {
    const Approach near = std::visit([&](const auto& it) { return Approach(it, at); }, obstacle);
    for (int i = 0; i < at.count; ++i) deepest.largest = std::max(deepest.largest, at.x[i].cwiseAbs().maxCoeff());
    if (near.d < deepest.distance) deepest = {near.d, near.normal, deepest.largest};
  }
  return deepest;
}

Patch moved(Patch at, const Vec3& by) {
  for (int i = 0; i < at.count; ++i) at.x[i] += by;
  return at;
}

// The least t [m] for which the gap of at + t n is above 0, by doubling and halving, as any shape can say its distance.
double way_out(const ObstacleTerm::Shape& obstacle, const Patch& at, const Vec3& n, double depth) {
  constexpr int halvings = 60;
  double low = 0, high = depth;
  while (!(gap(obstacle, moved(at, high * n)) > 0) && high < 1e6 * depth) high *= 2;
  for (int k = 0; k < halvings; ++k) {
    const double middle = (low + high) / 2;
    (gap(obstacle, moved(at, middle * n)) > 0 ? high : low) = middle;
  }
  return high;
}

}  // namespace

std::vector<char> still_nodes(const Model& model) {
  std::vector<char> still(model.node_count, 0);
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    for (const Pin& pin : model.bodies[b].pins) {
      const auto held = [&](char axis) { return pin.axes.find(axis) != std::string::npos; };
      if (!pin.motion.empty() || pin.release || !held('x') || !held('y') || (model.D == 3 && !held('z'))) continue;
      for (const int node : nodes_in(model.bodies[b].mesh, pin.where)) still[model.ranges[b].first_node + node] = 1;
    }
  }
  return still;
}

void part_from_obstacle(const ObstacleTerm& term, const std::string& key, const BodyRange& body, double gap,
                        Model& model) {
  constexpr double billionth = 1e-9, last_digits = 1e-14;  // of the body's size, of coordinates far from the origin
  const ObstacleTerm::Shape obstacle = term.shape(model.x_start);
  const std::vector<Patch> patches = patches_of(term, body, model);
  const Deepest deepest = find_deepest(obstacle, patches);
  if (deepest.distance > 0) return;
  if (deepest.distance >= -std::max(billionth * body.size, last_digits * deepest.largest)) {
    for (int node = body.first_node; node < body.first_node + body.node_count; ++node)
      model.x_start.segment(static_cast<Eigen::Index>(node) * model.D, model.D) += gap * deepest.out.head(model.D);
    return;
  }
  double way = 0;
  for (const Patch& at : patches)
    if (sim::gap(obstacle, at) <= 0) way = std::max(way, way_out(obstacle, at, deepest.out, -deepest.distance));
  std::ostringstream message;
  message << "\"" << body.name << "\" starts " << -deepest.distance << " m inside this obstacle: translate it by (";
  for (int i = 0; i < model.D; ++i) message << (i == 0 ? "" : ", ") << way * deepest.out[i];
  message << "), or move the obstacle";
  throw InputError(key, message.str());
}

void check_outside(const Model& model, const Vec3& point, const std::string& key) {
  for (const BodyRange& body : model.ranges) {
    if (info(body.mesh->kind).dimension < model.D) continue;
    Mesh at_start = *body.mesh;
    at_start.X = model.x_start
                     .segment(static_cast<Eigen::Index>(body.first_node) * model.D,
                              static_cast<Eigen::Index>(body.node_count) * model.D)
                     .reshaped(model.D, body.node_count);
    if (locate(at_start, point)) throw InputError(key, "starts inside of \"" + body.name + "\": move one of them");
  }
}

}  // namespace sim
