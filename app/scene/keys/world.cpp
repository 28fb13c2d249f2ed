// Keys of [world], [[spring]] and [[probe]].
#include "app/scene/keys/binding.h"

namespace app {
namespace {

constexpr auto world_of = [](auto& d, const Indices&) -> auto& {
  return d.scene.world;
};
constexpr auto spring_of = [](auto& d, const Indices& i) -> auto& {
  return d.scene.springs[i[0]];
};
constexpr auto probe_of = [](auto& d, const Indices& i) -> auto& {
  return d.scene.probes[i[0]];
};

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
