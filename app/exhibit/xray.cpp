// One triangle looked into: edges at rest and now, F with the ellipse that it makes of a circle, stress and forces.
#include "app/exhibit/body.h"
#include "app/exhibit/draw.h"
#include "app/exhibit/exhibit.h"
#include "app/exhibit/print.h"
#include "app/scene/value_text.h"
#include "sim/mesh/input_error.h"
#include "sim/study/element_view.h"

namespace app {
namespace {

using render::Ink;

// The largest circle inside a triangle.
struct Incircle {
  Eigen::Vector2d centre;
  double radius;
  explicit Incircle(const Eigen::MatrixXd& X) {
    const double a = (X.col(1) - X.col(2)).norm(), b = (X.col(2) - X.col(0)).norm(), c = (X.col(0) - X.col(1)).norm();
    centre = (a * X.col(0) + b * X.col(1) + c * X.col(2)) / (a + b + c);
    const Eigen::Vector2d u = X.col(1) - X.col(0), v = X.col(2) - X.col(0);
    radius = std::abs(u.x() * v.y() - u.y() * v.x()) / (a + b + c);
  }
};

class XRay : public Exhibit {
 public:
  explicit XRay(const ExhibitInput& input) : body_(input), element_(input.spec.element), held_(input.spec.nodes) {
    if (body_.dimension() != 2) throw sim::InputError("body", "must be of a plane scene");
    if (!held_.empty() && held_.size() != 3) throw sim::InputError("nodes", "must be three points");
    sim::view_element(body_.body(), element_, body_.mesh().X.leftCols(3));  // refuses other elements
  }

  void show(const sim::State& state, render::Sheet& sheet) const override {
    const sim::ElementView view = sim::view_element(body_.body(), element_, nodes(state));
    sheet.bodies = false;
    sheet.column = 0.63;
    sheet.diagrams.push_back(at_rest(view));
    sheet.diagrams.push_back(now(view));
    sheet.blocks = {deformation(view), stress(view), forces(view)};
    sheet.formula = "F = Dₛ Dₘ⁻¹    [f₂ f₃] = −P Dₘ⁻ᵀ V";
    sheet.proof_label = "Σ xᵢ × fᵢ =";
    sheet.proof = number("torque", "%.3f", view.torque, "N m");
  }

  std::vector<Grip> grips(const sim::State& state) const override {
    const Eigen::MatrixXd x = nodes(state);
    std::vector<Grip> all;
    for (Eigen::Index a = 0; a < 3; ++a) {
      all.push_back({1, spot(x.col(a)), "nodes", [x, a](const render::Spot& to) {
                       Eigen::MatrixXd moved = x;
                       moved.col(a) << to[0], to[1];
                       std::string text;
                       for (Eigen::Index i = 0; i < 3; ++i)
                         text += (i == 0 ? "[[" : ", [") + number_literal(moved(0, i)) + ", " +
                                 number_literal(moved(1, i)) + "]";
                       return text + "]";
                     }});
    }
    return all;
  }

 private:
  // Where they are held, else where the body has them.
  Eigen::MatrixXd nodes(const sim::State& state) const {
    if (held_.empty()) return body_.element_nodes(element_, state);
    Eigen::MatrixXd x(2, 3);
    for (Eigen::Index a = 0; a < 3; ++a) x.col(a) = held_[static_cast<std::size_t>(a)].head<2>();
    return x;
  }

  static void add_edges(const Eigen::MatrixXd& x, const char* name, render::Diagram& diagram) {
    diagram.darts.push_back({spot(x.col(0)), spot(x.col(1)), Ink::blue});
    diagram.darts.push_back({spot(x.col(0)), spot(x.col(2)), Ink::blue});
    static constexpr const char* digits[] = {"₁", "₂", "₃"};
    const Eigen::Vector2d middle = x.rowwise().mean();
    for (Eigen::Index a = 0; a < 3; ++a) {
      const bool right = x(0, a) > middle.x();
      diagram.words.push_back({spot(x.col(a)), std::string(name) + digits[a], Ink::black,
                               right ? render::Side::right : render::Side::left});
    }
  }

  static render::Diagram at_rest(const sim::ElementView& view) {
    render::Diagram d{.place = {0.01, 0.11, 0.28, 0.60}, .title = "at rest: Dₘ", .equal = true};
    cover(view.X, 0.25, d);
    d.patches.push_back({polygon(view.X)});
    d.strokes.push_back({polygon(view.X), Ink::black, true});
    const Incircle circle(view.X);
    d.strokes.push_back({ellipse(circle.centre, Eigen::Matrix2d::Identity(), circle.radius), Ink::purple, true});
    add_edges(view.X, "X", d);
    return d;
  }

  static render::Diagram now(const sim::ElementView& view) {
    render::Diagram d{.place = {0.26, 0.11, 0.62, 0.86}, .title = "now: Dₛ, ellipse, forces", .equal = true};
    // Room for a corner to be dragged: what is seen does not follow it.
    cover(view.X, 0.6, d);
    const bool over = view.J < 0;
    d.patches.push_back({polygon(view.x), over ? std::array{250, 214, 208} : std::array{225, 231, 242}});
    d.strokes.push_back({polygon(view.x), over ? Ink::red : Ink::black, true});
    const Incircle circle(view.X);
    const Eigen::Vector2d centre = view.x.col(0) + view.F * (circle.centre - Eigen::Vector2d(view.X.col(0)));
    d.strokes.push_back({ellipse(centre, view.F, circle.radius), Ink::purple, true});
    for (Eigen::Index k = 0; k < 2; ++k) {
      const Eigen::Vector2d axis = circle.radius * view.stretches[k] * view.U.col(k);
      d.strokes.push_back({{spot(centre - axis), spot(centre + axis)}, Ink::purple, false, k == 1});
    }
    const double largest = view.f.colwise().norm().maxCoeff();
    if (largest > 0) add_forces(view.x, view.f, 0.3 * (d.x[1] - d.x[0]), largest, Ink::red, d);
    add_edges(view.x, "x", d);
    for (Eigen::Index a = 0; a < 3; ++a) d.dots.push_back({spot(view.x.col(a)), Ink::black, true});
    return d;
  }

  static render::Block deformation(const sim::ElementView& view) {
    const bool over = view.J < 0;
    return {
        "",
        {matrix("Dₘ", "Dm", "%.3f", view.Dm, "m"), matrix("Dₛ", "Ds", "%.3f", view.Ds, "m"),
         matrix("F", "F", "%.4f", view.F),
         render::Line{over ? "J, turned over" : "J = det F", number("J", "%.4f", view.J), over ? Ink::red : Ink::black},
         render::Line{"σ₁", number("s1", "%.4f", view.stretches[0]), Ink::purple},
         render::Line{"σ₂", number("s2", "%.4f", view.stretches[1]), Ink::purple}}};
  }

  static render::Block stress(const sim::ElementView& view) {
    const Scaled pascal = scaled(view.P.cwiseAbs().maxCoeff(), "Pa");
    return {"", {matrix("P", "P", "%.3f", view.P / pascal.factor, pascal.unit)}};
  }

  static render::Block forces(const sim::ElementView& view) {
    const Scaled newton = scaled(view.f.cwiseAbs().maxCoeff(), "N");
    return {"", {matrix("f₁f₂f₃", "f", "%.2f", view.f / newton.factor, newton.unit)}};
  }

  ExhibitBody body_;
  int element_;
  std::vector<sim::Vec3> held_;
};

}  // namespace

std::unique_ptr<Exhibit> make_xray(const ExhibitInput& input) {
  return std::make_unique<XRay>(input);
}

}  // namespace app
