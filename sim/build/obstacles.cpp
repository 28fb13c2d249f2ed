#include "sim/build/obstacles.h"

#include <numeric>
#include <optional>

#include "sim/body/pose.h"
#include "sim/build/contacts.h"
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

// Nodes of all surfaces that may touch an obstacle. What a pin holds for good touches only what moves.
// kappa A_i with a tenth of Young's modulus, as in contact, and the node's share A_i of the surface: about that
// pressure is carried at half of the barrier's width, at any mesh.
std::vector<ObstacleTerm::Contact> surface_nodes(const Model& model, bool obstacle_moves) {
  constexpr double tenth = 0.1;
  const std::vector<char> still = still_nodes(model);
  std::vector<ObstacleTerm::Contact> contacts;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const Body& body = model.bodies[b];
    Skin skin;
    skin.D = model.D;
    add_part(skin, body, model.ranges[b].first_node);
    for (std::size_t p = 0; p < skin.node.size(); ++p)
      if (obstacle_moves || !still[skin.node[p]])
        contacts.push_back({skin.node[p], tenth * body.materials[0].young * skin.point_area[p]});
  }
  return contacts;
}

void add_smooth(Parts& parts, std::size_t k) {
  Model& model = parts.model;
  const Obstacle& obstacle = model.obstacles[k];
  const double reach = of_body * model.smallest_size();
  auto term = std::make_unique<ObstacleTerm>(obstacle, model.obstacle_nodes[k],
                                             surface_nodes(model, !obstacle.motion.empty()), reach, reach, model.D);
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
