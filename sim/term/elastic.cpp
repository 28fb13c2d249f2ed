#include "sim/term/elastic.h"

#include "sim/element/list.h"
#include "sim/material/list.h"
#include "sim/mesh/input_error.h"

namespace sim {

namespace {

std::string material_names() {
  std::string names;
  for_each_type(Materials{},
                [&]<class M>(std::type_identity<M>) { names += (names.empty() ? "" : ", ") + std::string(M::name); });
  return names;
}

}  // namespace

std::unique_ptr<ElasticTerm> make_elastic(const ElasticInput& input, int D) {
  auto term = visit_element(input.body.mesh.kind, [&]<class E>(std::type_identity<E>) -> std::unique_ptr<ElasticTerm> {
    if constexpr (E::dimension == 3) {
      return make_elastic_of<E, 3>(input);
    } else {
      if (D == 2) return make_elastic_of<E, 2>(input);
      if constexpr (!E::membrane)
        throw InputError("mesh", std::string(E::name) + " is for plane scenes; a membrane in space takes " +
                                     element_list([](const ElementInfo& element) { return element.membrane; }));
      else
        return make_elastic_of<E, 3>(input);
    }
  });
  if (!term)
    throw InputError("material.model",
                     "\"" + input.material.model + "\" is not a material: one of " + material_names());
  return term;
}

}  // namespace sim
