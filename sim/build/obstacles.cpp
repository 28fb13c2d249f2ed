#include "sim/build/obstacles.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>
#include <optional>
#include <span>

#include "sim/body/pose.h"
#include "sim/build/contacts.h"
#include "sim/build/impact.h"
#include "sim/build/key_path.h"
#include "sim/build/touching.h"
#include "sim/contact/skin.h"
#include "sim/term/obstacle.h"

namespace sim {

namespace {

constexpr double of_body = 1e-3;  // where barriers begin; and friction is fully grown at as much a second

auto own_numbers(const Model& model, const ObstacleNodes& nodes, Eigen::VectorXd& x) {
  return x.segment(static_cast<Eigen::Index>(nodes.first) * model.D, static_cast<Eigen::Index>(nodes.count) * model.D);
}

// At rest; in the plane the length times the thickness [m^2]. nodes: of the system.
double area_of(const Model& model, std::size_t body, std::span<const int> nodes) {
  Vec3 x[3] = {Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  for (std::size_t i = 0; i < nodes.size(); ++i)
    x[i].head(model.D) = model.X.segment(static_cast<Eigen::Index>(nodes[i]) * model.D, model.D);
  if (model.D == 2) return (x[1] - x[0]).norm() * model.bodies[body].thickness;
  return 0.5 * (x[1] - x[0]).cross(x[2] - x[0]).norm();
}

Skin surface_of(const Model& model, std::size_t body) {
  Skin skin;
  skin.D = model.D;
  add_part(skin, model.bodies[body], model.ranges[body].first_node);
  return skin;
}

// kappa [Pa]; a patch carries kappa times its area: about that pressure at half of the barrier's width, at any mesh.
double stiffness_before(const Parts& parts, std::size_t body, std::size_t obstacle) {
  return barrier_stiffness(parts.model.bodies[body], speed_of_body(parts, body) + speed_of_obstacle(parts, obstacle));
}

// What a pin holds for good (`held`, of each node) touches only what moves.
std::vector<ObstacleTerm::Contact> patches_before(const Plane&, const Parts& parts, std::size_t k,
                                                  const std::vector<char>& held) {
  const Model& model = parts.model;
  std::vector<ObstacleTerm::Contact> contacts;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const Skin skin = surface_of(model, b);
    const double kappa = stiffness_before(parts, b, k);
    for (std::size_t p = 0; p < skin.node.size(); ++p)
      if (!held[skin.node[p]]) contacts.push_back({{skin.node[p]}, 1, kappa * skin.point_area[p]});
  }
  return contacts;
}

// A face with a node that is held within the sphere cannot be kept out of it.
std::vector<ObstacleTerm::Contact> patches_before(const Sphere& sphere, const Parts& parts, std::size_t k,
                                                  const std::vector<char>& held) {
  const Model& model = parts.model;
  const auto is_within = [&](int node) {
    Vec3 x = Vec3::Zero();
    x.head(model.D) = model.x_start.segment(static_cast<Eigen::Index>(node) * model.D, model.D);
    return held[node] && (x - sphere.centre).norm() <= sphere.radius;
  };
  std::vector<ObstacleTerm::Contact> contacts;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const Skin skin = surface_of(model, b);
    const double kappa = stiffness_before(parts, b, k);
    for (std::size_t f = 0; f < skin.faces.size(); ++f) {
      ObstacleTerm::Contact contact{{}, skin.corners(), 0};
      const auto nodes = std::span(contact.node.data(), contact.count);
      for (int i = 0; i < contact.count; ++i) nodes[i] = skin.node[skin.faces[f][i]];
      std::sort(nodes.begin(), nodes.end());
      contact.kappa = kappa * area_of(model, b, nodes);
      if (std::all_of(nodes.begin(), nodes.end(), [&](int node) { return held[node]; })) continue;
      if (std::none_of(nodes.begin(), nodes.end(), is_within)) contacts.push_back(contact);
    }
  }
  return contacts;
}

std::vector<ObstacleTerm::Contact> patches(const Parts& parts, std::size_t k) {
  const Model& model = parts.model;
  const Obstacle& obstacle = model.obstacles[k];
  const std::vector<char> held =
      obstacle.motion.empty() ? still_nodes(model) : std::vector<char>(static_cast<std::size_t>(model.node_count), 0);
  if (const auto* plane = std::get_if<Plane>(&obstacle.shape)) return patches_before(*plane, parts, k, held);
  return patches_before(std::get<Sphere>(obstacle.shape), parts, k, held);
}

void add_smooth(Parts& parts, std::size_t k) {
  Model& model = parts.model;
  const Obstacle& obstacle = model.obstacles[k];
  const double reach = of_body * model.smallest_size();
  auto term =
      std::make_unique<ObstacleTerm>(obstacle, model.obstacle_nodes[k], patches(parts, k), reach, reach, model.D);
  model.smooth.push_back(term.get());
  for (const BodyRange& body : model.ranges) part_from_obstacle(*term, key_of("obstacle", k), body, reach / 2, model);
  model.terms.push_back(std::move(term));
}

// Somewhere on it or in it at the start; planes are everywhere.
std::optional<Vec3> point_of(const Model& model, std::size_t k) {
  const Obstacle& obstacle = model.obstacles[k];
  if (const auto* sphere = std::get_if<Sphere>(&obstacle.shape))
    return obstacle.motion.empty() ? sphere->centre : Pose(obstacle.motion, 0).place(sphere->centre);
  if (!std::holds_alternative<RigidSurface>(obstacle.shape)) return {};
  Vec3 point = Vec3::Zero();
  point.head(model.D) =
      model.x_start.segment(static_cast<Eigen::Index>(model.obstacle_nodes[k].first) * model.D, model.D);
  return point;
}

void check_faces(const RigidSurface& surface, int D, const std::string& key) {
  if (surface.faces.cols() == 0) throw InputError(key, "has no faces");
  if (surface.X.rows() != D || surface.faces.rows() != D)
    throw InputError(key, "must be of " + std::string(D == 2 ? "lines in the plane" : "triangles in space"));
}

}  // namespace

