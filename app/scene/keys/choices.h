// The names that keys of kind choice accept.
#pragma once

#include <string_view>
#include <vector>

namespace app {

std::vector<std::string_view> integrator_names();
std::vector<std::string_view> linear_solver_names();
std::vector<std::string_view> definiteness_names();
std::vector<std::string_view> on_failure_names();
std::vector<std::string_view> start_names();
std::vector<std::string_view> material_names();
std::vector<std::string_view> element_names();
std::vector<std::string_view> mass_names();
std::vector<std::string_view> colour_names();
std::vector<std::string_view> colour_map_choices();
std::vector<std::string_view> background_names();
std::vector<std::string_view> finish_names();

}  // namespace app
