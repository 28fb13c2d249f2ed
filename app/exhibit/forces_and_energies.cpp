// Galerkin beside Ritz: the forces of the weak form and the slope of the energy at every node, and T, U, T + U over
// time.
#include <algorithm>
#include <cmath>

#include "app/exhibit/body.h"
#include "app/exhibit/draw.h"
#include "app/exhibit/exhibit.h"
#include "app/exhibit/mesh_drawing.h"
#include "app/exhibit/print.h"
#include "sim/study/force_check.h"

namespace app {
namespace {

using render::Ink;

class ForcesAndEnergies : public Exhibit {
 public:
  explicit ForcesAndEnergies(const ExhibitInput& input) : body_(input), seconds_(input.scene.time.seconds) {
    if (body_.dimension() != 2) throw sim::InputError("body", "must be of a plane scene");
  }

  void note(const sim::State& state) override { trace_.add(body_.time(state), energies(state)); }
  Trace* trace() override { return &trace_; }

  void show(const sim::State& state, render::Sheet& sheet) const override {
    const sim::ForceCheck check = sim::check_forces(body_.system(), state);
    sheet.bodies = false;
    sheet.column = 0.66;
    sheet.diagrams.push_back(arrows(state, check));
    sheet.diagrams.push_back(plot());
    const Eigen::VectorXd E = energies(state);
    const Scaled joule = scaled(largest(), "J");
    const auto line = [&](const char* label, const char* name, double value, Ink ink) {
      return render::Line{label, number(name, "%.4f", value / joule.factor, joule.unit), ink};
    };
    sheet.blocks.push_back({"energies",
                            {line("T = ½ vᵀM v", "T", E[0], Ink::red), line("U", "U", E[1], Ink::blue),
                             line("T + U", "T+U", E[0] + E[1], Ink::black)}});
    const Scaled newton = scaled(check.largest, "N");
    sheet.blocks.push_back(
        {"largest force", {render::Line{"", number("largest", "%.4f", check.largest / newton.factor, newton.unit)}}});
    sheet.formula = "M a = −∇U(x)";
    sheet.proof_label = "|f − (−∇U)| / |f| =";
    sheet.proof = number("difference", "%.0e", check.largest > 0 ? check.difference / check.largest : 0);
  }

 private:
  // T and U of the whole system.
  Eigen::VectorXd energies(const sim::State& state) const {
    const sim::Measures m = body_.system().measure(state);
    return Eigen::Vector2d(m.kinetic, m.elastic + m.potential);
  }

  // What the weak form gives, as arrows; what the energy's slope gives, as rings at where their tips belong.
  render::Diagram arrows(const sim::State& state, const sim::ForceCheck& check) const {
    const Eigen::MatrixXd x = body_.nodes(state.x);
    render::Diagram d{
        .place = {0.01, 0.10, 0.65, 0.87}, .title = "arrows: ∫ −P grad Nᵢ    dots: −∂U/∂xᵢ", .equal = true};
    cover(body_.mesh().X, 0.12, d);
    // Room below, where it swings to.
    d.y[0] = d.y[1] - 0.62 * (d.x[1] - d.x[0]);
    add_elements(
        body_.mesh(), x,
        [](int) {
          return std::array{238, 241, 247};
        },
        false, d);
    add_outline(body_.mesh(), x, Ink::black, d);
    if (check.largest <= 0) return d;
    const Eigen::MatrixXd galerkin = body_.free_nodes(check.galerkin, state),
                          ritz = body_.free_nodes(check.ritz, state);
    const double largest = galerkin.colwise().norm().maxCoeff(), length = 0.12 * (d.x[1] - d.x[0]);
    if (largest <= 0) return d;
    const double scale = length / largest;
    add_forces(x, galerkin, length, largest, Ink::blue, d);
    for (Eigen::Index i = 0; i < x.cols(); ++i)
      if (ritz.col(i).norm() > 0.1 * largest) d.dots.push_back({spot(x.col(i) + scale * ritz.col(i)), Ink::red});
    return d;
  }

  // Of all energies so far, J.
  double largest() const {
    double most = 0;
    for (std::size_t k = 0; k < trace_.size(); ++k)
      most = std::max({most, std::abs(trace_.value(k, 0)), std::abs(trace_.value(k, 1))});
    return most;
  }

  render::Diagram plot() const {
    const Scaled joule = scaled(largest(), "J");
    render::Diagram d{
        .place = {0.66, 0.42, 0.99, 0.88}, .title = "T, U, T + U in " + joule.unit, .axes = true, .x_label = "t [s]"};
    d.x = {0, seconds_};
    double low = 0, high = 0;
    for (std::size_t k = 0; k < trace_.size(); ++k) {
      low = std::min(low, trace_.value(k, 1));
      high = std::max({high, trace_.value(k, 0), trace_.value(k, 0) + trace_.value(k, 1)});
    }
    if (high - low <= 0) high = low + 1;
    d.y = {(low - 0.05 * (high - low)) / joule.factor, (high + 0.05 * (high - low)) / joule.factor};
    d.strokes = {trace_.curve(0, Ink::red, 1 / joule.factor), trace_.curve(1, Ink::blue, 1 / joule.factor)};
    render::Stroke sum{{}, Ink::black, false, true};
    for (std::size_t k = 0; k < trace_.size(); ++k)
      sum.points.push_back({trace_.time(k), (trace_.value(k, 0) + trace_.value(k, 1)) / joule.factor});
    d.strokes.push_back(sum);
    return d;
  }

  ExhibitBody body_;
  double seconds_;
  Trace trace_{{"T", "U"}};  // J
};

}  // namespace

std::unique_ptr<Exhibit> make_forces_and_energies(const ExhibitInput& input) {
  return std::make_unique<ForcesAndEnergies>(input);
}

}  // namespace app
