// sin(pi x) e^y and what nodal interpolation makes of it on n x n cells and on twice as many, with errors and order.
#include <algorithm>
#include <cmath>

#include "app/exhibit/draw.h"
#include "app/exhibit/exhibit.h"
#include "app/exhibit/mesh_drawing.h"
#include "app/exhibit/print.h"
#include "sim/element/element.h"
#include "sim/mesh/generate.h"
#include "sim/mesh/input_error.h"
#include "sim/study/shape_functions.h"

namespace app {
namespace {

using render::Ink;

class Interpolation : public Exhibit {
 public:
  explicit Interpolation(const ExhibitInput& input) : system_(input.system), pace_(input.spec.pace) {
    const std::string element = input.spec.basis.empty() ? "tri3" : input.spec.basis;
    const sim::ElementInfo* info = sim::find_element(element);
    if (info == nullptr || info->dimension != 2) throw sim::InputError("basis", "must be tri3, tri6 or quad4");
    order_ = info->order + 1;
    name_ = element;
    for (int n = 2; n <= most(input.spec.count); n *= 2) {
      Level level{n, sim::generate_rectangle({1, 1}, {n, n}, {1, 1}, info->kind), {}};
      level.error = sim::interpolation_error(level.mesh);
      levels_.push_back(std::move(level));
    }
  }

  void show(const sim::State& state, render::Sheet& sheet) const override {
    const double t = system_.time(state.step);
    const std::size_t now = std::min(levels_.size() - 2, static_cast<std::size_t>(t / pace_ + 1e-9));
    sheet.bodies = false;
    sheet.column = 0.66;
    sheet.diagrams.push_back(picture(levels_[now], {0.01, 0.11, 0.33, 0.58}, levels_[now].error.max));
    sheet.diagrams.push_back(picture(levels_[now + 1], {0.33, 0.11, 0.65, 0.58}, levels_[now].error.max));
    sheet.diagrams.push_back(convergence(now + 1));
    render::Table table{{"n", "L₂", "H₁", "max"}, {}, {}};
    for (std::size_t k = 0; k <= now + 1; ++k) {
      const std::string n = std::to_string(levels_[k].n);
      const sim::InterpolationError& e = levels_[k].error;
      table.rows.push_back({n,
                            {number("L2." + n, "%.6f", e.L2), number("H1." + n, "%.4f", e.H1_seminorm),
                             number("max." + n, "%.5f", e.max)}});
    }
    sheet.blocks.push_back({"u − I u, " + name_, {table}});
    sheet.formula = "u = sin(πx) eʸ,   I u = Σ u(Xᵢ) Nᵢ";
    sheet.proof_label = "order in L₂:";
    sheet.proof = number("order", "%.2f", std::log2(levels_[now].error.L2 / levels_[now + 1].error.L2));
  }

 private:
  struct Level {
    int n;
    sim::Mesh mesh;
    sim::InterpolationError error;
  };
  // Two levels at least.
  static int most(int count) { return std::max(4, count); }

  // The error as colour: white where the interpolant is right; `largest` is as dark as can be.
  render::Diagram picture(const Level& level, const render::Box& place, double largest) const {
    render::Diagram d{.place = place, .title = "|u − I u|, n = " + std::to_string(level.n), .equal = true};
    d.x = {-0.03, 1.03};
    d.y = {-0.03, 1.03};
    const int pieces = std::max(2, 32 / level.n);
    for (int e = 0; e < level.mesh.element_count(); ++e) {
      for (const auto& facet : sim::facets_of_element(level.mesh, e, pieces)) {
        render::Patch patch;
        double error = 0;
        for (const sim::PointOfElement& corner : facet) {
          const sim::ShapeValues v = sim::shape_values(level.mesh, corner);
          double u = sim::interpolated(v.X);
          for (Eigen::Index a = 0; a < v.N.size(); ++a)
            u -= v.N[a] * sim::interpolated(level.mesh.X.col(level.mesh.elements(a, e)));
          error += std::abs(u) / static_cast<double>(facet.size());
          patch.points.push_back(spot(v.X));
        }
        patch.colour = tint(std::sqrt(error / largest));
        d.patches.push_back(patch);
      }
      if (level.n <= 8) d.strokes.push_back({polygon(corners(level.mesh, e, level.mesh.X)), Ink::black, true});
    }
    return d;
  }

  render::Diagram convergence(std::size_t last) const {
    render::Diagram d{.place = {0.01, 0.58, 0.65, 0.88}, .title = "L₂ error over n", .axes = true};
    d.x = {1, std::log2(levels_.back().n)};
    d.y = {std::floor(std::log10(levels_.back().error.L2)), 0};
    d.logarithmic = true;
    for (const Level& level : levels_) d.x_ticks.push_back({std::log2(level.n), std::to_string(level.n)});
    render::Stroke curve{{}, Ink::blue}, slope{{}, Ink::black, false, true};
    for (std::size_t k = 0; k <= last; ++k) {
      curve.points.push_back({std::log2(levels_[k].n), std::log10(levels_[k].error.L2)});
      d.dots.push_back({curve.points.back(), Ink::blue});
    }
    // h^order, a little below the last point so that both are seen.
    for (const Level& level : levels_)
      slope.points.push_back({std::log2(level.n), std::log10(0.4 * levels_[last].error.L2) -
                                                      order_ * std::log10(double(level.n) / levels_[last].n)});
    d.strokes = {slope, curve};
    d.words.push_back({slope.points[1], order_ == 2 ? "h²" : "h³", Ink::black, render::Side::below});
    return d;
  }

  const sim::System& system_;
  double pace_;
  int order_ = 2;
  std::string name_;
  std::vector<Level> levels_;
};

}  // namespace

std::unique_ptr<Exhibit> make_interpolation(const ExhibitInput& input) {
  return std::make_unique<Interpolation>(input);
}

}  // namespace app