std::string name_of_obstacle(const Model& model, std::size_t k) {
  const std::string& name = model.obstacles[k].name;
  return name.empty() ? key_of("obstacle", k) : name;
}

void number_obstacle_nodes(Model& model) {
  model.node_count = model.body_nodes;
  for (const Obstacle& obstacle : model.obstacles) {
    // Without bodies there is nothing to be solved.
    const int count = model.bodies.empty() ? 0 : static_cast<int>(rest_nodes(obstacle, model.D).cols());
    model.obstacle_nodes.push_back({model.node_count, count});
    model.node_count += count;
  }
}

void place_obstacle_nodes(Model& model) {
  for (std::size_t k = 0; k < model.obstacles.size(); ++k) {
    const ObstacleNodes& nodes = model.obstacle_nodes[k];
    if (nodes.count == 0) continue;
    own_numbers(model, nodes, model.X) = rest_nodes(model.obstacles[k], model.D).reshaped();
    model.node_size.segment(nodes.first, nodes.count).setConstant(model.smallest_size());
  }
}

void move_obstacles_to_start(Model& model) {
  for (std::size_t k = 0; k < model.obstacles.size(); ++k) {
    const ObstacleNodes& nodes = model.obstacle_nodes[k];
    if (nodes.count == 0) continue;
    std::vector<int> all(nodes.count);
    std::iota(all.begin(), all.end(), nodes.first);
    Pin pin;
    pin.motion = model.obstacles[k].motion;
    const std::string name = name_of_obstacle(model, k);
    model.pins.add(pin, all, model.X, model.D, {"\"" + name + "\"", name});
  }
  Eigen::VectorXd v = Eigen::VectorXd::Zero(model.dofs());
  model.pins.prescribe(0, model.x_start, v);
}

void add_obstacles(Parts& parts) {
  const Model& model = parts.model;
  if (model.bodies.empty()) return;
  // What can move a body aside comes first; surfaces then look where it is.
  for (const bool surfaces : {false, true})
    for (std::size_t k = 0; k < model.obstacles.size(); ++k) {
      const auto* surface = std::get_if<RigidSurface>(&model.obstacles[k].shape);
      if ((surface != nullptr) != surfaces) continue;
      if (surface != nullptr) {
        check_faces(*surface, model.D, key_of("obstacle", k));
        add_contacts_with_obstacle(parts, k);
      } else {
        add_smooth(parts, k);
      }
      if (const std::optional<Vec3> point = point_of(model, k)) check_outside(model, *point, key_of("obstacle", k));
    }
}

}  // namespace sim
