// The camera over time.
#pragma once

#include <Eigen/Geometry>

#include "app/picture/stage.h"
#include "app/scene/document.h"
#include "render/frame.h"
#include "sim/system.h"

namespace app {

// Where the scene leaves the camera open, it stands where all bodies are seen, and draws back while one of them is
// about to leave the picture: its place depends on the state alone, not on the frames before.
class CameraPath {
 public:
  // `aspect`: width / height of the pictures. Both first arguments must outlive it.
  CameraPath(const sim::System& system, const Document& document, double aspect, double margin = margin_in_picture);

  // Relative to the origin of the stand.
  render::Camera at(const sim::State& state) const;

 private:
  Vec3 middle_of_followed(const Eigen::VectorXd& x) const;

  const sim::System& system_;
  const Camera& camera_;
  Stand stand_;
  double aspect_, margin_;
  Eigen::AlignedBox3d first_;  // seen from the start where the scene leaves the camera open
  const sim::BodyRange* followed_ = nullptr;
  Vec3 start_ = Vec3::Zero();  // of the followed body's middle
};

}  // namespace app
