#include "sim/build/warnings.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "sim/build/bending.h"
#include "sim/element/element.h"
#include "sim/reduce/at_rest.h"

namespace sim {

namespace {

using Remarks = std::vector<std::string>;

// The mean extents of the elements along the axes of space [m].
Eigen::VectorXd element_extents(const Mesh& mesh) {
  Eigen::VectorXd mean = Eigen::VectorXd::Zero(mesh.X.rows());
  for (const auto& nodes : mesh.elements.colwise()) {
    const Eigen::MatrixXd X = mesh.X(Eigen::indexing::all, nodes);
    mean += (X.rowwise().maxCoeff() - X.rowwise().minCoeff()) / mesh.element_count();
  }
  return mean;
}

// The quadratic element that fills the same room.
std::string better_element(const ElementInfo& element) {
  return element.dimension == 3 ? "tet10" : "tri6";
}

std::string in_text(double number) {
  std::ostringstream text;
  text << number;
  return text.str();
}

std::string percent(double share) {
  return std::to_string(std::lround(100 * share)) + " %";
}

// An element locks near incompressibility where it is far stiffer with the material's ratio than with one of 0.3 in a
// confined block, whose elements must keep their volumes by what few nodes they have inside.
bool locks(const ElementInfo& element, double poisson) {
  constexpr double usual = 0.3, noticed = 0.1;
  const int n = element.order == 1 ? 4 : 2;  // as many nodes
  const BentBlock block{{1, 1, 1}, {n, n, n}, true};
  return bending_excess(element.kind, block, poisson) - bending_excess(element.kind, block, usual) > noticed;
}

void warn_of_locking(const Parts& parts, const Body& body, Remarks& remarks) {
  const ElementInfo& element = info(body.mesh.kind);
  constexpr double nearly_incompressible = 0.48;
  if (element.dimension < parts.model.D) return;
  for (const MaterialSpec& material : body.materials) {
    if (material.poisson < nearly_incompressible || !locks(element, material.poisson)) continue;
    remarks.push_back("locking: \"" + body.name + "\" has linear elements (" + std::string(element.name) +
                      ") and Poisson's ratio " + in_text(material.poisson) +
                      ": it will bend too little (a block of two of them a side is " +
                      percent(bending_excess(element.kind, {}, material.poisson)) + " too stiff); use element = \"" +
                      better_element(element) + "\"");
  }
}

// A piece of a slender body, as long as its elements and as high as the body.
BentBlock piece_of(const Mesh& mesh, Eigen::Index along, Eigen::Index up) {
  const Eigen::VectorXd height = mesh.X.rowwise().maxCoeff() - mesh.X.rowwise().minCoeff(),
                        size = element_extents(mesh);
  constexpr double most = 4;  // more of them across change little
  BentBlock block;
  block.lengths = Vec3(size[along] / height[up], 1, 1);
  if (mesh.X.rows() == 3) block.lengths[2] = size[3 - along - up] / height[up];
  block.cells = {1, static_cast<int>(std::clamp(std::round(height[up] / size[up]), 1.0, most)), 1};
  return block;
}

// Linear elements answer a curvature with a shear that bending has not, which is the larger, the longer they are beside
// the height of the body. [Cook et al. 2002, 6.6: parasitic shear]
void warn_of_slender_bending(const Parts& parts, const Body& body, Remarks& remarks) {
  const ElementInfo& element = info(body.mesh.kind);
  const Eigen::VectorXd extent = body.mesh.X.rowwise().maxCoeff() - body.mesh.X.rowwise().minCoeff();
  Eigen::Index along = 0, up = 0;
  const double length = extent.maxCoeff(&along), height = extent.minCoeff(&up);
  constexpr double slender = 5, noticed = 0.1, usual = 0.3;
  if (element.dimension < parts.model.D || length < slender * height) return;
  const BentBlock piece = piece_of(body.mesh, along, up);
  const double excess = bending_excess(element.kind, piece, std::min(body.materials[0].poisson, usual));
  if (excess < noticed) return;
  remarks.push_back("locking: \"" + body.name + "\" is slender, and its elements (" + std::string(element.name) +
                    ") are " + in_text(piece.lengths[0]) +
                    " times as long as it is high: it will bend too little (a piece of it is " + percent(excess) +
                    " too stiff); use element = \"" + better_element(element) + "\" or more cells");
}

void warn_of_nothing_to_move(const Parts& parts, Remarks& remarks) {
  if (parts.model.bodies.empty()) return;
  Eigen::VectorXd free(parts.model.dofs());
  parts.model.pins.mark(0, free);
  if (free.sum() == 0 && parts.model.pins.released(1e30) == 0)
    remarks.push_back("pins: every component of every node is prescribed, so nothing is left to move by itself");
}

void warn_of_disagreeing_pins(const Parts& parts, Remarks& remarks) {
  const Model& model = parts.model;
  if (const auto clash = model.pins.clash(model.node_size, model.body_nodes))
    remarks.push_back("pins: " + clash->first.text + " and " + clash->second.text +
                      " prescribe other places for the same nodes, from t = " + in_text(clash->t) + " s on and there " +
                      in_text(clash->distance) + " m apart; the one that stands later in the scene has its way");
  constexpr double noticed = 1e-6;  // of the smallest body
  const auto jump = model.pins.first_jump(model.body_nodes);
  if (!model.bodies.empty() && jump.distance > noticed * model.node_size.head(model.body_nodes).minCoeff())
    remarks.push_back(
        "pins: the script of " + jump.first.text + " begins " + in_text(jump.distance) +
        " m from where its nodes are at rest, so the first frame shows them there already and the rest of "
        "the body not");
}

// lambda < 0 where nu < 0: lambda/2 (J - 1)^2 falls without end as J grows, lambda/2 ln(J)^2 as J -> 0.
void warn_of_falling_energy(const Body& body, Remarks& remarks) {
  for (const MaterialSpec& material : body.materials)
    if (material.poisson < 0 && (material.model == "fixed-corotated" || material.model == "neo-hookean"))
      remarks.push_back("energy: with Poisson's ratio below 0 that of " + material.model +
                        " has no least value, so \"" + body.name +
                        "\" may run away when much deformed; stable-neo-hookean and corotated have one");
}

void warn_of_mass_solve(const Parts& parts, Remarks& remarks) {
  const auto consistent = [](const Mass& mass) { return !mass.lumped(); };
  if (parts.scheme->is_explicit() && std::any_of(parts.model.masses.begin(), parts.model.masses.end(), consistent))
    remarks.push_back("consistent mass in an explicit scheme: every step solves a linear system with M");
}

// Bending shortens a beam. What moves along vibration modes alone cannot get shorter, and is stretched instead.
void warn_of_turning_modes(const Parts& parts, Remarks& remarks) {
  constexpr double noticed = 0.05;  // of the body's size
  const Model& model = parts.model;
  const auto in_modes = [](const Body& body) { return body.basis && body.basis->kind == BasisKind::modes; };
  if (!parts.reduction || std::none_of(model.bodies.begin(), model.bodies.end(), in_modes)) return;
  const AtRest rest(*parts.reduction);
  const Eigen::VectorXd u = rest.displacement(*parts.reduction, rest.f);
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    if (!in_modes(model.bodies[b])) continue;
    const BodyRange& range = model.ranges[b];
    const auto own = u.segment(Eigen::Index{range.first_node} * model.D, Eigen::Index{range.node_count} * model.D);
    const double share = own.reshaped(model.D, range.node_count).colwise().norm().maxCoeff() / range.size;
    if (share > noticed)
      remarks.push_back(
          "basis: the loads at the start bend \"" + range.name + "\" by " + percent(share) +
          " of its size, and vibration modes alone are far too stiff where a body turns: 40 of them leave "
          "2.3 % of a beam's length where 2 modes and their 3 derivatives leave 0.03 %; take kind = "
          "\"derivatives\"");
  }
}

}  // namespace

std::vector<std::string> warnings(const Parts& parts) {
  Remarks remarks;
  for (const Body& body : parts.model.bodies) {
    warn_of_locking(parts, body, remarks);
    warn_of_slender_bending(parts, body, remarks);
    warn_of_falling_energy(body, remarks);
  }
  warn_of_turning_modes(parts, remarks);
  warn_of_mass_solve(parts, remarks);
  warn_of_nothing_to_move(parts, remarks);
  warn_of_disagreeing_pins(parts, remarks);
  return remarks;
}

}  // namespace sim
