// The force algorithm, sub-step by sub-step: gather, F, P, scatter; element after element, the accumulators beside it.
#include <algorithm>
#include <cmath>

#include "app/exhibit/body.h"
#include "app/exhibit/draw.h"
#include "app/exhibit/exhibit.h"
#include "app/exhibit/mesh_drawing.h"
#include "app/exhibit/print.h"
#include "sim/mesh/input_error.h"
#include "sim/study/element_view.h"
#include "sim/study/force_check.h"

namespace app {
namespace {

using render::Ink;

enum Step { gather, deform, stress, scatter, steps_each };

// Where the algorithm is.
struct Progress {
  int element;
  Step step;
  bool done;  // all elements have added their forces
};

class ForceSteps : public Exhibit {
 public:
  explicit ForceSteps(const ExhibitInput& input) : body_(input), pace_(input.spec.pace) {
    if (body_.dimension() != 2) throw sim::InputError("body", "must be of a plane scene");
    sim::view_element(body_.body(), 0, body_.mesh().X.leftCols(3));
  }

  void show(const sim::State& state, render::Sheet& sheet) const override {
    const Progress at = progress(state);
    const Eigen::MatrixXd x = body_.nodes(state.x);
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(2, x.cols());
    for (int e = 0; e < (at.done ? body_.mesh().element_count() : at.element); ++e) add(view(e, state), e, sum);
    const sim::ElementView now = view(at.element, state);
    if (!at.done && at.step == scatter) add(now, at.element, sum);
    const sim::ForceCheck check = sim::check_forces(body_.system(), state);
    sheet.bodies = false;
    sheet.column = 0.60;
    sheet.diagrams.push_back(drawing(x, now, at, sum));
    sheet.blocks = {one_element(now, at)};
    if (body_.mesh().node_count() <= 6) sheet.blocks.push_back(accumulators(sum, check));
    sheet.formula = formula(at);
    if (!at.done) return;
    const Eigen::MatrixXd other = body_.nodes(check.ritz);
    sheet.proof_label = "max |f − (−∇U)| =";
    sheet.proof = number("difference", "%.0e", (sum - other).cwiseAbs().maxCoeff(), "N");
  }

 private:
  sim::ElementView view(int element, const sim::State& state) const {
    return sim::view_element(body_.body(), element, body_.element_nodes(element, state));
  }
  void add(const sim::ElementView& view, int element, Eigen::MatrixXd& sum) const {
    for (Eigen::Index a = 0; a < view.f.cols(); ++a) sum.col(body_.mesh().elements(a, element)) += view.f.col(a);
  }

  // The first two elements in sub-steps; those of a larger body then fifty times as fast.
  Progress progress(const sim::State& state) const {
    constexpr int slow = 2 * steps_each;
    const double ticks = body_.time(state) / pace_ + 1e-9;
    const int count = body_.mesh().element_count();
    int k = static_cast<int>(std::floor(ticks));
    if (k >= slow) k = slow + static_cast<int>(std::floor(50 * (ticks - slow)));
    if (k >= count * steps_each) return {count - 1, scatter, true};
    return {k / steps_each, static_cast<Step>(k % steps_each), false};
  }

  render::Diagram drawing(const Eigen::MatrixXd& x, const sim::ElementView& view, const Progress& at,
                          const Eigen::MatrixXd& sum) const {
    render::Diagram d{.place = {0.02, 0.11, 0.58, 0.86}, .equal = true};
    cover(x, 0.35, d);
    const bool few = body_.mesh().node_count() <= 6;
    add_elements(
        body_.mesh(), x,
        [&](int e) {
          if (!at.done && e == at.element) return std::array{255, 226, 160};
          return at.done || e < at.element ? std::array{205, 220, 246} : std::array{244, 246, 250};
        },
        true, d);
    const double largest = std::max(sum.colwise().norm().maxCoeff(), view.f.colwise().norm().maxCoeff());
    const double length = (few ? 0.25 : 0.12) * (d.x[1] - d.x[0]);
    if (largest > 0) {
      add_forces(x, sum, length, largest, Ink::blue, d);
      if (!at.done && at.step == scatter) add_forces(view.x, view.f, length, largest, Ink::red, d);
    }
    for (Eigen::Index i = 0; few && i < x.cols(); ++i) {
      d.dots.push_back({spot(x.col(i))});
      const bool high = x(1, i) > x.row(1).mean();
      d.words.push_back(
          {spot(x.col(i)), std::to_string(i), Ink::black, high ? render::Side::above : render::Side::below});
    }
    return d;
  }

  render::Block one_element(const sim::ElementView& view, const Progress& at) const {
    const Scaled pascal = scaled(view.P.cwiseAbs().maxCoeff(), "Pa"),
                 newton = scaled(view.f.cwiseAbs().maxCoeff(), "N");
    render::Block block{at.done ? "all elements" : "element " + std::to_string(at.element), {}};
    if (at.done) {
      block.items.push_back(render::Line{"elements", number("elements", "%.0f", body_.mesh().element_count())});
      return block;
    }
    block.items.push_back(matrix("1  Dₛ", "Ds", "%.2f", view.Ds, "m"));
    if (at.step >= deform) block.items.push_back(matrix("2  F", "F", "%.4f", view.F));
    if (at.step >= stress) block.items.push_back(matrix("3  P", "P", "%.2f", view.P / pascal.factor, pascal.unit));
    if (at.step >= scatter) block.items.push_back(matrix("4  f", "f", "%.2f", view.f / newton.factor, newton.unit));
    return block;
  }

  // Accumulated forces; the last columns are the slope of the energy, by differences.
  static render::Block accumulators(const Eigen::MatrixXd& sum, const sim::ForceCheck& check) {
    const Scaled newton = scaled(check.largest, "N");
    render::Table table{{"node", "f x", "f y", "−∂U/∂x", "−∂U/∂y"}, {}, {}};
    for (Eigen::Index i = 0; i < sum.cols(); ++i) {
      const std::string name = std::to_string(i);
      table.rows.push_back(
          {name,
           {number("f" + name + "x", "%.3f", sum(0, i) / newton.factor, newton.unit),
            number("f" + name + "y", "%.3f", sum(1, i) / newton.factor, newton.unit),
            number("slope" + name + "x", "%.3f", check.ritz[2 * i] / newton.factor, newton.unit),
            number("slope" + name + "y", "%.3f", check.ritz[2 * i + 1] / newton.factor, newton.unit)}});
    }
    return {"accumulators, " + newton.unit, {table}};
  }

  static std::string formula(const Progress& at) {
    if (at.done) return "f = −∇U(x)";
    static constexpr const char* all[] = {"1  gather x₁, x₂, x₃", "2  F = Dₛ Dₘ⁻¹", "3  P = ∂Ψ/∂F",
                                          "4  [f₂ f₃] = −P Dₘ⁻ᵀ V, scatter"};
    return all[at.step];
  }

  ExhibitBody body_;
  double pace_;
};

}  // namespace

std::unique_ptr<Exhibit> make_force_steps(const ExhibitInput& input) {
  return std::make_unique<ForceSteps>(input);
}

}  // namespace app
