#include "app/scene/keys/choices.h"

#include "app/scene/exhibits.h"
#include "render/colour_map.h"
#include "sim/body/start.h"
#include "sim/element/element.h"
#include "sim/material/list.h"
#include "sim/time/scheme.h"

namespace app {
namespace {

// The name of every type of a list.
template <class... T>
std::vector<std::string_view> names(sim::TypeList<T...>) {
  return {T::name...};
}

}  // namespace

std::vector<std::string_view> integrator_names() {
  std::vector<std::string_view> all;
  for (const sim::Scheme& scheme : sim::schemes()) all.push_back(scheme.name);
  return all;
}

std::vector<std::string_view> start_names() {
  std::vector<std::string_view> all;
  for (const sim::StartShape& shape : sim::start_shapes()) all.push_back(shape.name);
  return all;
}

std::vector<std::string_view> material_names() {
  return names(sim::Materials{});
}

std::vector<std::string_view> element_names() {
  std::vector<std::string_view> all;
  for (const sim::ElementInfo& element : sim::elements()) all.push_back(element.name);
  return all;
}

std::vector<std::string_view> colour_names() {
  return {"plain", "stress", "stretch", "energy", "J", "pressure"};
}

std::vector<std::string_view> colour_map_choices() {
  return render::colour_map_names();
}

std::vector<std::string_view> background_names() {
  return {"studio", "paper"};
}

std::vector<std::string_view> finish_names() {
  return {"rubber", "jelly"};
}

std::vector<std::string_view> style_names() {
  return {"usual", "lecture"};
}

std::vector<std::string_view> exhibit_names() {
  std::vector<std::string_view> all;
  for (const ExhibitKind& kind : exhibit_kinds()) all.push_back(kind.name);
  return all;
}

}  // namespace app
