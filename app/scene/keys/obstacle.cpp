// Keys of [[obstacle]].
#include "app/scene/keys/motion.h"

namespace app {
namespace {

constexpr auto obstacle_of = [](auto& d, const Indices& i) -> auto& {
  return d.scene.obstacles[i[0]];
};
constexpr auto obstacle_form_of = [](auto& d, const Indices& i) -> auto& {
  return d.obstacle_meshes[i[0]];
};

// An obstacle always has the description of its mesh.
constexpr Binding obstacles = {
    [](const Document& d, const Indices&) { return std::optional<Value>(std::ssize(d.scene.obstacles)); },
    [](Document& d, const Indices&, const Value& n) {
      const auto count = static_cast<std::size_t>(std::get<std::int64_t>(n));
      d.scene.obstacles.resize(count);
      d.obstacle_meshes.resize(count);
    }};

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

}  // namespace

std::vector<Key> obstacle_keys() {
  std::vector<Key> table = {
      {"obstacle[]", Kind::list, obstacles,
       "Something rigid that bodies cannot enter. A scene without obstacles runs no contact code."},
      {"obstacle[].name", Form(Kind::name).otherwise("obstacle0, obstacle1, ..."),
       field<obstacle_of, &sim::Obstacle::name>, "The name by which messages and tables refer to it."},
      {"obstacle[].plane",
       Form(Kind::table).otherwise("another shape"),
       {},
       "A plane that is solid on the side away from its normal."},
      {"obstacle[].plane.point", Form(Kind::point, "m").needed(), plane<&sim::Plane::point>, "A point of the plane."},
      {"obstacle[].plane.normal", Form(Kind::direction).needed(), plane<&sim::Plane::normal>,
       "Direction out of the solid side, towards the bodies."},
      {"obstacle[].sphere", Form(Kind::ball, "m").otherwise("another shape"),
       alternative<obstacle_of, &sim::Obstacle::shape, sim::Sphere>, "A ball: [centre, radius]."},
      {"obstacle[].box", Form(Kind::box, "m").tells(Effect::restart).otherwise("another shape"),
       field<obstacle_form_of, &ObstacleMesh::box>, "A box along the axes: [lowest corner, highest corner]."},
  };
  append(table, obstacle_mesh_keys());
  append(table, {{"obstacle[].friction", Form(Kind::number, "", between(0, 10)),
                  field<obstacle_of, &sim::Obstacle::friction>, "Coulomb's coefficient of friction."},
                 {"obstacle[].release", Form(Kind::number, "s", at_least(0)).otherwise("never"),
                  field<obstacle_of, &sim::Obstacle::release>, "Time from which on it is not there."}});
  std::vector<Key> motion =
      motion_keys<obstacle_of, &sim::Obstacle::motion, 1>("obstacle[].motion", "How the obstacle moves as a whole.");
  motion.front().tells(Effect::restart);
  append(table, motion);
  return table;
}

}  // namespace app
