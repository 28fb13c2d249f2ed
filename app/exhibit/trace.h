// Numbers over the time of the frames, for curves.
#pragma once

#include <Eigen/Core>
#include <string>
#include <utility>
#include <vector>

#include "render/sheet.h"

namespace app {

class Trace {
 public:
  // One name for each of the numbers.
  explicit Trace(std::vector<std::string> names) : names_(std::move(names)) {}

  // Times that are not before t are replaced.
  void add(double t, const Eigen::VectorXd& values) {
    forget(t - round_off);
    times_.push_back(t);
    values_.push_back(values);
  }
  // Forgets what is later than t.
  void cut(double t) { forget(t + round_off); }

  const std::vector<std::string>& names() const { return names_; }
  std::size_t size() const { return times_.size(); }
  double time(std::size_t k) const { return times_[k]; }
  double value(std::size_t k, int which) const { return values_[k][which]; }
  const Eigen::VectorXd& last() const { return values_.back(); }

  render::Stroke curve(int which, render::Ink ink, double scale = 1) const {
    render::Stroke stroke{{}, ink};
    for (std::size_t k = 0; k < size(); ++k) stroke.points.push_back({times_[k], scale * values_[k][which]});
    return stroke;
  }

 private:
  static constexpr double round_off = 1e-12;  // s

  void forget(double later_than) {
    while (!times_.empty() && times_.back() > later_than) {
      times_.pop_back();
      values_.pop_back();
    }
  }

  std::vector<std::string> names_;
  std::vector<double> times_;
  std::vector<Eigen::VectorXd> values_;
};

}  // namespace app
