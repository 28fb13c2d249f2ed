// Bending: a body held at one end under its own weight, ever less compressible. Elements that lock hang too high: that
// is seen where the distances of the beams are compared.
#include "app/base/number_text.h"
#include "app/stress/extremes.h"

namespace app {
namespace {

// The weight at which a straight beam of this length and thickness has its tip a tenth of its length below.
// w L^4/(8 E I) = L/10, w = rho g A, I = A t^2/12: g = E t^2/(15 rho L^3) [m/s^2]
double weight(const sim::Scene& scene, const Ends& ends) {
  const sim::MaterialSpec& material = scene.bodies.front().materials.front();
  return material.young * ends.thickness * ends.thickness /
         (15 * material.density * ends.length * ends.length * ends.length);
}

Extreme bent(double nu) {
  std::string name = "nu = ";
  append_number(name, nu);
  return {"bending", name, false, true, [nu](sim::Scene& scene) {
            const Ends ends = ends_of(scene);
            sim::Pin held;
            held.where = ends.low;
            scene.bodies.front().pins = {held};
            scene.world.gravity = -weight(scene, ends) * ends.across;
            for (sim::Body& body : scene.bodies)
              for (sim::MaterialSpec& material : body.materials) material.poisson = nu;
            // Minutes: what counts is where it comes to rest.
            if (scene.time.substeps == 1) set_step(scene, 60);
          }};
}

}  // namespace

std::vector<Extreme> bending_extremes() {
  std::vector<Extreme> all;
  for (const double nu : {0.3, 0.49, 0.499, 0.4999}) all.push_back(bent(nu));
  return all;
}

}  // namespace app
