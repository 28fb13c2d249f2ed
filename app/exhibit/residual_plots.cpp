#include "app/exhibit/residual_plots.h"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

using render::Ink;
using sim::residual::Problem;
using sim::residual::Real;
using sim::residual::Trial;

constexpr int drawn_cells = 160;  // of a curve
constexpr double smallest_reach = 1e-12;

template <class F>
std::vector<render::Spot> sampled(const F& y) {
  std::vector<render::Spot> points;
  for (int i = 0; i <= drawn_cells; ++i) {
    const double x = double(i) / drawn_cells;
    points.push_back({x, static_cast<double>(y(x))});
  }
  return points;
}

// What is between a curve and the axis: blue above, red below.
void shade(const std::vector<render::Spot>& points, render::Diagram& d) {
  for (std::size_t i = 1; i < points.size(); ++i) {
    const render::Spot &a = points[i - 1], &b = points[i];
    const bool above = a[1] + b[1] > 0;
    d.patches.push_back({{{a[0], 0}, {b[0], 0}, b, a}, above ? std::array{172, 200, 245} : std::array{250, 214, 208}});
  }
}

// Above the largest value: a power of two, so that the axis stands still while a point is dragged a little.
double reach_of_curve(const std::vector<render::Spot>& points) {
  double largest = smallest_reach;
  for (const render::Spot& spot : points) largest = std::max(largest, std::abs(spot[1]));
  return std::exp2(std::ceil(std::log2(1.05 * largest)));
}

// The square of a curve, scaled so that it is as high as the axis where the curve is.
void shade_square(std::vector<render::Spot> points, render::Diagram& d) {
  for (render::Spot& spot : points) spot[1] *= spot[1] / d.y[1];
  shade(points, d);
}

// The product of the residual and a function, scaled to the axis.
template <class F>
void shade_product(const F& residual, const Trial& u, Eigen::Index term, render::Diagram& d) {
  std::vector<sim::residual::Sample> all(u.coefficients().size());
  std::vector<render::Spot> product = sampled([&](double x) {
    u.basis().sample(x, all);
    return residual(x) * all[term].value;
  });
  const double scale = d.y[1] / reach_of_curve(product);
  for (render::Spot& spot : product) spot[1] *= scale;
  shade(product, d);
}

// F over one coefficient, the others as they were found.
render::Diagram bowl(const Problem& problem, const Attempt& attempt, Eigen::Index term, const render::Box& place) {
  constexpr int evaluations = 24;
  render::Diagram d{
      .place = place, .title = "F over coefficient " + std::to_string(term + 1) + ", least at the dot", .axes = true};
  const sim::residual::Vector& c = attempt.u.coefficients();
  const Real reach = std::max(c.cwiseAbs().maxCoeff() / 2, Real(1e-6));
  render::Stroke F{{}, Ink::black};
  for (int i = 0; i <= evaluations; ++i) {
    sim::residual::Vector moved = c;
    moved[term] += reach * (Real(2 * i) / evaluations - 1);
    const auto errors = measure(problem, Trial(attempt.u.basis(), moved), true);
    F.points.push_back({static_cast<double>(moved[term]), static_cast<double>(*errors.F)});
  }
  const double least = static_cast<double>(*attempt.errors.F);
  double most = least;
  for (const render::Spot& spot : F.points) most = std::max(most, spot[1]);
  d.x = {F.points.front()[0], F.points.back()[0]};
  d.y = {least - 0.15 * (most - least), most};
  d.strokes.push_back(F);
  d.dots.push_back({{static_cast<double>(c[term]), least}, Ink::blue});
  return d;
}

}  // namespace

render::Stroke curve_of(const sim::residual::Function& u, Ink ink, bool dashed) {
  return {sampled([&](double x) { return u(x).value; }), ink, false, dashed};
}

render::Diagram solution_plot(const Problem& problem, const MethodEntry& entry, const render::Box& place) {
  render::Diagram d{.place = place, .title = entry.label.substr(3) + ": uₙ; dashed: u", .axes = true};
  const render::Stroke u = curve_of(problem.exact, Ink::black, true);
  double low = 0, high = 0;
  for (const render::Spot& spot : u.points) low = std::min(low, spot[1]), high = std::max(high, spot[1]);
  const double room = 0.25 * (high - low) + smallest_reach;
  d.y = {low - room, high + room};
  if (entry.attempt) {
    render::Stroke found{sampled([&](double x) { return entry.attempt->u.at(x).value; }), entry.ink};
    for (render::Spot& spot : found.points) spot[1] = std::clamp(spot[1], d.y[0], d.y[1]);
    d.strokes.push_back(found);
  }
  d.strokes.push_back(u);
  return d;
}

render::Diagram action_plot(const Problem& problem, const MethodEntry& entry, Eigen::Index term,
                            const render::Box& place) {
  if (entry.method.starts_with("ritz")) return bowl(problem, *entry.attempt, term, place);
  const Trial& u = entry.attempt->u;
  const bool smooth = u.basis().smooth;
  const auto residual = [&](double x) { return apply(problem, x, u.at(x)) - problem.f(x).value; };
  const auto error = [&](double x) { return u.at(x).value - problem.exact(x).value; };
  const std::vector<render::Spot> left = smooth ? sampled(residual) : sampled(error);
  const double reach = reach_of_curve(left);
  render::Diagram d{.place = place, .axes = true};
  d.y = {-reach, reach};
  d.title = smooth ? "r = L uₙ − f" : "uₙ − u; hats have no r";
  if (entry.method == "least-squares") {
    d.title += "; shaded: r²";
    shade_square(left, d);
  }
  if (entry.method == "galerkin" && smooth) {
    d.title += "; shaded: r times function " + std::to_string(term + 1);
    shade_product(residual, u, term, d);
  }
  if (entry.points.size() > 0) d.title += "; zero at the rings";
  d.strokes = {{{{0, 0}, {1, 0}}, Ink::black}, {left, entry.ink}};
  for (const Real point : entry.points) d.dots.push_back({{static_cast<double>(point), 0}, Ink::red, true});
  return d;
}

}  // namespace app
