// Explicit against implicit: the limit h < 2/omega_max, growth from noise below and above it, and the pattern of K with
// one element's block lit, which the implicit step solves with.
#include <algorithm>
#include <cmath>

#include "app/exhibit/body.h"
#include "app/exhibit/draw.h"
#include "app/exhibit/exhibit.h"
#include "app/exhibit/print.h"
#include "sim/study/force_check.h"
#include "sim/study/growth.h"
#include "sim/study/modes.h"

namespace app {
namespace {

using render::Ink;

constexpr int shown_steps = 110;

class StepLimit : public Exhibit {
 public:
  explicit StepLimit(const ExhibitInput& input) : body_(input), pace_(input.spec.pace), element_(input.spec.element) {
    const sim::Mesh& mesh = body_.mesh();
    if (body_.dimension() != 2) throw sim::InputError("body", "must be of a plane scene");
    if (element_ >= mesh.element_count())
      throw sim::InputError("element", "the body has elements 0 to " + std::to_string(mesh.element_count() - 1));
    omega_ = sim::fastest_frequency(body_.alone(), 0);
    runs_ = {{"0.99", 0.99, Ink::black, false, {}},
             {"1.01", 1.01, Ink::red, false, {}},
             {"1.05", 1.05, Ink::purple, false, {}}};
    for (Run& run : runs_)
      run.reach = sim::growth(body_.alone(), "central-difference", run.ratio * 2 / omega_, shown_steps);
    runs_.push_back(
        {"implicit at 3", 3, Ink::blue, true, sim::growth(body_.alone(), "backward-euler", 6 / omega_, shown_steps)});
    sim::Scene implicit = body_.alone();
    implicit.time.integrator = "backward-euler";
    implicit.solver.linear = sim::LinearSolverKind::cholmod;
    const sim::System system(implicit);
    sim::State state = system.initial_state();
    Eigen::VectorXd dx(state.x.size());
    for (Eigen::Index i = 0; i < dx.size(); ++i) dx[i] = std::sin(1.0 + 2.0 * static_cast<double>(i));
    product_ = sim::check_product(system, state, dx);
  }

  void show(const sim::State& state, render::Sheet& sheet) const override {
    const int step = std::min(shown_steps, static_cast<int>(std::floor(body_.time(state) / pace_ + 1e-9)));
    sheet.bodies = false;
    sheet.column = 0.62;
    sheet.diagrams.push_back(curves(step));
    sheet.diagrams.push_back(pattern());
    const double limit = 2 / omega_;
    sheet.blocks.push_back({"explicit limit",
                            {render::Line{"ω_max", number("omega", "%.4f", omega_, "rad/s")},
                             render::Line{"2/ω_max", number("limit", "%.4f", 1000 * limit, "ms"), Ink::blue}}});
    render::Table table{{"h ω_max/2", "growth", "law"}, {}, {}};
    for (const Run& run : runs_) {
      const std::string name = run.name;
      const double law = run.implicit ? 0 : sim::growth_per_step(run.ratio);
      table.rows.push_back({name,
                            {number(name + ".growth", "%.4f", measured(run)),
                             {name + ".law", run.implicit ? "≤ 1" : printed("%.4f", law), ""}},
                            run.ink});
    }
    sheet.blocks.push_back({"growth per step", {table}});
    sheet.blocks.push_back(
        {"K dx, two ways",
         {render::Line{"largest", number("Kdx", "%.3e", product_.by_matrix.cwiseAbs().maxCoeff(), "N")},
          render::Line{"apart", number("Kdx.apart", "%.0e", product_.difference, "N")}}});
    sheet.formula = "h < 2 / ω_max     (M + h²K) Δv = h f";
    sheet.proof_label = "growth at 1.01 h:";
    sheet.proof = number("growth", "%.4f", measured(runs_[1]));
  }

 private:
  struct Run {
    std::string name;
    double ratio;  // of h to the limit
    Ink ink;
    bool implicit;
    std::vector<double> reach;  // m
  };

  // Mean growth per step while the fastest mode is alone and the motion is still small.
  static double measured(const Run& run) {
    constexpr double small = 1e-3;  // m
    std::size_t last = run.reach.size() - 1;
    while (last > 2 && run.reach[last] > small) --last;
    const std::size_t first = last - std::min<std::size_t>(30, last / 2);
    return std::pow(run.reach[last] / run.reach[first], 1.0 / static_cast<double>(last - first));
  }

  render::Diagram curves(int step) const {
    render::Diagram d{.place = {0.01, 0.11, 0.61, 0.58}, .title = "largest displacement over steps, m", .axes = true};
    d.x = {0, shown_steps};
    d.y = {-15, 3};
    d.logarithmic = true;
    for (const Run& run : runs_) {
      render::Stroke stroke{{}, run.ink, false, run.implicit};
      for (std::size_t k = 1; k < run.reach.size() && k <= static_cast<std::size_t>(step); ++k)
        stroke.points.push_back({double(k), std::log10(std::max(run.reach[k], 1e-20))});
      if (stroke.points.size() < 2) continue;
      const render::Spot end = {std::min(stroke.points.back()[0], shown_steps - 6.0),
                                std::min(0.0, stroke.points.back()[1])};
      d.words.push_back({end, run.name, run.ink, run.implicit ? render::Side::below : render::Side::above});
      d.strokes.push_back(stroke);
    }
    return d;
  }

  // A dot for every pair of nodes that share an element; the pairs of one element in red.
  render::Diagram pattern() const {
    const sim::Mesh& mesh = body_.mesh();
    const int n = mesh.node_count();
    render::Diagram d{.place = {0.01, 0.58, 0.31, 0.88}, .title = "K: who is coupled", .equal = true};
    d.x = {-1, double(n)};
    d.y = {-1, double(n)};
    const auto add = [&](int e, std::array<int, 3> colour) {
      for (Eigen::Index a = 0; a < mesh.elements.rows(); ++a)
        for (Eigen::Index b = 0; b < mesh.elements.rows(); ++b) {
          const double x = mesh.elements(a, e), y = n - 1 - mesh.elements(b, e);
          d.patches.push_back(
              {{{x - 0.5, y - 0.5}, {x + 0.5, y - 0.5}, {x + 0.5, y + 0.5}, {x - 0.5, y + 0.5}}, colour});
        }
    };
    for (int e = 0; e < mesh.element_count(); ++e) add(e, {120, 126, 140});
    add(element_, {200, 0, 0});
    d.strokes.push_back({{{-0.5, -0.5}, {n - 0.5, -0.5}, {n - 0.5, n - 0.5}, {-0.5, n - 0.5}}, Ink::black, true});
    return d;
  }

  ExhibitBody body_;
  double pace_;
  int element_;
  double omega_ = 1;
  std::vector<Run> runs_;
  sim::ProductCheck product_;
};

}  // namespace

std::unique_ptr<Exhibit> make_step_limit(const ExhibitInput& input) {
  return std::make_unique<StepLimit>(input);
}

}  // namespace app
