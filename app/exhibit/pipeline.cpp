// From positions to acceleration, station by station: phi, F, P, force density, acceleration; what is lit is drawn on
// the moving body.
#include <algorithm>
#include <cmath>

#include "app/exhibit/body.h"
#include "app/exhibit/draw.h"
#include "app/exhibit/exhibit.h"
#include "app/exhibit/mesh_drawing.h"
#include "app/exhibit/print.h"
#include "sim/mesh/input_error.h"
#include "sim/study/acceleration.h"
#include "sim/study/element_view.h"
#include "sim/study/force_check.h"

namespace app {
namespace {

using render::Ink;

enum Station { positions, gradient, stress, density, acceleration, stations };
constexpr const char* station_titles[] = {"φ(X): positions", "F = dφ/dX", "P = dΨ/dF", "div P: forces",
                                          "ẍ: acceleration"};

class PipelineOfForces : public Exhibit {
 public:
  explicit PipelineOfForces(const ExhibitInput& input)
      : body_(input), element_(input.spec.element), pace_(input.spec.pace) {
    if (body_.dimension() != 2) throw sim::InputError("body", "must be of a plane scene");
    sim::view_element(body_.body(), element_, body_.mesh().X.leftCols(3));
  }

  void show(const sim::State& state, render::Sheet& sheet) const override {
    const int station = static_cast<int>(std::floor(body_.time(state) / pace_ + 1e-9)) % stations;
    const sim::ForceCheck check = sim::check_forces(body_.system(), state);
    const Eigen::MatrixXd f = body_.nodes(check.galerkin);
    const sim::ElementView view = sim::view_element(body_.body(), element_, body_.element_nodes(element_, state));
    sheet.bodies = false;
    sheet.column = 0.66;
    sheet.diagrams.push_back(drawing(state, station, f));
    render::Block steps{"", {}};
    for (int k = 0; k < stations; ++k)
      steps.items.push_back(render::Line{
          std::string(k == station ? "→ " : "   ") + station_titles[k], {}, k == station ? Ink::blue : Ink::black});
    const Scaled pascal = scaled(view.P.cwiseAbs().maxCoeff(), "Pa");
    render::Block numbers{"element " + std::to_string(element_), {}};
    numbers.items.push_back(matrix("F", "F", "%.4f", view.F));
    if (station >= stress) numbers.items.push_back(matrix("P", "P", "%.2f", view.P / pascal.factor, pascal.unit));
    sheet.blocks = {steps, numbers};
    sheet.formula = "ρ ẍ = div P + f";
    sheet.proof_label = "|Σ f| =";
    sheet.proof = number("sum", "%.0e", f.rowwise().sum().norm(), "N");
  }

 private:
  render::Diagram drawing(const sim::State& state, int station, const Eigen::MatrixXd& f) const {
    const sim::Mesh& mesh = body_.mesh();
    const Eigen::MatrixXd x = body_.nodes(state.x);
    render::Diagram d{.place = {0.01, 0.11, 0.65, 0.86}, .equal = true};
    cover(mesh.X, 0.08, d);
    // Room below, where it falls to.
    d.y[0] = d.y[1] - 0.66 * (d.x[1] - d.x[0]);
    std::vector<sim::ElementView> views;
    double largest = 0;
    for (int e = 0; e < mesh.element_count(); ++e) {
      views.push_back(sim::view_element(body_.body(), e, corners(mesh, e, x)));
      largest = std::max(largest, views.back().P.norm());
    }
    add_elements(
        mesh, x,
        [&](int e) {
          if (station < stress || largest == 0)
            return e == element_ ? std::array{255, 226, 160} : std::array{240, 242, 247};
          return tint(views[static_cast<std::size_t>(e)].P.norm() / largest);
        },
        true, d);
    for (std::size_t e = 0; station == gradient && e < views.size(); ++e) {
      const Eigen::Vector2d centre = views[e].x.rowwise().mean();
      d.strokes.push_back({ellipse(centre, views[e].F, 0.3 * std::sqrt(views[e].measure)), Ink::purple, true});
    }
    if (station == density) add_arrows(body_.free_nodes(f.reshaped(), state), x, Ink::red, d);
    if (station == acceleration) add_arrows(body_.nodes(sim::accelerations(body_.system(), state)), x, Ink::blue, d);
    return d;
  }

  static void add_arrows(const Eigen::MatrixXd& arrows, const Eigen::MatrixXd& x, Ink ink, render::Diagram& d) {
    const double most = arrows.colwise().norm().maxCoeff();
    if (most > 0) add_forces(x, arrows, 0.12 * (d.x[1] - d.x[0]), most, ink, d);
  }

  ExhibitBody body_;
  int element_;
  double pace_;
};

}  // namespace

std::unique_ptr<Exhibit> make_pipeline(const ExhibitInput& input) {
  return std::make_unique<PipelineOfForces>(input);
}

}  // namespace app
