#include "app/record/start_picture.h"

#include <iostream>

#include "app/base/output_file.h"
#include "app/picture/rigid_surface.h"
#include "app/picture/stage.h"
#include "app/record/frame_renderer.h"
#include "app/run/run_start.h"
#include "app/scene/scene_file.h"
#include "render/png.h"
#include "sim/body/pose.h"

namespace app {
namespace {

constexpr render::Colour wrong_colour{0.86F, 0.07F, 0.24F};

// Takes the obstacles that are surfaces out of the scene: the system refuses them. They are drawn all the same.
std::vector<render::Surface> taken_out(Document& document, const Vec3& origin) {
  std::vector<render::Surface> surfaces;
  std::vector<sim::Obstacle>& obstacles = document.scene.obstacles;
  for (std::size_t k = obstacles.size(); k-- > 0;) {
    const auto* shape = std::get_if<sim::RigidSurface>(&obstacles[k].shape);
    if (shape == nullptr) continue;
    const sim::Pose pose(obstacles[k].motion, 0);
    sim::RigidSurface placed = *shape;
    for (Eigen::Index i = 0; i < placed.X.cols(); ++i) {
      Vec3 at = Vec3::Zero();
      at.head(placed.X.rows()) = placed.X.col(i);
      placed.X.col(i) = pose.place(at).head(placed.X.rows());
    }
    surfaces.push_back(still_surface(obstacles[k], document.obstacle_meshes[k], origin, document.look.smooth));
    surfaces.back().positions = vertices(placed, origin);
    const auto number = static_cast<std::ptrdiff_t>(k);
    obstacles.erase(obstacles.begin() + number);
    document.obstacle_meshes.erase(document.obstacle_meshes.begin() + number);
  }
  return surfaces;
}

render::Image picture_of(const Options& options, const std::vector<sim::Vec3>& places) {
  Document document = load_scene(options.scene, options.settings, options.overrides);
  document.scene.contacts.clear();
  document.look.wireframe = true;  // dots lie where surfaces hide each other
  const Vec3 origin = Vec3::Zero();
  const std::vector<render::Surface> obstacles = taken_out(document, origin);
  const std::shared_ptr<const sim::System> system = build_system(document, options.threads);
  const FrameSize size(options);
  const Picture picture(*system, document, size.width, size.height);
  Moment moment;
  moment.state = system->initial_state();
  render::Frame frame = picture.frame(moment);
  for (render::Surface surface : obstacles) {
    for (std::size_t i = 0; i < surface.positions.size(); ++i)
      surface.positions[i] -= static_cast<float>(picture.origin()[static_cast<Eigen::Index>(i % 3)]);
    frame.surfaces.push_back(std::move(surface));
  }
  for (const Vec3& place : places) frame.markers.push_back({to_point(place - picture.origin()), wrong_colour});
  const auto context = render::make_offscreen_context(options.context);
  render::Renderer renderer(*context, size.width, size.height, size.samples);
  return renderer.draw(frame);
}

}  // namespace

void draw_start(const Options& options, const std::vector<sim::Vec3>& places) {
  const RunFolder folder = open_run_folder(options);
  make_folder(folder.path());
  make_folder(folder.frames());
  write_atomically(folder.frame(0), as_text(render::encode_png(picture_of(options, places))), false);
  if (!options.quiet) std::cerr << "where they do, as dots: " << folder.frame(0).string() << '\n';
}

}  // namespace app
