#include "app/scene/scene_identity.h"

#include <algorithm>

#include "app/scene/scene_text.h"
#include "sim/math/checksum.h"

namespace app {
namespace {

template <typename Matrix>
std::uint64_t checksum_of(const Matrix& matrix, std::uint64_t before) {
  const auto bytes = static_cast<std::size_t>(matrix.size()) * sizeof(typename Matrix::Scalar);
  return sim::checksum({reinterpret_cast<const char*>(matrix.data()), bytes}, before);
}

// The nodes and elements themselves: a mesh file may change while its name stays.
std::uint64_t checksum_of_mesh(const sim::Mesh& mesh, std::uint64_t before) {
  std::uint64_t sum = checksum_of(mesh.elements, checksum_of(mesh.X, before));
  for (const sim::Group& group : mesh.groups) {
    sum = sim::checksum(group.name, sum);
    for (const std::vector<int>* list : {&group.nodes, &group.elements}) {
      sum = checksum_of(Eigen::Map<const Eigen::VectorXi>(list->data(), static_cast<Eigen::Index>(list->size())), sum);
    }
    sum = checksum_of(group.facets, sum);
  }
  return sum;
}

}  // namespace

std::uint64_t scene_identity(const Document& document) {
  Document simulated = document;
  simulated.title.clear();
  simulated.camera = {};
  simulated.look = {};
  simulated.exhibits.clear();
  simulated.scene.time.seconds = sim::Time{}.seconds;
  // Files may lie elsewhere and be the same.
  for (MeshSpec& mesh : simulated.meshes) {
    mesh.file = mesh.file.filename();
    mesh.wears_surface = false;
    mesh.skin_file.clear();
  }
  for (ObstacleMesh& mesh : simulated.obstacle_meshes) mesh.spec.file = mesh.spec.file.filename();
  for (std::filesystem::path& file : simulated.start_files) file.clear();  // the nodes themselves are told
  for (std::filesystem::path& folder : simulated.basis_folders) folder.clear();
  std::ranges::fill(simulated.without_basis, 0);
  std::uint64_t sum = sim::checksum(scene_json(simulated, {}));
  for (const sim::Body& body : document.scene.bodies) sum = checksum_of_mesh(body.mesh, sum);
  for (const sim::Body& body : document.scene.bodies)
    if (body.basis && body.basis->snapshots) sum = checksum_of(*body.basis->snapshots, sum);
  for (const sim::Obstacle& obstacle : document.scene.obstacles)
    if (const auto* surface = std::get_if<sim::RigidSurface>(&obstacle.shape))
      sum = checksum_of(surface->faces, checksum_of(surface->X, sum));
  return sum;
}

std::uint64_t basis_identity(const Document& document) {
  Document bases = document;
  // What trains a cubature is a body alone, which swings in steps of its own.
  bases.scene.time = {};
  bases.scene.solver = {};
  bases.scene.obstacles.clear();
  bases.obstacle_meshes.clear();
  bases.scene.contacts.clear();
  bases.scene.springs.clear();
  bases.scene.probes.clear();
  bases.references.clear();
  return scene_identity(bases);
}

}  // namespace app
