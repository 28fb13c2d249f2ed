// The names that keys of kind choice accept.
#pragma once

#include <string_view>
#include <vector>

#include "sim/choices.h"

namespace app {

// Of an enum of sim/choices.h.
template <class E>
std::vector<std::string_view> names_of() {
  std::vector<std::string_view> all;
  for (const sim::Choice<E>& choice : sim::choices<E>) all.push_back(choice.name);
  return all;
}
std::vector<std::string_view> integrator_names();
std::vector<std::string_view> start_names();
std::vector<std::string_view> material_names();
std::vector<std::string_view> element_names();
std::vector<std::string_view> colour_names();
std::vector<std::string_view> colour_map_choices();
std::vector<std::string_view> background_names();
std::vector<std::string_view> finish_names();
std::vector<std::string_view> style_names();
std::vector<std::string_view> exhibit_names();

}  // namespace app
