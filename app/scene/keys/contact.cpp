// Keys of [[contact]].
#include "app/scene/keys/binding.h"

namespace app {
namespace {

constexpr auto contact_of = [](auto& d, const Indices& i) -> auto& {
  return d.scene.contacts[i[0]];
};

// None where every pair of bodies is meant.
constexpr Binding two_names = {[](const Document& d, const Indices& i) -> std::optional<Value> {
                                 const auto& names = contact_of(d, i).between;
                                 return names.empty() ? std::nullopt : std::optional<Value>(names);
                               },
                               field<contact_of, &sim::Contact::between>.set};

}  // namespace

std::vector<Key> contact_keys() {
  return {
      {"contact[]", Kind::list, length<scene_of, &sim::Scene::contacts>,
       "Bodies that touch and do not pass through each other. A scene without contacts runs no code for them."},
      {"contact[].between", Form(Kind::names).of_size(2, 2).otherwise("every pair of bodies, none with itself"),
       two_names, "Names of the two bodies; the same twice: the body with itself."},
      {"contact[].friction", Form(Kind::number, "", between(0, 10)), field<contact_of, &sim::Contact::friction>,
       "Coulomb's coefficient of friction."},
      {"contact[].distance", Form(Kind::number, "m", above(0)).otherwise("1e-3 of the smaller body"),
       field<contact_of, &sim::Contact::distance>, "How near surfaces come before they push."},
      {"contact[].stiffness",
       Form(Kind::number, "Pa", above(0))
           .otherwise("a tenth of the smaller Young's modulus, or of rho v^2 where the scene throws bodies that fast"),
       field<contact_of, &sim::Contact::stiffness>,
       "Pressure at about half of that distance; nearer it grows without end."},
      {"contact[].offset", Form(Kind::number, "m", at_least(0)).otherwise("0"),
       field<contact_of, &sim::Contact::offset>, "How far surfaces stay apart, as thick cloth does."},
  };
}

}  // namespace app
