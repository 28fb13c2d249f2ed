#include "app/stress/extremes.h"

namespace app {

Ends ends_of(const sim::Scene& scene) {
  const sim::Mesh& mesh = scene.bodies.front().mesh;
  sim::Vec3 low = sim::Vec3::Zero(), high = low;
  low.head(mesh.dimension()) = mesh.X.rowwise().minCoeff();
  high.head(mesh.dimension()) = mesh.X.rowwise().maxCoeff();
  const sim::Vec3 extent = high - low;
  int axis = 0;
  const double length = extent.maxCoeff(&axis);
  int thin = axis == 0 ? 1 : 0;
  for (int c = 0; c < mesh.dimension(); ++c)
    if (c != axis && extent[c] > 0 && extent[c] < extent[thin]) thin = c;
  Ends ends{{low, high},      {low, high}, sim::Vec3::Unit(axis), sim::Vec3::Unit(thin),
            (low + high) / 2, length,      extent[thin]};
  ends.low.high[axis] = low[axis] + 0.01 * length;
  ends.high.low[axis] = high[axis] - 0.01 * length;
  return ends;
}

}  // namespace app
