#include "sim/study/difference.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sim {
namespace {

int common_frames(const Trajectory& a, const Trajectory& b, int most) {
  const int common = std::min(a.frames(), b.frames());
  return most < 0 ? common : std::min(common, most);
}

double finite(double value) {
  return std::isfinite(value) ? value : std::numeric_limits<double>::infinity();
}

Eigen::VectorXd centre(const Trajectory& path, int frame, const SamplePoints& points) {
  const Eigen::Map<const Eigen::MatrixXd> x(path.x[frame].data(), path.dimension, points.count());
  return x * points.mass / points.mass.sum();
}

double energy(const Measures& m) {
  return m.kinetic + m.elastic + m.potential;
}

}  // namespace

Difference difference(const Trajectory& a, const Trajectory& b, const SamplePoints& points, int most) {
  const int frames = common_frames(a, b, most);
  Difference result;
  result.frames.resize(frames);
  const double total = points.mass.sum();
  for (int k = 0; k < frames; ++k) {
    const Eigen::Map<const Eigen::MatrixXd> x(a.x[k].data(), a.dimension, points.count()),
        y(b.x[k].data(), b.dimension, points.count());
    const Eigen::ArrayXd squared = (x - y).colwise().squaredNorm().transpose().array() / points.size.array().square();
    result.frames[k] = finite(std::sqrt((points.mass.array() * squared).sum() / total));
    result.max = std::max(result.max, finite(std::sqrt(squared.maxCoeff())));
  }
  if (frames > 0) result.rms = std::sqrt(result.frames.squaredNorm() / frames);
  return result;
}

double centre_difference(const Trajectory& a, const Trajectory& b, const SamplePoints& points, int most) {
  const int frames = common_frames(a, b, most);
  double sum = 0;
  for (int k = 0; k < frames; ++k) sum += (centre(a, k, points) - centre(b, k, points)).squaredNorm();
  return frames > 0 ? finite(std::sqrt(sum / frames) / points.size.maxCoeff()) : 0;
}

Drift drift(const Trajectory& path, const Trajectory& reference, const SamplePoints& points, int most) {
  const int frames = common_frames(path, reference, most);
  double most_energy = 0, most_kinetic = 0;
  for (int k = 0; k < frames; ++k) {
    const Measures& m = reference.measures[k];
    most_energy = std::max(most_energy, m.kinetic + m.elastic);
    most_kinetic = std::max(most_kinetic, m.kinetic);
  }
  const double most_momentum = std::sqrt(2 * points.mass.sum() * most_kinetic);
  Drift result;
  for (int k = 0; k < frames; ++k) {
    const Measures &m = path.measures[k], &r = reference.measures[k];
    const double change = energy(m) - energy(r);
    result.mean_energy += change / frames;
    result.energy = std::max(result.energy, finite(std::abs(change)));
    result.momentum = std::max(result.momentum, finite((m.p - r.p).norm()));
  }
  const auto share = [](double value, double of) { return of > 0 ? value / of : 0.0; };
  return {share(result.energy, most_energy), share(result.momentum, most_momentum),
          share(result.mean_energy, most_energy)};
}

}  // namespace sim
