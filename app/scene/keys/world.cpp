// Keys of [world], [[obstacle]], [[spring]] and [[probe]].
#include "app/scene/keys/binding.h"

namespace app {
namespace {

constexpr auto world_of = [](auto& d, const Indices&) -> auto& {
  return d.scene.world;
};
constexpr auto obstacle_of = [](auto& d, const Indices& i) -> auto& {
  return d.scene.obstacles[i[0]];
};
constexpr auto spring_of = [](auto& d, const Indices& i) -> auto& {
  return d.scene.springs[i[0]];
};
constexpr auto probe_of = [](auto& d, const Indices& i) -> auto& {
  return d.scene.probes[i[0]];
};

// A vector of an obstacle that is a plane.
template <auto member>
constexpr Binding plane = {[](const Document& d, const Indices& i) -> std::optional<Value> {
                             const auto* held = std::get_if<sim::Plane>(&obstacle_of(d, i).shape);
                             return held ? std::optional<Value>(to_value(held->*member)) : std::nullopt;
                           },
                           [](Document& d, const Indices& i, const Value& value) {
                             auto& shape = obstacle_of(d, i).shape;
                             if (!std::holds_alternative<sim::Plane>(shape)) shape = sim::Plane{{0, 0, 0}, {0, 1, 0}};
                             from_value(value, std::get<sim::Plane>(shape).*member);
                           }};

constexpr Binding reference = {[](const Document& d, const Indices& i) -> std::optional<Value> {
                                 const auto k = static_cast<std::size_t>(i[0]);
                                 return k < d.references.size() ? to_optional(d.references[k]) : std::nullopt;
                               },
                               [](Document& d, const Indices& i, const Value& value) {
                                 const auto k = static_cast<std::size_t>(i[0]);
                                 if (d.references.size() <= k) d.references.resize(k + 1);
                                 from_value(value, d.references[k]);
                               }};

}  // namespace

std::vector<Key> world_keys() {
  return {
      {.path = "world", .kind = Kind::table, .meaning = "What acts on every body."},
      {.path = "world.gravity",
       .kind = Kind::point,
       .unit = "m/s^2",
       .meaning = "Acceleration of free fall.",
       .binding = field<world_of, &sim::World::gravity>},
  };
}

std::vector<Key> obstacle_keys() {
  return {
      {.path = "obstacle[]",
       .kind = Kind::list,
       .meaning = "Something rigid that bodies cannot enter. A scene without obstacles runs no contact code.",
       .binding = length<scene_of, &sim::Scene::obstacles>},
      {.path = "obstacle[].plane",
       .kind = Kind::table,
       .absent = "sphere",
       .meaning = "A plane that is solid on the side away from its normal."},
      {.path = "obstacle[].plane.point",
       .kind = Kind::point,
       .unit = "m",
       .required = true,
       .meaning = "A point of the plane.",
       .binding = plane<&sim::Plane::point>},
      {.path = "obstacle[].plane.normal",
       .kind = Kind::direction,
       .required = true,
       .meaning = "Direction out of the solid side, towards the bodies.",
       .binding = plane<&sim::Plane::normal>},
      {.path = "obstacle[].sphere",
       .kind = Kind::ball,
       .unit = "m",
       .absent = "plane",
       .meaning = "A ball: [centre, radius].",
       .binding = alternative<obstacle_of, &sim::Obstacle::shape, sim::Sphere>},
      {.path = "obstacle[].friction",
       .kind = Kind::number,
       .range = between(0, 10),
       .meaning = "Coulomb's coefficient of friction.",
       .binding = field<obstacle_of, &sim::Obstacle::friction>},
  };
}

std::vector<Key> spring_keys() {
  return {
      {.path = "spring[]",
       .kind = Kind::list,
       .meaning = "A spring between a point of a body and a fixed place in space.",
       .binding = length<scene_of, &sim::Scene::springs>},
      {.path = "spring[].body",
       .kind = Kind::text,
       .required = true,
       .meaning = "Name of the body that it pulls.",
       .binding = field<spring_of, &sim::Spring::body>},
      {.path = "spring[].at",
       .kind = Kind::point,
       .unit = "m",
       .required = true,
       .meaning = "The point that it holds, by its place in the body at rest.",
       .binding = field<spring_of, &sim::Spring::at>},
      {.path = "spring[].target",
       .kind = Kind::point,
       .unit = "m",
       .required = true,
       .meaning = "The place that it pulls the point towards.",
       .binding = field<spring_of, &sim::Spring::target>},
      {.path = "spring[].stiffness",
       .kind = Kind::number,
       .unit = "N/m",
       .range = above(0),
       .required = true,
       .meaning = "Force per distance between the point and its target.",
       .binding = field<spring_of, &sim::Spring::stiffness>},
  };
}

std::vector<Key> probe_keys() {
  return {
      {.path = "probe[]",
       .kind = Kind::list,
       .meaning = "A material point whose displacement is written to probes.csv.",
       .binding = length<scene_of, &sim::Scene::probes>},
      {.path = "probe[].name",
       .kind = Kind::name,
       .required = true,
       .meaning = "Name of the probe, with which its columns in probes.csv begin.",
       .binding = field<probe_of, &sim::Probe::name>},
      {.path = "probe[].body",
       .kind = Kind::text,
       .required = true,
       .meaning = "Name of the body that it belongs to.",
       .binding = field<probe_of, &sim::Probe::body>},
      {.path = "probe[].at",
       .kind = Kind::point,
       .unit = "m",
       .required = true,
       .meaning = "Place of the point in the body at rest.",
       .binding = field<probe_of, &sim::Probe::at>},
      {.path = "probe[].reference",
       .kind = Kind::point,
       .unit = "m",
       .absent = "none",
       .meaning =
           "The displacement that the point should have at the end; `ritz run` prints value, reference and error.",
       .binding = reference},
  };
}

}  // namespace app
