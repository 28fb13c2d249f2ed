#include "app/picture/picture.h"

#include <algorithm>
#include <array>
#include <optional>

#include "app/picture/caption.h"
#include "app/picture/colour_values.h"
#include "app/picture/energies.h"
#include "app/picture/labels.h"
#include "app/picture/rigid_surface.h"
#include "app/picture/stage.h"

namespace app {
namespace {

// Warm red first, then colours that stay apart for colour-blind eyes (after Okabe and Ito); then six more, lighter and
// darker, for the many.
constexpr std::array<render::Colour, 12> body_colours = {{{0.80F, 0.33F, 0.25F},
                                                          {0.24F, 0.53F, 0.76F},
                                                          {0.90F, 0.65F, 0.16F},
                                                          {0.16F, 0.62F, 0.49F},
                                                          {0.75F, 0.48F, 0.64F},
                                                          {0.45F, 0.73F, 0.89F},
                                                          {0.93F, 0.83F, 0.36F},
                                                          {0.20F, 0.30F, 0.56F},
                                                          {0.55F, 0.17F, 0.22F},
                                                          {0.58F, 0.74F, 0.27F},
                                                          {0.93F, 0.50F, 0.20F},
                                                          {0.92F, 0.64F, 0.66F}}};

render::Surface still_surface(const sim::BodyRange& body, const Surface& surface, std::size_t number,
                              const Vec3& origin) {
  render::Surface still;
  still.name = body.name;
  still.triangles = surface.triangles();
  still.edges = surface.edges();
  still.outline = surface.outline();
  still.rest = surface.points(body.mesh->X, origin);
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

Picture::Picture(const sim::System& system, const Document& document, int width, int height)
    : system_(system),
      document_(document),
      stand_(stand_of(document, system)),
      aspect_(double(width) / height),
      camera_path_(system, document, aspect_, document.exhibits.empty() ? margin_in_room : margin_in_picture),
      floor_(system, document, stand_),
      arrows_(system, document, stand_.origin) {
  const Look& look = document.look;
  const bool plane = system.dimension() == 2;
  for (const sim::BodyRange& body : system.bodies()) {
    const Skin* const skin = document.meshes.empty() ? nullptr : document.meshes[surfaces_.size()].skin.get();
    if (skin != nullptr)
      surfaces_.emplace_back(*body.mesh, *skin);
    else
      surfaces_.emplace_back(*body.mesh);
    still_.surfaces.push_back(still_surface(body, surfaces_.back(), still_.surfaces.size(), stand_.origin));
    still_.surfaces.back().round = look.smooth && !plane && surfaces_.back().is_linear();
    if (look.finish == "jelly") still_.surfaces.back().finish = render::Finish::jelly;
    if (look.ghost) still_.ghosts.push_back(ghost_of(still_.surfaces.back()));
  }
  for (std::size_t k = 0; look.obstacles && k < document.scene.obstacles.size(); ++k) {
    const sim::Obstacle& obstacle = document.scene.obstacles[k];
    if (!std::holds_alternative<sim::RigidSurface>(obstacle.shape)) continue;
    still_.surfaces.push_back(still_surface(obstacle, document.obstacle_meshes[k], stand_.origin, look.smooth));
    of_obstacle_.push_back(k);
  }
  still_.title = document.title;
  still_.look = look_of(look, plane);
  still_.origin = {stand_.origin.x(), stand_.origin.y(), stand_.origin.z()};
  const auto shown = quantity(look.colour);
  if (shown) expected_reach_ = expected_reach(*shown, document.scene);
  render::Contents contents{.title = document.title, .look = still_.look};
  contents.caption = look.caption;
  contents.labels = shows_labels();
  contents.strips = look.energies ? 1 : 0;
  if (shown) contents.legend = colour_range(*shown, look, expected_reach_).scale.label;
  shows_energies_ = look.energies && render::has_room_for_strips(contents, width, height);
  if (!shows_energies_) contents.strips = 0;
  room_ = render::room_for(contents, width, height);
}

bool Picture::shows_labels() const {
  return document_.look.labels.value_or(surfaces_.size() > 1);
}

// Where the scene leaves the camera open, the bodies stand between what else is in the picture.
bool Picture::is_placed() const {
  const Camera& camera = document_.camera;
  return document_.exhibits.empty() && !camera.eye && !camera.target && !camera.height;
}

render::Frame Picture::frame(const Moment& moment) const {
  render::Frame frame = still_;
  const Look& look = document_.look;
  const int dimension = system_.dimension();
  for (std::size_t i = 0; i < surfaces_.size(); ++i) {
    const sim::BodyRange& body = system_.bodies()[i];
    const auto points = [&](const Eigen::VectorXd& nodes) {
      const Eigen::Map<const Eigen::MatrixXd> x(nodes.data() + std::ptrdiff_t{dimension} * body.first_node, dimension,
                                                body.node_count);
      return surfaces_[i].points(x, stand_.origin);
    };
    frame.surfaces[i].positions = points(moment.state.x);
    if (look.ghost && moment.full.size() > 0) frame.ghosts[i].positions = points(moment.full);
  }
  place_obstacles(moment.state, frame);
  frame.camera = camera_path_.at(moment.state);
  frame.ground = floor_.at(moment.state);
  if (is_placed()) place_in(room_, aspect_, frame.camera);
  if (moment.sheet) lay_sheet(*moment.sheet, frame);
  add_values(moment, frame);
  if (look.pins) add_pins(moment.state, frame);
  arrows_.add(moment.state, frame.arrows);
  if (shows_labels()) add_labels(surfaces_.size(), frame);
  if (shows_energies_) frame.strips.push_back(energy_strip(moment.energies, document_.scene.time.seconds));
  if (!moment.sheet) frame.caption = caption(look.caption, system_, moment);
  return frame;
}

// Surfaces of obstacles come behind those of bodies; what has been released is not there.
void Picture::place_obstacles(const sim::State& state, render::Frame& frame) const {
  if (!document_.look.obstacles) return;
  std::vector<render::Surface> shown;
  for (std::size_t k = 0, surface = surfaces_.size(); k < document_.scene.obstacles.size(); ++k) {
    const std::optional<sim::ObstacleShape> shape = system_.obstacle(state, k);
    const bool is_surface = surface < frame.surfaces.size() && of_obstacle_[surface - surfaces_.size()] == k;
    if (shape && is_surface) {
      shown.push_back(std::move(frame.surfaces[surface]));
      shown.back().positions = vertices(std::get<sim::RigidSurface>(*shape), stand_.origin);
    } else if (shape) {
      add_obstacle(*shape, stand_.origin, frame);
    }
    surface += is_surface;
  }
  frame.surfaces.resize(surfaces_.size());
  frame.surfaces.insert(frame.surfaces.end(), shown.begin(), shown.end());
}

// Beside a sheet the bodies have a part of the page. The picture's own marks give way to the sheet's.
void Picture::lay_sheet(const render::Sheet& sheet, render::Frame& frame) const {
  frame.sheet = sheet;
  if (sheet.bodies) {
    place_in(sheet.picture, aspect_, frame.camera);
    return;
  }
  frame.surfaces.clear();
  frame.ghosts.clear();
  frame.ground.reset();
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

}  // namespace app
