// Keys of [[body]] itself.
#include "app/scene/keys/binding.h"
#include "app/scene/keys/choices.h"

namespace app {
namespace {

constexpr auto damping_of = [](auto& d, const Indices& i) -> auto& {
  return body_of(d, i).damping;
};
constexpr auto spin_of = [](auto& d, const Indices& i) -> auto& {
  return body_of(d, i).spin;
};

// A body always has its mesh description and the material of its whole.
constexpr Binding bodies = {
    [](const Document& d, const Indices&) { return std::optional<Value>(std::ssize(d.scene.bodies)); },
    [](Document& d, const Indices&, const Value& n) {
      const auto count = static_cast<std::size_t>(std::get<std::int64_t>(n));
      d.meshes.resize(count);
      d.scene.bodies.resize(count);
      for (sim::Body& body : d.scene.bodies) {
        if (body.materials.empty()) body.materials.resize(1);
      }
    }};

}  // namespace

std::vector<Key> body_keys() {
  return {
      {.path = "body[]", .kind = Kind::list, .required = true, .meaning = "An elastic body.", .binding = bodies},
      {.path = "body[].name",
       .kind = Kind::name,
       .absent = "body0, body1, ...",
       .meaning = "The name by which probes, springs and messages refer to the body.",
       .binding = field<body_of, &sim::Body::name>},
      {.path = "body[].thickness",
       .kind = Kind::number,
       .unit = "m",
       .range = above(0),
       .meaning = "Thickness of a body that is made of triangles or quadrilaterals.",
       .binding = field<body_of, &sim::Body::thickness>},
      {.path = "body[].mass",
       .kind = Kind::choice,
       .choices = names_of<sim::MassMatrix>,
       .meaning = "Mass matrix: \"lumped\" on its diagonal, or \"consistent\" with the shape functions.",
       .binding = field<body_of, &sim::Body::mass>},
      {.path = "body[].damping", .kind = Kind::table, .meaning = "Rayleigh damping: f = -(alpha M + beta K) v."},
      {.path = "body[].damping.alpha",
       .kind = Kind::number,
       .unit = "1/s",
       .range = at_least(0),
       .meaning = "Damps every motion, as a surrounding fluid does.",
       .binding = field<damping_of, &sim::Damping::alpha>},
      {.path = "body[].damping.beta",
       .kind = Kind::number,
       .unit = "s",
       .range = at_least(0),
       .meaning = "Damps deformation only: a body that moves or turns as a whole is not slowed.",
       .binding = field<damping_of, &sim::Damping::beta>},
      {.path = "body[].velocity",
       .kind = Kind::point,
       .unit = "m/s",
       .meaning = "Velocity of the whole body at the start.",
       .binding = field<body_of, &sim::Body::velocity>},
      {.path = "body[].spin",
       .kind = Kind::table,
       .meaning = "Rotation of the body about its centre of mass at the start."},
      {.path = "body[].spin.axis",
       .kind = Kind::axis,
       .meaning = "Axis of rotation.",
       .binding = field<spin_of, &sim::Spin::axis>},
      {.path = "body[].spin.rate",
       .kind = Kind::number,
       .unit = "rad/s",
       .meaning = "Angular velocity, right-handed about the axis.",
       .binding = field<spin_of, &sim::Spin::rate>},
  };
}

}  // namespace app
