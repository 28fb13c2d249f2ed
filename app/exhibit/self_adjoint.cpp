// Self-adjoint or not: -eps u'' + u' = 1. Galerkin's hats swing where a cell is wider than the layer; Ritz's method is
// refused, with the number that shows why, and done anyway gives the answer of another problem.
#include <algorithm>
#include <cmath>

#include "app/exhibit/exhibit.h"
#include "app/exhibit/print.h"
#include "app/exhibit/residual_plots.h"
#include "app/residuals/study.h"
#include "app/scene/value_text.h"
#include "sim/mesh/input_error.h"
#include "sim/residual/advection.h"

namespace app {
namespace {

using render::Ink;
using sim::residual::Real;
namespace rs = sim::residual;

constexpr double first_eps = 1, last_eps = 0.01;  // of what slides
constexpr double sliding_paces = 4;               // from the first to the last
constexpr double anyway_eps = 0.1;                // afterwards, with Ritz's method
constexpr int most_hats = 64;
constexpr int tried_terms[] = {1, 2, 4, 8};
constexpr int tried_eps = 33;  // of the curve over eps

ResidualStudy study_advection(double eps, const char* basis, std::vector<int> n, bool anyway) {
  ProblemFile file;
  file.problem = rs::advection_diffusion(eps);
  file.bases = {rs::find_basis(basis)};
  file.methods = {rs::find_method("galerkin"), rs::find_method("ritz")};
  file.n = std::move(n);
  return study_residuals(std::move(file), anyway);
}

const Attempt* find_attempt(const ResidualStudy& study, std::string_view method, int n) {
  const auto found = std::ranges::find_if(
      study.attempts, [&](const Attempt& attempt) { return attempt.method == method && attempt.n() == n; });
  return found == study.attempts.end() ? nullptr : &*found;
}

class SelfAdjoint : public Exhibit {
 public:
  explicit SelfAdjoint(const ExhibitInput& input)
      : system_(input.system),
        pace_(input.spec.pace),
        hats_(input.spec.count),
        eps_(input.spec.eps),
        anyway_(input.spec.anyway) {
    if (hats_ > most_hats) throw sim::InputError("count", "must be at most " + std::to_string(most_hats));
    const rs::Basis& basis = *rs::find_basis("hats");
    for (int i = 0; i < tried_eps; ++i) {
      const double share = double(i) / (tried_eps - 1), eps = first_eps * std::pow(last_eps / first_eps, share);
      rs::Problem problem = rs::advection_diffusion(eps);
      problem.exact = nullptr;  // whose layer the integrals need not resolve
      const rs::Answer answer = rs::galerkin(problem, basis, hats_);
      overshoot_.push_back({std::log10(eps), static_cast<double>(rs::overshoot(answer.c))});
    }
  }

  void show(const sim::State& state, render::Sheet& sheet) const override {
    const Act act = act_at(state);
    const ResidualStudy hats = study_advection(act.eps, "hats", {hats_}, false);
    const ResidualStudy tried =
        study_advection(act.eps, "polynomials", {std::begin(tried_terms), std::end(tried_terms)}, act.anyway);
    const Attempt& swinging = *find_attempt(hats, "galerkin", hats_);
    sheet.bodies = false;
    sheet.column = 0.58;
    sheet.diagrams.push_back(solutions(hats, swinging, find_attempt(tried, "ritz-anyway", act.term)));
    sheet.diagrams.push_back(swing(act.eps));
    sheet.blocks.push_back({"−ε u″ + u′ = 1",
                            {render::Line{"ε", number("eps", "%.4f", act.eps)},
                             render::Line{"Pe = h/2ε", number("peclet", "%.3f", peclet(act.eps)),
                                          peclet(act.eps) > 1 + 1e-9 ? Ink::red : Ink::black}}});
    sheet.blocks.push_back(errors(tried));
    sheet.blocks.push_back(nodes(swinging));
    sheet.formula = "u = x (1 − x),  v = x u:   ∫ v L u ≠ ∫ u L v";
    sheet.proof_label = "∫ v L u − ∫ u L v =";
    sheet.proof = number("asymmetry", "%.7f", static_cast<double>(tried.asymmetry.difference));
  }

  std::vector<Grip> grips(const sim::State& state) const override {
    return {{1, ring(act_at(state).eps), "eps", [](const render::Spot& to) {
               return number_literal(std::pow(10, std::clamp(to[0], std::log10(last_eps), std::log10(first_eps))));
             }}};
  }

 private:
  struct Act {
    double eps = first_eps;
    bool anyway = false;
    int term = 1;  // functions of Ritz's curve
  };

