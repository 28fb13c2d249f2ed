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
      d.start_files.resize(count);
      d.without_basis.resize(count);
      d.basis_folders.resize(count);
      d.scene.bodies.resize(count);
      for (sim::Body& body : d.scene.bodies) {
        if (body.materials.empty()) body.materials.resize(1);
      }
    }};

}  // namespace

std::vector<Key> body_keys() {
  return {
      {"body[]", Form(Kind::list).otherwise("required; not beside an exhibit that needs none"), bodies,
       "An elastic body."},
      {"body[].name", Form(Kind::name).tells(Effect::restart).otherwise("body0, body1, ..."),
       field<body_of, &sim::Body::name>, "The name by which probes, springs and messages refer to the body."},
      {"body[].thickness", Form(Kind::number, "m", above(0)), field<body_of, &sim::Body::thickness>,
       "Thickness of a body that is made of triangles or quadrilaterals."},
      {"body[].mass", Form(Kind::choice).of(names_of<sim::MassMatrix>), field<body_of, &sim::Body::mass>,
       "Mass matrix: \"lumped\" on its diagonal, or \"consistent\" with the shape functions."},
      {"body[].damping", Kind::table, {}, "Rayleigh damping: f = -(alpha M + beta K) v."},
      {"body[].damping.alpha", Form(Kind::number, "1/s", at_least(0)), field<damping_of, &sim::Damping::alpha>,
       "Damps every motion, as a surrounding fluid does."},
      {"body[].damping.beta", Form(Kind::number, "s", at_least(0)), field<damping_of, &sim::Damping::beta>,
       "Damps deformation only: a body that moves or turns as a whole is not slowed."},
      {"body[].velocity", Form(Kind::point, "m/s").tells(Effect::start), field<body_of, &sim::Body::velocity>,
       "Velocity of the whole body at the start."},
      {"body[].spin",
       Form(Kind::table).tells(Effect::start),
       {},
       "Rotation of the body about its centre of mass at the start."},
      {"body[].spin.axis", Kind::axis, field<spin_of, &sim::Spin::axis>, "Axis of rotation."},
      {"body[].spin.rate", Form(Kind::number, "rad/s"), field<spin_of, &sim::Spin::rate>,
       "Angular velocity, right-handed about the axis."},
  };
}

}  // namespace app
