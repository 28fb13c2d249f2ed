#include "sim/build/warnings.h"

#include <algorithm>

#include "sim/element/element.h"

namespace sim {

namespace {

// Linear simplices lock where the material hardly changes its volume: they bend too little. [Hughes 1987, 4.4]
void warn_of_locking(Parts& parts, const Body& body) {
  const ElementInfo& element = info(body.mesh.kind);
  if (element.order != 1 || !element.simplex() || !element.quadratic || element.dimension < parts.model.D) return;
  for (const MaterialSpec& material : body.materials)
    if (material.poisson >= 0.48)
      parts.remarks.push_back("locking: \"" + body.name + "\" has linear elements (" + std::string(element.name) +
                              ") and Poisson's ratio " + std::to_string(material.poisson) +
                              " >= 0.48: it will bend too little; use element = \"" +
                              std::string(info(*element.quadratic).name) + "\"");
}

// lambda < 0 where nu < 0: lambda/2 (J - 1)^2 falls without end as J grows, lambda/2 ln(J)^2 as J -> 0.
void warn_of_falling_energy(Parts& parts, const Body& body) {
  for (const MaterialSpec& material : body.materials)
    if (material.poisson < 0 && (material.model == "fixed-corotated" || material.model == "neo-hookean"))
      parts.remarks.push_back("energy: with Poisson's ratio below 0 that of " + material.model +
                              " has no least value, so \"" + body.name +
                              "\" may run away when much deformed; stable-neo-hookean and corotated have one");
}

void warn_of_mass_solve(Parts& parts) {
  const auto consistent = [](const Mass& mass) { return !mass.lumped(); };
  if (parts.scheme->is_explicit() && std::any_of(parts.model.masses.begin(), parts.model.masses.end(), consistent))
    parts.remarks.push_back("consistent mass in an explicit scheme: every step solves a linear system with M");
}

}  // namespace

void warn(Parts& parts) {
  for (const Body& body : parts.model.bodies) {
    warn_of_locking(parts, body);
    warn_of_falling_energy(parts, body);
  }
  warn_of_mass_solve(parts);
}

}  // namespace sim
