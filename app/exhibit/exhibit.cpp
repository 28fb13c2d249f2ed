#include "app/exhibit/exhibit.h"

#include <utility>

#include "app/scene/value_text.h"
#include "sim/mesh/input_error.h"

namespace app {

Grip number_grip(std::size_t diagram, const render::Spot& at, std::vector<double> values, std::size_t k,
                 std::function<double(const render::Spot&)> number) {
  return {diagram, at, "values", [values = std::move(values), k, number = std::move(number)](const render::Spot& to) {
            std::vector<double> moved = values;
            moved[k] = number(to);
            return value_text(*find_key("exhibit[].values"), moved, 2);
          }};
}

Exhibits make_exhibits(const Document& document, std::shared_ptr<const sim::System> system) {
  Exhibits made{std::move(system), document.exhibits, {}};
  for (std::size_t k = 0; k < document.exhibits.size(); ++k) {
    const ExhibitSpec& spec = document.exhibits[k];
    try {
      made.all.push_back(find_exhibit_kind(spec.kind)->make({document.scene, *made.system, spec, document.folder}));
    } catch (const sim::InputError& error) {
      const sim::InputError whole("exhibit." + std::to_string(k) + "." + error.key, error.what());
      throw SceneError(located(whole, document.places).message);
    }
  }
  return made;
}

}  // namespace app
