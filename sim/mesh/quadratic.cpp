#include "sim/mesh/quadratic.h"

#include <optional>

#include "sim/element/list.h"
#include "sim/mesh/input_error.h"
#include "sim/mesh/subdivide.h"

namespace sim {
namespace {

// One child that fills its parent and has more nodes.
struct SameCell {
  template <class Parent, class Child, int D>
  std::array<ChildXi<Child>, 1> operator()(const ElementX<Parent, D>&) const {
    return {node_xi<Child>()};
  }
};

}  // namespace

Mesh to_quadratic(const Mesh& mesh) {
  if (info(mesh.kind).order == 2) return mesh;
  std::optional<Mesh> quadratic;
  for_each_type(Elements{}, [&]<class E>(std::type_identity<E>) {
    if constexpr (E::order == 2) {
      if (E::Linear::kind != mesh.kind) return;
      quadratic = mesh.dimension() == E::dimension ? subdivide<typename E::Linear, E, E::dimension>(mesh, SameCell{})
                                                   : subdivide<typename E::Linear, E, 3>(mesh, SameCell{});
    }
  });
  if (!quadratic) {
    const auto right = [](const ElementInfo& element) { return element.order == 1 && element.quadratic.has_value(); };
    throw InputError("mesh.element",
                     std::string(info(mesh.kind).name) + " has no quadratic form here; take " + element_list(right));
  }
  return *quadratic;
}

}  // namespace sim
