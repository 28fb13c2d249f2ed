#include "app/trade/comparison.h"

#include <algorithm>
#include <stdexcept>

#include "app/base/version.h"
#include "app/picture/stage.h"
#include "sim/math/checksum.h"

namespace app {
namespace {

constexpr int frame_width = 1920, frame_height = 1080;
constexpr std::int64_t most_numbers = 1 << 19;  // of a trajectory that is kept: 4 MB
constexpr std::int64_t least_frames = 24;       // ... but so many frames

render::View screen_of(const Simulation& simulation) {
  const Eigen::AlignedBox3d box = rest_box(simulation.system->bodies());
  const double aspect = double(frame_width) / frame_height;
  render::Bounds bounds;
  bounds.add(render::to_vector(to_point(box.min())));
  bounds.add(render::to_vector(to_point(box.max())));
  const Stand stand{up_of(simulation.document.camera, simulation.document.scene.world.gravity)};
  return render::make_view(view_of(simulation.document.camera, stand, box, simulation.system->dimension(), aspect),
                           static_cast<float>(aspect), bounds);
}

}  // namespace

double Comparison::seconds() const {
  return double(stretch.last) / scene.document.scene.time.fps;
}

Comparison make_comparison(const Options& options) {
  Comparison comparison{options, build_simulation(options), {}, {}, {}};
  require_bodies(comparison.scene.document);
  if (comparison.scene.document.scene.time.integrator == "static")
    throw std::runtime_error(options.scene.string() +
                             ": time.integrator = \"static\": there is no motion to trade; --set "
                             "time.integrator=backward-euler steps it");
  comparison.points = sim::sample_points(*comparison.scene.system);
  comparison.points.ride_on_nearest = std::ranges::any_of(
      comparison.scene.document.meshes, [](const MeshSpec& mesh) { return mesh.source == MeshSource::surface; });
  comparison.view = screen_of(comparison.scene);
  comparison.stretch = stretch_of(comparison, comparison.scene.last_frame());
  return comparison;
}

Stretch stretch_of(const Comparison& comparison, std::int64_t frames) {
  frames = std::clamp<std::int64_t>(frames, 1, std::max<std::int64_t>(comparison.scene.last_frame(), 1));
  const std::int64_t numbers = comparison.points.X.size();
  const std::int64_t most = std::max(least_frames, most_numbers / std::max<std::int64_t>(numbers, 1));
  const std::int64_t stride = (frames + most - 1) / most;
  return {frames / stride * stride, stride};
}

std::uint64_t case_id(const Comparison& comparison, std::uint64_t scene, int threads) {
  std::string text(ritz_version);
  if (threads != comparison.options.threads) text += " threads " + std::to_string(threads);
  for (const std::uint64_t number : {comparison.scene.identity, scene, std::uint64_t(comparison.stretch.last),
                                     std::uint64_t(comparison.stretch.stride)})
    text += ' ' + std::to_string(number);
  return sim::checksum(text);
}

sim::Trajectory on_screen(const Comparison& comparison, const sim::Trajectory& path) {
  sim::Trajectory screen;
  screen.dimension = 2;
  screen.t = path.t;
  for (const Eigen::VectorXd& x : path.x) {
    Eigen::VectorXd pixels(2 * comparison.points.count());
    for (int p = 0; p < comparison.points.count(); ++p) {
      Eigen::Vector3f point = Eigen::Vector3f::Zero();
      point.head(path.dimension) = x.segment(Eigen::Index(p) * path.dimension, path.dimension).cast<float>();
      pixels.segment<2>(2 * Eigen::Index(p)) =
          comparison.view.to_window(point, frame_width, frame_height).head<2>().cast<double>();
    }
    screen.x.push_back(std::move(pixels));
  }
  return screen;
}

sim::SamplePoints screen_points(const Comparison& comparison) {
  sim::SamplePoints points = comparison.points;
  points.dimension = 2;
  points.size.setOnes();
  return points;
}

}  // namespace app
