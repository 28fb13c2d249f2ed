#include "app/picture/arrows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "app/picture/stage.h"
#include "sim/element/element.h"
#include "sim/mesh/boundary.h"
#include "sim/study/loads.h"

namespace app {
namespace {

constexpr render::Colour applied_colour{0.08F, 0.32F, 0.66F};
constexpr render::Colour contact_colour{0.50F, 0.16F, 0.62F};
constexpr render::Colour held_colour{0.80F, 0.22F, 0.10F};
constexpr render::Colour velocity_colour{0.06F, 0.46F, 0.36F};
constexpr double places_along = 7;  // along the longest side of the scene
constexpr double standard_gravity = 9.81;

std::set<int> all_nodes(const sim::Mesh& mesh) {
  return {mesh.elements.data(), mesh.elements.data() + mesh.elements.size()};
}

std::set<int> surface_nodes(const sim::Mesh& mesh) {
  const Eigen::MatrixXi facets = sim::surface_facets(mesh);
  return {facets.data(), facets.data() + facets.size()};
}

// Nodes of a body by the cell of a grid that they lie in at rest.
std::vector<std::vector<int>> places_of(const sim::BodyRange& body, const std::set<int>& nodes, double cell) {
  std::map<std::array<long, 3>, std::vector<int>> cells;
  for (const int node : nodes) {
    std::array<long, 3> key{};
    for (Eigen::Index i = 0; i < body.mesh->X.rows(); ++i) {
      key[static_cast<std::size_t>(i)] = std::lround(body.mesh->X(i, node) / cell);
    }
    cells[key].push_back(body.first_node + node);
  }
  std::vector<std::vector<int>> places;
  for (auto& [key, inside] : cells) places.push_back(std::move(inside));
  return places;
}

// The way that pins move the body against each other, as a share of its size. One alone takes it along.
double pinned_strain(const sim::Body& body, double size) {
  double strain = 0;
  if (body.pins.size() < 2) return strain;
  for (const sim::Pin& pin : body.pins) {
    for (const sim::Keyframe& pose : pin.motion) {
      strain = std::max({strain, pose.translate.norm() / size, std::abs(pose.degrees) / 180});
    }
  }
  return strain;
}

// All that presses or pulls, as far as a scene tells before a step is taken [N]: weights, tractions, springs, and what
// the motion of pins may take, 3 % of E strain size^2.
double total_force(const sim::System& system, const Document& document) {
  sim::State late = system.initial_state();
  late.v.setZero();
  const sim::Scene& scene = document.scene;
  double total = 0;
  for (const sim::Body& body : scene.bodies)
    late.step = std::max(late.step, std::int64_t(std::ceil(body.loads.risen() / system.step_seconds())));
  const Eigen::VectorXd applied = sim::loads(system, late).applied;
  const int D = system.dimension();
  for (Eigen::Index i = 0; i + D <= applied.size(); i += D) total += applied.segment(i, D).norm();
  // The weight, by the momentum of a common velocity.
  for (Eigen::Index i = 0; i < late.v.size(); i += D) late.v[i] = 1;
  total += system.measure(late).p.norm() * scene.world.gravity.norm();
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const sim::BodyRange& range = system.bodies()[b];
    const sim::MaterialSpec& material = scene.bodies[b].materials.front();
    const bool is_solid = sim::info(scene.bodies[b].mesh.kind).dimension == 3;
    const double section = range.size * (is_solid ? range.size : scene.bodies[b].thickness);
    total += 0.03 * material.young * pinned_strain(scene.bodies[b], range.size) * section;
  }
  return total;
}

}  // namespace

Arrows::Arrows(const sim::System& system, const Document& document, const Vec3& origin)
    : system_(system), look_(document.look), origin_(origin) {
  if (!look_.forces && !look_.contact_forces && !look_.velocities) return;
  const double size = rest_box(system.bodies()).sizes().maxCoeff();
  for (const sim::BodyRange& body : system.bodies()) {
    places_.push_back(places_of(body, all_nodes(*body.mesh), size / places_along));
    on_surface_.push_back(places_of(body, surface_nodes(*body.mesh), size / places_along));
  }
  velocity_scale_ = look_.velocity_scale.value_or(0.3 * std::sqrt(size / standard_gravity));
  if (!look_.forces && !look_.contact_forces) return;
  const double total = look_.force_scale ? 1 : total_force(system, document);
  force_scale_ = look_.force_scale.value_or(total > 0 ? 0.5 * size / total : 0);
}

Vec3 Arrows::at(const Eigen::VectorXd& x, int node) const {
  const int D = system_.dimension();
  Vec3 point = Vec3::Zero();
  point.head(D) = x.segment(std::ptrdiff_t{D} * node, D);
  return point;
}

void Arrows::add(const sim::State& state, std::vector<render::Arrow>& arrows) const {
  if (look_.forces || look_.contact_forces) {
    const sim::Loads loads = sim::loads(system_, state);
    add_forces(state, loads.contact, contact_colour, arrows);
    if (look_.forces) {
      add_forces(state, loads.applied, applied_colour, arrows);
      add_forces(state, loads.held, held_colour, arrows);
    }
  }
  if (look_.velocities) add_velocities(state, arrows);
}

// The sum of a place, at the middle of what acts there. A force that presses into the body ends on its surface, so that
// the body does not hide it.
void Arrows::add_forces(const sim::State& state, const Eigen::VectorXd& forces, const render::Colour& colour,
                        std::vector<render::Arrow>& arrows) const {
  if (!forces.allFinite()) return;
  for (const std::vector<Place>& body : places_) {
    Vec3 middle = Vec3::Zero();
    std::size_t count = 0;
    for (const Place& place : body) {
      for (const int node : place) middle += at(state.x, node), ++count;
    }
    middle /= static_cast<double>(count);
    for (const Place& place : body) {
      Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
      double weight = 0;
      for (const int node : place) {
        const Vec3 f = at(forces, node);
        force += f;
        moment += f.norm() * at(state.x, node);
        weight += f.norm();
      }
      if (weight == 0) continue;
      const Vec3 at_middle = moment / weight, point = at_middle - origin_, arrow = force_scale_ * force;
      const bool inwards = arrow.dot(at_middle - middle) < 0;
      arrows.push_back({to_point(inwards ? point - arrow : point), to_point(inwards ? point : point + arrow), colour});
    }
  }
}

void Arrows::add_velocities(const sim::State& state, std::vector<render::Arrow>& arrows) const {
  for (const std::vector<Place>& body : on_surface_) {
    for (const Place& place : body) {
      Vec3 point = Vec3::Zero(), velocity = Vec3::Zero();
      for (const int node : place) {
        point += at(state.x, node);
        velocity += at(state.v, node);
      }
      const double count = static_cast<double>(place.size());
      const Vec3 from = point / count - origin_;
      arrows.push_back({to_point(from), to_point(from + velocity_scale_ * velocity / count), velocity_colour});
    }
  }
}

}  // namespace app
