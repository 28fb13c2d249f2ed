#include "app/session/pull.h"

#include <algorithm>

#include "app/scene/scene_error.h"
#include "sim/element/element.h"

namespace app {

// k = E L / 5 [N/m]; in the plane and of membranes E L d / 5 with the thickness d over L.
sim::Spring spring_of_pull(const sim::Scene& scene, const Pull& pull) {
  const auto body = std::ranges::find(scene.bodies, pull.body, &sim::Body::name);
  if (body == scene.bodies.end()) throw SceneError("pull: there is no body \"" + pull.body + "\"");
  const auto& X = body->mesh.X;
  const double length = (X.rowwise().maxCoeff() - X.rowwise().minCoeff()).maxCoeff();
  double young = 0;
  for (const sim::MaterialSpec& material : body->materials) young = std::max(young, material.young);
  const double width = sim::info(body->mesh.kind).dimension == 2 ? body->thickness : length;
  return {pull.body, pull.at, pull.target, 0.2 * young * width};
}

}  // namespace app
