#include "app/exhibit/exhibit.h"

#include "sim/mesh/input_error.h"

namespace app {

std::vector<std::unique_ptr<Exhibit>> make_exhibits(const Document& document, const sim::System& system) {
  std::vector<std::unique_ptr<Exhibit>> all;
  for (std::size_t k = 0; k < document.exhibits.size(); ++k) {
    const ExhibitSpec& spec = document.exhibits[k];
    try {
      all.push_back(find_exhibit_kind(spec.kind)->make({document.scene, system, spec}));
    } catch (const sim::InputError& error) {
      const sim::InputError whole("exhibit." + std::to_string(k) + "." + error.key, error.what());
      throw SceneError(located(whole, document.places).message);
    }
  }
  return all;
}

}  // namespace app
