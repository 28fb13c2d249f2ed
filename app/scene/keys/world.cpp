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
      {"world", Kind::table, {}, "What acts on every body."},
      {"world.gravity", Form(Kind::point, "m/s^2"), field<world_of, &sim::World::gravity>,
       "Acceleration of free fall."},
  };
}

std::vector<Key> obstacle_keys() {
  return {
      {"obstacle[]", Kind::list, length<scene_of, &sim::Scene::obstacles>,
       "Something rigid that bodies cannot enter. A scene without obstacles runs no contact code."},
      {"obstacle[].plane",
       Form(Kind::table).otherwise("sphere"),
       {},
       "A plane that is solid on the side away from its normal."},
      {"obstacle[].plane.point", Form(Kind::point, "m").needed(), plane<&sim::Plane::point>, "A point of the plane."},
      {"obstacle[].plane.normal", Form(Kind::direction).needed(), plane<&sim::Plane::normal>,
       "Direction out of the solid side, towards the bodies."},
      {"obstacle[].sphere", Form(Kind::ball, "m").otherwise("plane"),
       alternative<obstacle_of, &sim::Obstacle::shape, sim::Sphere>, "A ball: [centre, radius]."},
      {"obstacle[].friction", Form(Kind::number, "", between(0, 10)), field<obstacle_of, &sim::Obstacle::friction>,
       "Coulomb's coefficient of friction."},
  };
}

std::vector<Key> spring_keys() {
  return {
      {"spring[]", Kind::list, length<scene_of, &sim::Scene::springs>,
       "A spring between a point of a body and a fixed place in space."},
      {"spring[].body", Form(Kind::text).needed(), field<spring_of, &sim::Spring::body>,
       "Name of the body that it pulls."},
      {"spring[].at", Form(Kind::point, "m").needed(), field<spring_of, &sim::Spring::at>,
       "The point that it holds, by its place in the body at rest."},
      {"spring[].target", Form(Kind::point, "m").needed(), field<spring_of, &sim::Spring::target>,
       "The place that it pulls the point towards."},
      {"spring[].stiffness", Form(Kind::number, "N/m", above(0)).needed(), field<spring_of, &sim::Spring::stiffness>,
       "Force per distance between the point and its target."},
  };
}

std::vector<Key> probe_keys() {
  return {
      {"probe[]", Kind::list, length<scene_of, &sim::Scene::probes>,
       "A material point whose displacement is written to probes.csv."},
      {"probe[].name", Form(Kind::name).needed(), field<probe_of, &sim::Probe::name>,
       "Name of the probe, with which its columns in probes.csv begin."},
      {"probe[].body", Form(Kind::text).needed(), field<probe_of, &sim::Probe::body>,
       "Name of the body that it belongs to."},
      {"probe[].at", Form(Kind::point, "m").needed(), field<probe_of, &sim::Probe::at>,
       "Place of the point in the body at rest."},
      {"probe[].reference", Form(Kind::point, "m").otherwise("none"), reference,
       "The displacement that the point should have at the end; `ritz run` prints value, reference and error."},
  };
}

}  // namespace app
