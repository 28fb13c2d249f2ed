#include "app/picture.h"

#include <algorithm>
#include <array>
#include <limits>

#include "app/caption.h"
#include "app/colour_values.h"
#include "app/view.h"

namespace app {
namespace {

// Warm red first, then colours that stay apart for colour-blind eyes (after Okabe and Ito).
constexpr std::array<render::Colour, 6> kBodyColours = {{{0.80F, 0.33F, 0.25F},
                                                         {0.24F, 0.53F, 0.76F},
                                                         {0.90F, 0.65F, 0.16F},
                                                         {0.16F, 0.62F, 0.49F},
                                                         {0.75F, 0.48F, 0.64F},
                                                         {0.45F, 0.73F, 0.89F}}};

double softest_young(const sim::Scene& scene) {
  double young = std::numeric_limits<double>::infinity();
  for (const sim::Body& body : scene.bodies) {
    for (const sim::MaterialSpec& material : body.materials) young = std::min(young, material.young);
  }
  return young;
}

render::Surface still_surface(const sim::BodyRange& body, const Surface& surface, std::size_t number) {
  render::Surface still;
  still.name = body.name;
  still.triangles = surface.triangles();
  still.edges = surface.edges();
  still.outline = surface.outline();
  still.rest = surface.points(body.mesh->X);
  still.flat = body.mesh->dimension() == 2;
  still.colour = kBodyColours[number % kBodyColours.size()];
  return still;
}

}  // namespace

Picture::Picture(const sim::System& system, const Document& document, double aspect)
    : system_(system), document_(document) {
  for (const sim::BodyRange& body : system.bodies()) {
    surfaces_.emplace_back(*body.mesh);
    still_.surfaces.push_back(still_surface(body, surfaces_.back(), still_.surfaces.size()));
  }
  const Eigen::AlignedBox3d box = rest_box(system.bodies());
  const bool plane = system.dimension() == 2;
  still_.camera = view_of(document.camera, box, system.dimension(), aspect);
  if (!plane) still_.ground = ground_of(document.look, document.camera.up, box);
  add_obstacles(document.scene.obstacles, still_);
  still_.title = document.title;
  still_.look.background = plane ? render::Background::paper : render::Background::studio;
  still_.look.wireframe = document.look.wireframe;
}

render::Frame Picture::frame(const Moment& moment) const {
  render::Frame frame = still_;
  const int dimension = system_.dimension();
  for (std::size_t i = 0; i < surfaces_.size(); ++i) {
    const sim::BodyRange& body = system_.bodies()[i];
    const Eigen::Map<const Eigen::MatrixXd> x(moment.state.x.data() + std::ptrdiff_t{dimension} * body.first_node,
                                              dimension, body.node_count);
    frame.surfaces[i].positions = surfaces_[i].points(x);
  }
  add_values(moment.state, frame);
  frame.caption = caption(document_.look.caption, system_, moment);
  return frame;
}

void Picture::add_values(const sim::State& state, render::Frame& frame) const {
  const std::optional<sim::Quantity> shown = quantity(document_.look.colour);
  if (!shown) return;
  const Eigen::VectorXd values = system_.node_values(state, *shown);
  const ColourRange range = colour_range(*shown, document_.look.range, values, softest_young(document_.scene));
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

}  // namespace app
