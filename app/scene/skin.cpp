#include "app/scene/skin.h"

#include "sim/element/element.h"
#include "sim/fill/carry.h"
#include "sim/fill/shells.h"
#include "sim/mesh/input_error.h"

namespace app {

Skin make_skin(const sim::Mesh& surface, const sim::Mesh& body) {
  constexpr double far = 100;  // heights of elements
  if (surface.kind != sim::ElementKind::tri3 || surface.dimension() != 3)
    throw sim::InputError("mesh.skin", "is no surface of triangles in space");
  if (!sim::info(body.kind).simplex() || sim::info(body.kind).dimension != 3)
    throw sim::InputError(
        "mesh.skin", "is for bodies of tets; this one has " + std::string(sim::info(body.kind).name) + " elements");
  Skin skin{sim::face_outwards(surface.X, surface.elements).triangles, sim::carry(body, surface.X)};
  if (sim::farthest_outside(skin.points) > far)
    throw sim::InputError("mesh.skin", "lies elsewhere than the body: its vertices are more than 100 elements away");
  return skin;
}

}  // namespace app
