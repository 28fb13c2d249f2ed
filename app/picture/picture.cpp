#include "app/picture/picture.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "app/picture/caption.h"
#include "app/picture/colour_values.h"
#include "app/picture/energies.h"
#include "app/picture/stage.h"

namespace app {
namespace {

// Warm red first, then colours that stay apart for colour-blind eyes (after Okabe and Ito).
constexpr std::array<render::Colour, 6> body_colours = {{{0.80F, 0.33F, 0.25F},
                                                         {0.24F, 0.53F, 0.76F},
                                                         {0.90F, 0.65F, 0.16F},
                                                         {0.16F, 0.62F, 0.49F},
                                                         {0.75F, 0.48F, 0.64F},
                                                         {0.45F, 0.73F, 0.89F}}};

render::Surface still_surface(const sim::BodyRange& body, const Surface& surface, std::size_t number) {
  render::Surface still;
  still.name = body.name;
  still.triangles = surface.triangles();
  still.edges = surface.edges();
  still.outline = surface.outline();
  still.rest = surface.points(body.mesh->X);
  still.crease = 60;  // of coarse meshes as well: what is meant as an edge is sharper
  still.flat = body.mesh->dimension() == 2;
  still.colour = body_colours[number % body_colours.size()];
  return still;
}

render::Surface ghost_of(const render::Surface& surface) {
  render::Surface ghost = surface;
  ghost.positions = surface.rest;
  ghost.colour = {0.55F, 0.60F, 0.66F};
  ghost.edges.clear();
  return ghost;
}

render::Look look_of(const Look& look, bool plane) {
  render::Look shown;
  const bool paper = look.background ? *look.background == "paper" : plane || look.style == "lecture";
  shown.background = paper ? render::Background::paper : render::Background::studio;
  shown.wireframe = look.wireframe;
  shown.shadow = shown.occlusion = look.shadows;
  shown.axes = look.axes;
  shown.scale_bar = look.scale_bar;
  shown.lecture = look.style == "lecture";
  return shown;
}

}  // namespace

Picture::Picture(const sim::System& system, const Document& document, double aspect)
    : system_(system),
      document_(document),
      aspect_(aspect),
      camera_path_(system, document, aspect),
      arrows_(system, document) {
  const Look& look = document.look;
  const bool plane = system.dimension() == 2;
  for (const sim::BodyRange& body : system.bodies()) {
    surfaces_.emplace_back(*body.mesh);
    still_.surfaces.push_back(still_surface(body, surfaces_.back(), still_.surfaces.size()));
    still_.surfaces.back().round = look.smooth && !plane && surfaces_.back().is_linear();
    if (look.finish == "jelly") still_.surfaces.back().finish = render::Finish::jelly;
    if (look.ghost) still_.ghosts.push_back(ghost_of(still_.surfaces.back()));
  }
  if (!plane) {
    still_.ground = ground_of(look, document.camera.up, rest_box(system.bodies()), document.scene.obstacles);
  }
  if (look.obstacles) add_obstacles(document.scene.obstacles, still_);
  still_.title = document.title;
  still_.look = look_of(look, plane);
  if (const auto shown = quantity(look.colour)) expected_reach_ = expected_reach(*shown, document.scene);
}

render::Frame Picture::frame(const Moment& moment) const {
  render::Frame frame = still_;
  const Look& look = document_.look;
  const int dimension = system_.dimension();
  for (std::size_t i = 0; i < surfaces_.size(); ++i) {
    const sim::BodyRange& body = system_.bodies()[i];
    const Eigen::Map<const Eigen::MatrixXd> x(moment.state.x.data() + std::ptrdiff_t{dimension} * body.first_node,
                                              dimension, body.node_count);
    frame.surfaces[i].positions = surfaces_[i].points(x);
  }
  frame.camera = camera_path_.at(moment.state);
  if (moment.sheet) lay_sheet(*moment.sheet, frame);
  add_values(moment, frame);
  if (look.pins) add_pins(moment.state, frame);
  arrows_.add(moment.state, frame.arrows);
  if (look.labels.value_or(surfaces_.size() > 1)) add_labels(frame);
  if (look.energies) frame.strips.push_back(energy_strip(moment.energies, document_.scene.time.seconds));
  if (!moment.sheet) frame.caption = caption(look.caption, system_, moment);
  return frame;
}

// Beside a sheet the bodies have a part of the page: what the whole picture would show is seen smaller, and its middle
// is the middle of that part. The picture's own marks give way to the sheet's.
void Picture::lay_sheet(const render::Sheet& sheet, render::Frame& frame) const {
  frame.sheet = sheet;
  if (!sheet.bodies) {
    frame.surfaces.clear();
    frame.ghosts.clear();
    frame.ground.reset();
    return;
  }
  const render::Box& part = sheet.picture;
  const double share = std::min(part.right - part.left, part.bottom - part.top);
  render::Camera& camera = frame.camera;
  const auto vector = [](const render::Point& p) { return Vec3(p[0], p[1], p[2]); };
  const Vec3 arm = vector(camera.eye) - vector(camera.target);
  double extent = camera.height / share;  // visible height at the target, m
  if (!camera.orthographic) {
    const double half = std::tan(camera.field_of_view * std::numbers::pi / 360) / share;
    camera.field_of_view = static_cast<float>(2 * std::atan(half) * 180 / std::numbers::pi);
    extent = 2 * half * arm.norm();
  }
  const Vec3 right = vector(camera.up).cross(arm).normalized(), up = arm.cross(right).normalized();
  const Vec3 shift = (0.5 - (part.left + part.right) / 2) * aspect_ * extent * right -
                     (0.5 - (part.top + part.bottom) / 2) * extent * up;
  const Vec3 target = vector(camera.target) + shift;
  camera.height = static_cast<float>(extent);
  camera.target = to_point(target);
  camera.eye = to_point(target + arm);
}

void Picture::add_values(const Moment& moment, render::Frame& frame) const {
  const std::optional<sim::Quantity> shown = quantity(document_.look.colour);
  if (!shown) return;
  const Eigen::VectorXd values = system_.node_values(moment.state, *shown);
  const double reach = std::max({expected_reach_, moment.largest, reach_of(*shown, values)});
  const ColourRange range = colour_range(*shown, document_.look, reach);
  frame.scale = range.scale;
  for (std::size_t i = 0; i < surfaces_.size(); ++i) {
    const sim::BodyRange& body = system_.bodies()[i];
    // Beyond the ends of the scale there are no other colours, but perhaps numbers that a picture cannot hold.
    const Eigen::VectorXd shown_values = (range.factor * values.segment(body.first_node, body.node_count))
                                             .cwiseMax(double(range.scale.low))
                                             .cwiseMin(double(range.scale.high));
    frame.surfaces[i].values = surfaces_[i].values(shown_values);
  }
}

void Picture::add_pins(const sim::State& state, render::Frame& frame) const {
  const std::vector<int> pinned = system_.pinned_nodes(system_.time(state.step));
  for (std::size_t i = 0; i < surfaces_.size(); ++i) {
    for (const int node : pinned) {
      const int vertex = surfaces_[i].vertex_of(node - system_.bodies()[i].first_node);
      if (vertex < 0) continue;
      const float* at = frame.surfaces[i].positions.data() + std::ptrdiff_t{3} * vertex;
      frame.markers.push_back({.at = {at[0], at[1], at[2]}});
    }
  }
}

// Above the point that is highest on the screen, in the middle of the body.
void Picture::add_labels(render::Frame& frame) const {
  const auto vector = [](const render::Point& p) { return Eigen::Vector3f(p[0], p[1], p[2]); };
  const Eigen::Vector3f ahead = (vector(frame.camera.target) - vector(frame.camera.eye)).normalized();
  const Eigen::Vector3f world_up = vector(frame.camera.up);
  const Eigen::Vector3f up = (world_up - world_up.dot(ahead) * ahead).normalized();
  for (const render::Surface& surface : frame.surfaces) {
    const Eigen::Map<const Eigen::Matrix3Xf> points(surface.positions.data(), 3,
                                                    static_cast<Eigen::Index>(surface.positions.size() / 3));
    if (points.cols() == 0) continue;
    const Eigen::Vector3f middle = points.rowwise().mean();
    const Eigen::Vector3f top = middle + ((up.transpose() * points).maxCoeff() - up.dot(middle)) * up;
    frame.labels.push_back({{top.x(), top.y(), top.z()}, surface.name});
  }
}

}  // namespace app
