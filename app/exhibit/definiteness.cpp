// The definiteness fix: eigenvalues of an element's stiffness before and after, and where Newton's method ends on the
// true energy of one free node, by the exact matrix, the clamped one and that of absolute values.
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "app/exhibit/body.h"
#include "app/exhibit/draw.h"
#include "app/exhibit/exhibit.h"
#include "app/exhibit/print.h"
#include "app/scene/value_text.h"
#include "sim/mesh/input_error.h"
#include "sim/study/element_view.h"
#include "sim/study/pure_newton.h"

namespace app {
namespace {

using render::Ink;
using sim::Definiteness;

struct Fix {
  const char* name;
  Definiteness kind;
  Ink ink;
  bool dashed;
  render::Side side;  // of its name, at the path's end
};
constexpr Fix fixes[] = {{"none", Definiteness::none, Ink::red, false, render::Side::below},
                         {"clamp", Definiteness::clamp, Ink::black, true, render::Side::left},
                         {"abs", Definiteness::abs, Ink::blue, false, render::Side::right}};

const char* name_of(const sim::NewtonPath& path) {
  if (path.singular) return "K = 0: stuck";
  switch (path.end) {
    case sim::Stationary::minimum:
      return "minimum";
    case sim::Stationary::maximum:
      return "maximum";
    case sim::Stationary::saddle:
      return "saddle";
    case sim::Stationary::none:
      break;
  }
  return "no end";
}

class DefinitenessFix : public Exhibit {
 public:
  explicit DefinitenessFix(const ExhibitInput& input) : body_(input), pace_(input.spec.pace) {
    sim::view_element(body_.body(), 0, body_.mesh().X.leftCols(3));  // refuses other elements
    const sim::Mesh& mesh = body_.mesh();
    if (mesh.node_count() != 3) throw sim::InputError("body", "must be a single triangle");
    const std::vector<int> pinned = input.system.pinned_nodes(0);
    while (free_ < 3 && std::ranges::find(pinned, body_.range().first_node + free_) != pinned.end()) ++free_;
    if (pinned.size() != 2 || free_ == 3) throw sim::InputError("body", "must have one free node and two pinned ones");
    start_ = input.system.initial_state().x;
    if (input.spec.nodes.size() > 1) throw sim::InputError("nodes", "must be one point: where the free node starts");
    if (!input.spec.nodes.empty()) start_.segment(2 * free_, 2) = input.spec.nodes[0].head<2>();
    for (const Fix& fix : fixes) paths_.push_back(sim::pure_newton(input.system, start_, fix.kind));
    survey();
  }

  void show(const sim::State& state, render::Sheet& sheet) const override {
    const int shown = static_cast<int>(std::floor(body_.time(state) / pace_ + 1e-9));
    sheet.bodies = false;
    sheet.column = 0.60;
    sheet.diagrams.push_back(landscape(shown));
    sheet.diagrams.push_back(bars());
    render::Table table{{"", "steps", "U [J]", "ends at"}, {}, {}};
    for (std::size_t k = 0; k < paths_.size(); ++k) {
      const sim::NewtonPath& path = paths_[k];
      const int at = std::min(shown, path.iterations());
      const bool ended = shown >= path.iterations();
      const std::string name = fixes[k].name;
      table.rows.push_back({name,
                            {number(name + ".steps", "%.0f", at),
                             number(name + ".U", "%.1f", path.energy[static_cast<std::size_t>(at)], "J"),
                             {name + ".end", ended ? name_of(path) : "...", ""}},
                            fixes[k].ink});
    }
    sheet.blocks.push_back({"Newton on U of the free node", {table}});
    sheet.blocks.push_back(eigenvalues());
    sheet.formula = "Kₑ = Σ λ v vᵀ,   λ < 0 → 0 or |λ|";
    sheet.proof_label = "λ of K where “none” ends:";
    sheet.proof = number("none.lambda", "%.1f", paths_[0].end_eigenvalues[0], "N/m");
  }

  std::vector<Grip> grips(const sim::State&) const override {
    return {{0, spot(start_.segment<2>(2 * free_)), "nodes", [](const render::Spot& to) {
               return "[[" + number_literal(to[0]) + ", " + number_literal(to[1]) + "]]";
             }}};
  }

 private:
  static constexpr int across = 44, up = 34;

  // U over the places of the free node.
  void survey() {
    const Eigen::MatrixXd& X = body_.mesh().X;
    const Eigen::Vector2d low = X.rowwise().minCoeff(), high = X.rowwise().maxCoeff();
    const double size = (high - low).maxCoeff();
    x_ = {low.x() - 0.15 * size, high.x() + 0.25 * size};
    y_ = {std::min(low.y() - 0.35 * size, start_[2 * free_ + 1] - 0.1 * size), high.y() + 0.25 * size};
    Eigen::VectorXd x = start_;
    energy_.resize(up + 1, across + 1);
    for (int j = 0; j <= up; ++j)
      for (int i = 0; i <= across; ++i) {
        const render::Spot at = place(i, j);
        x[2 * free_] = at[0];
        x[2 * free_ + 1] = at[1];
        energy_(j, i) = sim::potential_energy(body_.system(), x);
      }
  }
  render::Spot place(int i, int j) const {
    return {x_[0] + (x_[1] - x_[0]) * i / across, y_[0] + (y_[1] - y_[0]) * j / up};
  }

