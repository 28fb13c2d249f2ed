// Materials: stiffness, compressibility, contrast and damping, from a scrambled start.
#include <algorithm>

#include "app/base/number_text.h"
#include "app/stress/extremes.h"

namespace app {
namespace {

std::string labelled(const std::string& label, double number) {
  std::string text = label;
  append_number(text, number);
  return text;
}

using SetMaterial = std::function<void(sim::MaterialSpec&)>;
Extreme of_materials(const std::string& name, bool quick, const SetMaterial& set) {
  return {"material", name, quick, false, [set](sim::Scene& scene) {
            scramble(scene);
            for (sim::Body& body : scene.bodies)
              for (sim::MaterialSpec& material : body.materials) set(material);
          }};
}

// Softer than 1e4 Pa, a wave takes many steps of 1/60 s: longer ones, so that the body comes to rest within the run.
Extreme stiffness(double young, bool quick) {
  Extreme extreme = of_materials(labelled("E = ", young) + " Pa", quick, [young](auto& m) { m.young = young; });
  extreme.change = [change = extreme.change, young](sim::Scene& scene) {
    change(scene);
    if (young < 1e4) set_step(scene, young < 100 ? 1 : 0.1);
  };
  return extreme;
}

// The half of each body on the high side of its longest axis gets a material of its own.
Extreme contrast(const std::string& name, bool quick, double young, double density) {
  return {"material", name, quick, false, [young, density](sim::Scene& scene) {
            scramble(scene);
            for (sim::Body& body : scene.bodies) {
              sim::Group half{"stress-half", {}, {}, {}};
              for (int e = body.mesh.element_count() / 2; e < body.mesh.element_count(); ++e)
                half.elements.push_back(e);
              if (half.elements.empty()) continue;
              body.mesh.groups.push_back(half);
              sim::MaterialSpec other = body.materials.front();
              other.group = half.name;
              other.young *= young;
              other.density *= density;
              body.materials.push_back(other);
            }
          }};
}

Extreme damped(const std::string& name, bool quick, sim::Damping damping) {
  return {"material", name, quick, false, [damping](sim::Scene& scene) {
            scramble(scene);
            for (sim::Body& body : scene.bodies) body.damping = damping;
          }};
}

}  // namespace

std::vector<Extreme> material_extremes() {
  std::vector<Extreme> all;
  for (const double young : {1.0, 1e2, 1e4, 1e6, 1e8, 1e9, 1e10, 1e12}) all.push_back(stiffness(young, young == 1e9));
  for (const double nu : {-0.5, 0.0, 0.3, 0.45, 0.49, 0.499, 0.4999})
    all.push_back(of_materials(labelled("nu = ", nu), nu == 0.499, [nu](auto& m) { m.poisson = nu; }));
  all.push_back(contrast("stiffness ratio 1e6", true, 1e6, 1));
  all.push_back(contrast("stiffness ratio 1e9", false, 1e9, 1));
  all.push_back(contrast("density ratio 1e4", false, 1, 1e-4));
  all.push_back(damped("alpha = 1e3 1/s", false, {1e3, 0}));
  all.push_back(damped("beta = 1 s", false, {0, 1}));
  all.push_back(damped("beta = 1e3 s", true, {0, 1e3}));
  all.push_back(damped("alpha = beta = 1e3", false, {1e3, 1e3}));
  return all;
}

}  // namespace app
