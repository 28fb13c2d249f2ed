#include "app/exhibit/mesh_drawing.h"

#include "app/exhibit/draw.h"
#include "sim/element/element.h"
#include "sim/mesh/boundary.h"

namespace app {

Eigen::MatrixXd corners(const sim::Mesh& mesh, int element, const Eigen::MatrixXd& x) {
  const int count = sim::info(mesh.kind).corners;
  Eigen::MatrixXd at(2, count);
  for (int a = 0; a < count; ++a) at.col(a) = x.col(mesh.elements(a, element));
  return at;
}

void add_elements(const sim::Mesh& mesh, const Eigen::MatrixXd& x, const std::function<std::array<int, 3>(int)>& colour,
                  bool edges, render::Diagram& diagram) {
  for (int e = 0; e < mesh.element_count(); ++e) {
    const std::vector<render::Spot> outline = polygon(corners(mesh, e, x));
    diagram.patches.push_back({outline, colour(e)});
    if (edges) diagram.strokes.push_back({outline, render::Ink::black, true});
  }
}

void add_outline(const sim::Mesh& mesh, const Eigen::MatrixXd& x, render::Ink ink, render::Diagram& diagram) {
  const Eigen::MatrixXi facets = sim::boundary_facets(mesh);
  for (Eigen::Index k = 0; k < facets.cols(); ++k)
    diagram.strokes.push_back({{spot(x.col(facets(0, k))), spot(x.col(facets(1, k)))}, ink});
}

}  // namespace app