  // Without an eps that is given it slides, and then Ritz's method is done anyway, with more and more functions.
  Act act_at(const sim::State& state) const {
    const double paces = std::max(0.0, system_.time(state.step) / pace_ + 1e-9);
    const auto turn = static_cast<std::size_t>(std::floor(paces)) % std::size(tried_terms);
    if (eps_) return {*eps_, anyway_, tried_terms[turn]};
    if (paces >= sliding_paces) return {anyway_eps, true, tried_terms[turn]};
    return {first_eps * std::pow(last_eps / first_eps, paces / sliding_paces), anyway_, tried_terms[turn]};
  }

  double peclet(double eps) const { return static_cast<double>(rs::cell_peclet(eps, hats_)); }

  static render::Diagram solutions(const ResidualStudy& hats, const Attempt& swinging, const Attempt* ritz) {
    render::Diagram d{.place = {0.01, 0.11, 0.57, 0.55}, .axes = true};
    d.title = ritz == nullptr ? "hats by Galerkin; dashed: u" : "hats by Galerkin; dashed: u; red: Ritz anyway";
    d.y = {-0.5, 1.5};
    const rs::Vector& c = swinging.u.coefficients();
    render::Stroke found{{{0, 0}}, Ink::blue};
    for (Eigen::Index i = 0; i < c.size(); ++i) {
      found.points.push_back({static_cast<double>(i + 1) / static_cast<double>(c.size() + 1),
                              std::clamp(static_cast<double>(c[i]), d.y[0], d.y[1])});
      d.dots.push_back({found.points.back(), Ink::blue});
    }
    found.points.push_back({1, 0});
    d.strokes = {curve_of(hats.file.problem.exact, Ink::black, true), found};
    if (ritz == nullptr) return d;
    render::Stroke other = curve_of([&](Real x) { return rs::Jet{ritz->u.at(x).value, 0}; }, Ink::red);
    for (render::Spot& spot : other.points) spot[1] = std::min(spot[1], d.y[1]);
    d.strokes.push_back(other);
    return d;
  }

  // How far the nodes lie above u = x, over eps; the line is where a cell's Péclet number is 1.
  render::Diagram swing(double eps) const {
    render::Diagram d{
        .place = {0.01, 0.56, 0.57, 0.87}, .title = "how far hats lie above u = x, over log₁₀ ε", .axes = true};
    d.x = {std::log10(last_eps) - 0.05, std::log10(first_eps) + 0.05};
    double most = 0.01;
    for (const render::Spot& spot : overshoot_) most = std::max(most, spot[1]);
    d.y = {-0.15 * most, 1.1 * most};
    const double border = std::log10(peclet(1.0));  // the eps of Pe = 1
    d.strokes.push_back({{{border, d.y[0]}, {border, d.y[1]}}, Ink::black, false, true});
    d.words.push_back({{border, 0.9 * most}, "Pe = 1", Ink::black});
    d.strokes.push_back({overshoot_, Ink::blue});
    d.dots.push_back({ring(eps), Ink::red, true});
    return d;
  }
  static render::Spot ring(double eps) { return {std::log10(eps), 0}; }

  static render::Block errors(const ResidualStudy& tried) {
    render::Table table{{"n", "Galerkin", "Ritz"}, {}, {}};
    for (const int n : tried_terms) {
      render::Table::Row row{std::to_string(n), {}};
      for (const std::string method : {"galerkin", "ritz"}) {
        const Attempt* attempt = find_attempt(tried, method == "ritz" ? "ritz-anyway" : method, n);
        const std::string name = method + ".L2." + std::to_string(n);
        row.numbers.push_back(attempt == nullptr ? render::Number{name, "refused", ""}
                                                 : number(name, "%.8f", static_cast<double>(attempt->errors.L2)));
      }
      table.rows.push_back(row);
    }
    return {"L₂ error, n polynomials", {table}};
  }

  static render::Block nodes(const Attempt& hats) {
    constexpr Eigen::Index most_shown = 6;
    const rs::Vector& c = hats.u.coefficients();
    const Eigen::VectorXd shown = c.head(std::min(c.size(), most_shown)).cast<double>();
    return {"", {matrix("hats", "hats.u", "%.4f", shown)}};
  }

  const sim::System& system_;
  double pace_;
  int hats_;
  std::optional<double> eps_;
  bool anyway_;
  std::vector<render::Spot> overshoot_;  // (log10 eps, that of the nodes)
};

}  // namespace

std::unique_ptr<Exhibit> make_self_adjoint(const ExhibitInput& input) {
  return std::make_unique<SelfAdjoint>(input);
}

}  // namespace app
