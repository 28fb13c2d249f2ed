#include "app/scene/obstacle_mesh.h"

#include <algorithm>

#include "app/mesh/lines_file.h"
#include "sim/contact/skin.h"
#include "sim/element/element.h"
#include "sim/mesh/boundary.h"

namespace app {
namespace {

MeshSpec spec_of_box(const sim::Box& box, int dimension) {
  const sim::Vec3 lengths = box.high - box.low;
  if (!(lengths.head(dimension).minCoeff() > 0))
    throw sim::InputError("box", "must be [lowest corner, highest corner], the first below the second along each axis");
  MeshSpec spec;
  spec.source = dimension == 2 ? MeshSource::rectangle : MeshSource::box;
  spec.lengths.assign(lengths.data(), lengths.data() + dimension);
  spec.cells.assign(static_cast<std::size_t>(dimension), 1);
  spec.translate = box.low;
  return spec;
}

// The nodes that the faces use, and no others.
void keep_nodes_of_faces(sim::RigidSurface& surface) {
  std::vector<int> used(surface.faces.data(), surface.faces.data() + surface.faces.size());
  std::ranges::sort(used);
  used.erase(std::unique(used.begin(), used.end()), used.end());
  for (int& node : surface.faces.reshaped())
    node = static_cast<int>(std::ranges::lower_bound(used, node) - used.begin());
  surface.X = Eigen::MatrixXd(surface.X(Eigen::indexing::all, used));
}

// A plane mesh as triangles of its corners.
Eigen::Matrix3Xi corner_triangles(const sim::Mesh& mesh) {
  const Eigen::Index corners = sim::info(mesh.kind).simplex() ? 3 : 4;
  Eigen::Matrix3Xi triangles(3, (corners - 2) * mesh.element_count());
  for (Eigen::Index e = 0; e < mesh.element_count(); ++e)
    for (Eigen::Index k = 2; k < corners; ++k)
      triangles.col((corners - 2) * e + k - 2) << mesh.elements(0, e), mesh.elements(k - 1, e), mesh.elements(k, e);
  return triangles;
}

}  // namespace

sim::RigidSurface make_surface(ObstacleMesh& mesh, int dimension, std::vector<std::string>& remarks) {
  MeshSpec spec = mesh.box ? spec_of_box(*mesh.box, dimension) : mesh.spec;
  sim::Mesh made;
  std::optional<MeshLines> lines;
  if (spec.source == MeshSource::file) lines = read_lines(spec.file);
  if (lines) {
    if (dimension == 3) throw sim::InputError("mesh.file", "is made of lines, which are for 2D scenes");
    made.X = lines->X;
    made.elements.resize(3, 0);
  } else {
    made = make_mesh(spec, remarks);
  }
  if (made.dimension() > dimension)
    throw sim::InputError("mesh", "is in space, and the scene is 2D, as all its bodies are");
  place_mesh(spec, dimension, made);
  sim::RigidSurface surface{made.X, lines ? Eigen::MatrixXi(lines->lines) : sim::flat_faces(made, dimension)};
  if (dimension == 2) {
    mesh.triangles = corner_triangles(made);
  } else {
    keep_nodes_of_faces(surface);
    mesh.triangles = surface.faces;
  }
  return surface;
}

}  // namespace app
