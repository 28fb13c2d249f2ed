#include "app/scene/snapshots.h"

#include <algorithm>
#include <string>
#include <vector>

#include "app/base/folder.h"
#include "app/mesh/contents.h"
#include "app/mesh/error.h"
#include "app/mesh/vtu.h"

namespace app {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> vtu_files(const fs::path& run) {
  if (const std::string why = why_no_folder(run); !why.empty()) throw FileError(run.string() + ": " + why);
  std::vector<fs::path> files;
  std::error_code none;
  for (const fs::directory_entry& entry : fs::directory_iterator(run / "vtu", none))
    if (entry.path().extension() == ".vtu") files.push_back(entry.path());
  std::ranges::sort(files);
  if (files.empty())
    throw FileError(run.string() +
                    ": holds no vtu/*.vtu, which `ritz run --vtu` leaves; they are the states of the run");
  return files;
}

// The first of the body's nodes among those of a file.
Eigen::Index first_node(const sim::Scene& scene, std::size_t body, Eigen::Index nodes, const fs::path& file) {
  Eigen::Index before = 0, all = 0;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    if (b == body) before = all;
    all += scene.bodies[b].mesh.node_count();
  }
  const Eigen::Index own = scene.bodies[body].mesh.node_count();
  if (nodes == all) return before;
  if (nodes == own) return 0;
  throw FileError(file.string() + ": has " + std::to_string(nodes) + " nodes, and \"" + scene.bodies[body].name +
                  "\" has " + std::to_string(own) + ": it is the run of another mesh");
}

}  // namespace

std::shared_ptr<const Eigen::MatrixXd> read_snapshots(const fs::path& run, const sim::Scene& scene, std::size_t body) {
  const std::vector<fs::path> files = vtu_files(run);
  const sim::Mesh& mesh = scene.bodies[body].mesh;
  const Eigen::Index D = scene.dimension, nodes = mesh.node_count();
  Eigen::MatrixXd rest = Eigen::MatrixXd::Zero(D, nodes);
  rest.topRows(mesh.dimension()) = mesh.X;
  auto all = std::make_shared<Eigen::MatrixXd>(D * nodes, std::ssize(files));
  for (std::size_t k = 0; k < files.size(); ++k) {
    const std::vector<double> points = read_vtu_points(read_contents(files[k]), files[k].string());
    const auto count = static_cast<Eigen::Index>(points.size() / 3);
    const Eigen::Map<const Eigen::Matrix3Xd> x(points.data(), 3, count);
    const auto own = x.middleCols(first_node(scene, body, count, files[k]), nodes);
    all->col(static_cast<Eigen::Index>(k)) = (own.topRows(D) - rest).reshaped();
  }
  if (!all->allFinite()) throw FileError(run.string() + ": a state holds a number that is not finite");
  return all;
}

std::vector<std::int64_t> snapshot_frames(const fs::path& run) {
  std::vector<std::int64_t> frames;
  for (const fs::path& file : vtu_files(run)) {
    const std::string name = file.stem().string(), digits = name.substr(name.find_last_not_of("0123456789") + 1);
    if (digits.empty() || digits.size() > 12) throw FileError(file.string() + ": its name has no number of a frame");
    frames.push_back(std::stoll(digits));
  }
  return frames;
}

}  // namespace app
