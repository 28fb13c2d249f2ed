#include "app/trade/features.h"

#include "app/scene/scene_text.h"
#include "sim/build/barrier_scheme.h"
#include "sim/element/element.h"
#include "sim/time/scheme.h"

namespace app {
namespace {

TradeCase without(const std::string& feature, const std::string& key, const std::string& value) {
  return {feature, Axis::rest, {{key, value}}};
}

void add_body_features(const Document& scene, std::size_t b, std::vector<TradeCase>& list) {
  const sim::Body& body = scene.scene.bodies[b];
  const std::string key = "body." + std::to_string(b) + ".", name = body.name + ": ";
  const auto add = [&](bool has, const std::string& feature, const char* of, const std::string& value) {
    if (has) list.push_back(without(name + feature, key + of, value));
  };
  const sim::ElementInfo& element = sim::info(body.mesh.kind);
  const std::string linear(sim::info(element.linear).name), model = body.materials.front().model;
  add(body.damping.alpha > 0, "damping alpha", "damping.alpha", "0");
  add(body.damping.beta > 0, "damping beta", "damping.beta", "0");
  add(body.mass == sim::MassMatrix::consistent, "consistent mass (lumped instead)", "mass", "lumped");
  add(!body.loads.tractions.empty(), "tractions", "traction", "[]");
  add(!body.loads.pressures.empty(), "pressures", "pressure", "[]");
  add(!body.loads.forces.empty(), "forces at points", "force", "[]");
  add(body.untangle > 0, "untangling", "untangle", "0");
  // Of several bodies none would be left with a basis alone.
  add(body.basis && scene.scene.bodies.size() == 1, "basis (all nodes instead)", "basis.kind", "none");
  add(body.basis && body.basis->cubature > 0, "cubature (all elements summed)", "basis.cubature", "0");
  add(body.materials.size() > 1, "regions of other material", "region", "[]");
  add(element.order == 2, "quadratic elements (" + linear + " instead)", "mesh.element", linear);
  add(model != "linear", "nonlinear material (linear instead)", "material.model", "linear");
}

void add_obstacle_features(const Document& scene, std::vector<TradeCase>& list) {
  const auto count = static_cast<int>(scene.scene.obstacles.size());
  for (int k = 0; k < count; ++k) {
    const std::string name = "obstacle " + std::to_string(k);
    list.push_back(without(name, "obstacle", list_toml(scene, "obstacle", k)));
    if (scene.scene.obstacles[k].friction > 0)
      list.push_back(without(name + ": friction", "obstacle." + std::to_string(k) + ".friction", "0"));
  }
}

void add_contact_features(const Document& scene, std::vector<TradeCase>& list) {
  const auto count = static_cast<int>(scene.scene.contacts.size());
  for (int k = 0; k < count; ++k) {
    const std::string name = "contact " + std::to_string(k);
    list.push_back(without(name, "contact", list_toml(scene, "contact", k)));
    if (scene.scene.contacts[k].friction > 0)
      list.push_back(without(name + ": friction", "contact." + std::to_string(k) + ".friction", "0"));
  }
}

void add_step_features(const Document& scene, std::vector<TradeCase>& list) {
  const sim::Scheme& scheme = *sim::find_scheme(scene.scene.time.integrator);
  if (scheme.is_explicit()) return;
  if (scheme.order == 2)
    list.push_back(without("second order in time (backward-euler instead)", "time.integrator", "backward-euler"));
  if (scheme.order == 1 && !scheme.one_iteration && sim::serves(*sim::find_scheme("linearly-implicit"), scene.scene))
    list.push_back(without("Newton's method (linearly-implicit instead)", "time.integrator", "linearly-implicit"));
  if (scene.scene.solver.definiteness != sim::Definiteness::none)
    list.push_back(without("definiteness fix (exact tangent instead)", "solver.definiteness", "none"));
  if (scene.scene.solver.lag_iterations > 0)
    list.push_back(without("iterations of what lags (frozen for a step instead)", "solver.lag_iterations", "0"));
  list.push_back(without("tolerance (1e-2 instead)", "solver.tolerance", "1e-2"));
}

}  // namespace

std::vector<TradeCase> without_features(const Document& scene) {
  std::vector<TradeCase> list;
  if (scene.scene.world.gravity.norm() > 0)
    list.push_back(without("gravity", "world.gravity", scene.scene.dimension == 2 ? "[0.0, 0.0]" : "[0.0, 0.0, 0.0]"));
  for (std::size_t b = 0; b < scene.scene.bodies.size(); ++b) add_body_features(scene, b, list);
  add_obstacle_features(scene, list);
  add_contact_features(scene, list);
  if (!scene.scene.springs.empty()) list.push_back(without("springs", "spring", "[]"));
  add_step_features(scene, list);
  return list;
}

}  // namespace app
