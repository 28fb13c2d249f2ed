// Meshes: thin and bad elements, sizes from dust to mountains, one element, many parts; from a squashed start.
#include "app/stress/extremes.h"
#include "sim/mesh/spoil.h"
#include "sim/mesh/transform.h"

namespace app {
namespace {

void squash(sim::Scene& scene) {
  for (sim::Body& body : scene.bodies) {
    body.start.shape = "squashed";
    body.start.amount = 0.3;
  }
}

Extreme of_meshes(const std::string& name, bool quick, const std::function<void(sim::Mesh&)>& spoil) {
  return {"mesh", name, quick, false, [spoil](sim::Scene& scene) {
            squash(scene);
            for (sim::Body& body : scene.bodies) spoil(body.mesh);
          }};
}

// The same scene in other units of length: c = sqrt(E/rho) and h must go with the size.
Extreme scaled(const std::string& name, bool quick, double factor) {
  return {"mesh", name, quick, false, [factor](sim::Scene& scene) {
            scramble(scene);
            for (sim::Body& body : scene.bodies) {
              sim::scale(body.mesh, sim::Vec3::Constant(factor));
              body.thickness *= factor;
              for (sim::MaterialSpec& material : body.materials) material.young *= factor * factor;
            }
          }};
}

}  // namespace

std::vector<Extreme> mesh_extremes() {
  std::vector<Extreme> all;
  for (const auto& [name, ratio] :
       {std::pair{"aspect 10", 10.0}, {"aspect 100", 1e2}, {"aspect 1e3", 1e3}, {"aspect 1e4", 1e4}})
    all.push_back(of_meshes(name, ratio == 1e3, [ratio](sim::Mesh& mesh) { sim::lengthen(mesh, ratio); }));
  all.push_back(of_meshes("slivers 1e-3", true, [](sim::Mesh& mesh) { sim::make_slivers(mesh, 1e-3); }));
  all.push_back(of_meshes("slivers 1e-6", false, [](sim::Mesh& mesh) { sim::make_slivers(mesh, 1e-6); }));
  all.push_back(scaled("size x 1e-6", true, 1e-6));
  all.push_back(scaled("size x 1e-3", false, 1e-3));
  all.push_back(scaled("size x 1e3", false, 1e3));
  all.push_back(scaled("size x 1e6", false, 1e6));
  all.push_back(of_meshes("one element", false, [](sim::Mesh& mesh) { sim::disconnect(mesh, 1); }));
  all.push_back(of_meshes("100 parts", false, [](sim::Mesh& mesh) { sim::disconnect(mesh, 100); }));
  return all;
}

}  // namespace app
