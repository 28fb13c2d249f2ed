// Numbers over the time of the frames, for curves.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "render/sheet.h"

namespace app {

class Trace {
 public:
  // Times that are not before t are replaced.
  void add(double t, const Eigen::VectorXd& values) {
    while (!times_.empty() && times_.back() >= t - 1e-12) {
      times_.pop_back();
      values_.pop_back();
    }
    times_.push_back(t);
    values_.push_back(values);
  }
  std::size_t size() const { return times_.size(); }
  double time(std::size_t k) const { return times_[k]; }
  double value(std::size_t k, int which) const { return values_[k][which]; }
  double end() const { return times_.empty() ? 0 : times_.back(); }

  render::Stroke curve(int which, render::Ink ink, double scale = 1) const {
    render::Stroke stroke{{}, ink};
    for (std::size_t k = 0; k < size(); ++k) stroke.points.push_back({times_[k], scale * values_[k][which]});
    return stroke;
  }

 private:
  std::vector<double> times_;
  std::vector<Eigen::VectorXd> values_;
};

}  // namespace app