  render::Diagram landscape(int shown) const {
    render::Diagram d{.place = {0.01, 0.11, 0.58, 0.66}, .title = "U of the free node; deep is white", .equal = true};
    d.x = x_;
    d.y = y_;
    const double reach = 1.3 * paths_[0].energy[0];
    for (int j = 0; j < up; ++j)
      for (int i = 0; i < across; ++i) {
        const double mean = energy_.block(j, i, 2, 2).mean();
        d.patches.push_back({{place(i, j), place(i + 1, j), place(i + 1, j + 1), place(i, j + 1)},
                             tint(std::sqrt(std::clamp(mean / reach, 0.0, 1.0)))});
      }
    d.strokes.push_back({polygon(body_.mesh().X), Ink::black, true});
    for (std::size_t k = 0; k < paths_.size(); ++k) {
      const int last = std::min(shown, paths_[k].iterations());
      render::Stroke stroke{{}, fixes[k].ink, false, fixes[k].dashed};
      for (int p = 0; p <= last; ++p) {
        stroke.points.push_back(spot(paths_[k].points[static_cast<std::size_t>(p)].segment<2>(2 * free_)));
        d.dots.push_back({stroke.points.back(), fixes[k].ink});
      }
      d.strokes.push_back(stroke);
      if (shown > 0) d.words.push_back({stroke.points.back(), fixes[k].name, fixes[k].ink, fixes[k].side});
    }
    d.dots.push_back({spot(start_.segment<2>(2 * free_)), Ink::black, true});
    return d;
  }

  Eigen::VectorXd eigenvalues(Definiteness fix) const {
    const Eigen::MatrixXd x = sim::element_nodes(body_.mesh(), 0, body_.range().first_node, start_);
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(sim::element_stiffness(body_.body(), 0, x, fix))
        .eigenvalues();
  }

  // The six eigenvalues of the element's stiffness at the start, by fix.
  render::Diagram bars() const {
    render::Diagram d{.place = {0.01, 0.67, 0.58, 0.87}, .title = "eigenvalues of Kₑ at the start"};
    d.x = {-0.5, 20.5};
    double reach = 0;
    for (const Fix& fix : fixes) reach = std::max(reach, eigenvalues(fix.kind).cwiseAbs().maxCoeff());
    d.y = {-0.7 * reach, 1.05 * reach};
    d.strokes.push_back({{{-0.5, 0}, {20.5, 0}}, Ink::black});
    for (std::size_t k = 0; k < std::size(fixes); ++k) {
      const Eigen::VectorXd values = eigenvalues(fixes[k].kind);
      d.words.push_back(
          {{7 * static_cast<double>(k) + 4, -0.4 * reach}, fixes[k].name, fixes[k].ink, render::Side::middle});
      for (Eigen::Index i = 0; i < values.size(); ++i) {
        const double at = 7 * static_cast<double>(k) + static_cast<double>(i);
        const Ink ink = values[i] < -1e-9 * reach ? Ink::red : Ink::blue;
        d.strokes.push_back({{{at, 0}, {at, values[i]}}, ink, false, false, 4});
      }
    }
    return d;
  }

  render::Block eigenvalues() const {
    const Eigen::VectorXd none = eigenvalues(Definiteness::none), clamp = eigenvalues(Definiteness::clamp),
                          abs = eigenvalues(Definiteness::abs);
    render::Table table{{"λ [N/m]", "none", "clamp", "abs"}, {}, {}};
    for (Eigen::Index i = 0; i < none.size(); ++i) {
      const std::string index = std::to_string(i + 1);
      table.rows.push_back(
          {index,
           {number("none." + index, "%.0f", none[i], "N/m"), number("clamp." + index, "%.0f", clamp[i], "N/m"),
            number("abs." + index, "%.0f", abs[i], "N/m")},
           none[i] < -1e-6 * none.cwiseAbs().maxCoeff() ? Ink::red : Ink::black});
    }
    return {"", {table}};
  }

  ExhibitBody body_;
  double pace_;
  int free_ = 0;
  Eigen::VectorXd start_;
  std::vector<sim::NewtonPath> paths_;
  std::array<double, 2> x_{}, y_{};
  Eigen::MatrixXd energy_;
};

}  // namespace

std::unique_ptr<Exhibit> make_definiteness(const ExhibitInput& input) {
  return std::make_unique<DefinitenessFix>(input);
}

}  // namespace app
