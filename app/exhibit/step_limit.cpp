// Explicit against implicit: the limit h < 2/omega_max, growth from noise below and above it, a step that is dragged
// through it, and the pattern of K with one element's block lit, which the implicit step solves with.
#include <algorithm>
#include <cmath>

#include "app/exhibit/body.h"
#include "app/exhibit/draw.h"
#include "app/exhibit/exhibit.h"
#include "app/exhibit/mesh_drawing.h"
#include "app/exhibit/print.h"
#include "app/scene/value_text.h"
#include "sim/mesh/input_error.h"
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
    const std::vector<double>& values = input.spec.values;
    const double dragged = values.empty() ? 1.05 : values[0];
    if (values.size() > 1 || !(dragged > 0 && dragged <= 2))
      throw sim::InputError("values",
                            "must be one number above 0, at most 2: the step that is dragged, over its limit");
    omega_ = sim::fastest_frequency(body_.alone(), 0);
    if (omega_ == 0) throw sim::InputError("body", "must have a node that is not pinned");
    runs_ = {{"0.99", "0.99", 0.99, Ink::black, false, {}},
             {"1.01", "1.01", 1.01, Ink::red, false, {}},
             {"dragged", printed("%.3f", dragged), dragged, Ink::purple, false, {}},
             {"implicit", "implicit, 3", 3, Ink::blue, true, {}}};
    for (Run& run : runs_) {
      const char* const integrator = run.implicit ? "backward-euler" : "central-difference";
      run.growth = sim::growth(body_.alone(), integrator, run.ratio * 2 / omega_, shown_steps);
    }
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
    sheet.diagrams.push_back(limit());
    sheet.diagrams.push_back(beams(step));
    const double limit = 1000 * 2 / omega_;  // ms
    sheet.blocks.push_back({"explicit limit",
                            {render::Line{"ωₘₐₓ", number("omega", "%.4f", omega_, "rad/s")},
                             render::Line{"2/ωₘₐₓ", number("limit", "%.4f", limit, "ms"), Ink::blue}}});
    render::Table table{{"h ωₘₐₓ/2", "h [ms]", "growth", "law"}, {}, {}};
    for (const Run& run : runs_) {
      const std::string law = run.implicit ? "≤ 1" : printed("%.4f", sim::growth_per_step(run.ratio));
      table.rows.push_back({run.label,
                            {number(run.name + ".h", "%.3f", run.ratio * limit, "ms"),
                             number(run.name + ".growth", "%.4f", run.growth.per_step()),
                             {run.name + ".law", law, ""}},
                            run.ink});
    }
    sheet.blocks.push_back({"growth per step", {table}});
    sheet.blocks.push_back(
        {"K dx, two ways",
         {render::Line{"largest", number("Kdx", "%.3e", product_.by_matrix.cwiseAbs().maxCoeff(), "N")},
          render::Line{"apart", number("Kdx.apart", "%.0e", product_.difference, "N")}}});
    sheet.formula = "h < 2 / ωₘₐₓ     (M + h²K) Δv = h f";
    sheet.proof_label = "growth at 1.01 h:";
    sheet.proof = number("growth", "%.4f", runs_[1].growth.per_step());
  }

  std::vector<Grip> grips(const sim::State&) const override {
    return {{2, ring(), "values", [](const render::Spot& to) { return "[" + number_literal(to[0]) + "]"; }}};
  }

 private:
  struct Run {
    std::string name, label;
    double ratio;  // of h to the limit
    Ink ink;
    bool implicit;
    sim::Growth growth;
  };

  const Run& dragged() const { return runs_[2]; }
  const Run& implicit() const { return runs_[3]; }
  render::Spot ring() const { return {dragged().ratio, std::clamp(dragged().growth.per_step(), 0.8, 2.6)}; }

  render::Diagram curves(int step) const {
    render::Diagram d{.place = {0.01, 0.11, 0.61, 0.53}, .title = "largest displacement over steps, m", .axes = true};
    d.x = {0, shown_steps};
    d.y = {-17, 3};
    d.logarithmic = true;
    for (const Run& run : runs_) {
      render::Stroke stroke{{}, run.ink, false, run.implicit};
      const std::vector<double>& reach = run.growth.reach;
      for (std::size_t k = 1; k < reach.size() && k <= static_cast<std::size_t>(step); ++k)
        stroke.points.push_back({double(k), std::log10(std::max(reach[k], 1e-20))});
      if (stroke.points.size() < 2) continue;
      const render::Spot end = stroke.points.back();
      const bool beyond = end[1] > d.y[1];
      const render::Side side =
          run.implicit ? render::Side::below : (beyond ? render::Side::left : render::Side::above);
      // Curves that end together have one name.
      const bool named = std::ranges::any_of(d.words, [&](const render::Word& other) {
        return other.at[0] == end[0] && std::abs(other.at[1] - end[1]) < 2.5;
      });
      if (!named || run.implicit) d.words.push_back({{end[0], std::min(0.0, end[1])}, run.label, run.ink, side});
      d.strokes.push_back(stroke);
    }
    return d;
  }

  // A dot for every pair of nodes that share an element; the pairs of one element in red.
  render::Diagram pattern() const {
    const sim::Mesh& mesh = body_.mesh();
    const int n = mesh.node_count();
    render::Diagram d{.place = {0.01, 0.53, 0.23, 0.88}, .title = "K: coupled nodes", .equal = true};
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

  // Growth per step over h, by its law; what was measured as dots, one of them to drag.
  render::Diagram limit() const {
    render::Diagram d{.place = {0.22, 0.53, 0.61, 0.88}, .title = "growth per step over h ωₘₐₓ/2", .axes = true};
    d.x = {0.9, 1.1};
    d.y = {0.8, 2.6};
    render::Stroke law{{}, Ink::black, false, true};
    for (int k = 0; k <= 80; ++k) law.points.push_back({0.9 + 0.0025 * k, sim::growth_per_step(0.9 + 0.0025 * k)});
    d.strokes.push_back(law);
    for (const Run& run : {runs_[0], runs_[1]}) d.dots.push_back({{run.ratio, run.growth.per_step()}, run.ink});
    d.dots.push_back({ring(), dragged().ink, true});
    return d;
  }

  // The body after so many explicit steps of the length that is dragged, and as many implicit ones.
  render::Diagram beams(int step) const {
    render::Diagram d{.place = {0.63, 0.66, 0.99, 0.89}, .title = "", .equal = true};
    const Eigen::MatrixXd& X = body_.mesh().X;
    cover(X, 0.1, d);
    const Eigen::Vector2d aside(1.2 * (d.x[1] - d.x[0]), 0);
    const double low = d.x[0];
    d.x[1] += aside.x();
    for (const Run* run : {&dragged(), &implicit()}) {
      const std::size_t last = std::min(static_cast<std::size_t>(step), run->growth.x.size() - 1);
      Eigen::MatrixXd x = run->growth.x[last].reshaped(2, X.cols());
      const bool right = run->implicit;
      if (right) x.colwise() += aside;
      add_outline(body_.mesh(), x, run->ink, d);
      d.words.push_back({{low + (right ? aside.x() : 0), d.y[1]}, run->implicit ? "implicit" : "explicit", run->ink});
    }
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
