// Shape functions as hills over the mesh: one node's after the other, then their sum; a point walks over the mesh.
#include "sim/study/shape_functions.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

#include "app/exhibit/body.h"
#include "app/exhibit/draw.h"
#include "app/exhibit/exhibit.h"
#include "app/exhibit/mesh_drawing.h"
#include "app/exhibit/print.h"
#include "app/scene/value_text.h"
#include "sim/mesh/input_error.h"

namespace app {
namespace {

using render::Ink;

constexpr int fine = 8;  // pieces of an element's edge

class ShapeFunctions : public Exhibit {
 public:
  explicit ShapeFunctions(const ExhibitInput& input)
      : body_(input), node_(input.spec.node), pace_(input.spec.pace), values_(input.spec.values) {
    if (body_.dimension() != 2) throw sim::InputError("body", "must be of a plane scene");
    const int nodes = body_.mesh().node_count();
    if (node_ >= nodes) throw sim::InputError("node", "the body has nodes 0 to " + std::to_string(nodes - 1));
    if (!values_.empty() && values_.size() != static_cast<std::size_t>(nodes))
      throw sim::InputError("values", "must be a number for each of the " + std::to_string(nodes) + " nodes");
  }

  void show(const sim::State& state, render::Sheet& sheet) const override {
    const Eigen::VectorXd heights = shown(state);
    sheet.bodies = false;
    sheet.column = 0.66;
    sheet.diagrams.push_back(hill(heights, state));
    const sim::PointOfElement at = point(state);
    const sim::ShapeValues values = sim::shape_values(body_.mesh(), at);
    render::Block block{"under the point", {}};
    std::map<int, render::Number> lines;  // in the order of nodes
    double sum = 0, f = 0;
    for (Eigen::Index a = 0; a < values.N.size(); ++a) {
      const int node = body_.mesh().elements(a, at.element);
      sum += values.N[a];
      f += values.N[a] * heights[node];
      lines.emplace(node, number("N" + std::to_string(node), "%.6f", values.N[a]));
    }
    for (const auto& [node, line] : lines) block.items.push_back(render::Line{"N" + subscript(node), line});
    sheet.blocks.push_back(block);
    sheet.blocks.push_back({"", {render::Line{"Σ fᵢ Nᵢ", number("f", "%.6f", f), Ink::blue}}});
    sheet.formula = "φ(X) = Σ xᵢ Nᵢ(X),   Nᵢ(Xⱼ) = 0 or 1";
    sheet.proof_label = "Σ Nᵢ =";
    sheet.proof = number("sum", "%.6f", sum);
  }

  std::vector<Grip> grips(const sim::State& state) const override {
    const Eigen::VectorXd heights = shown(state);
    std::vector<Grip> all;
    for (int i = 0; i < body_.mesh().node_count(); ++i) {
      const render::Spot foot = lifted(body_.mesh().X.col(i), 0);
      all.push_back(
          {0, lifted(body_.mesh().X.col(i), heights[i]), "values", [heights, i, foot](const render::Spot& to) {
             std::string text;
             for (Eigen::Index k = 0; k < heights.size(); ++k)
               text += (k == 0 ? "[" : ", ") + number_literal(k == i ? (to[1] - foot[1]) / rise : heights[k]);
             return text + "]";
           }});
    }
    return all;
  }

 private:
  // A spot of the mesh and a height, seen obliquely from the front.
  static constexpr double lean = 0.45, depth = 0.55, rise = 0.8;
  static render::Spot lifted(const Eigen::Vector2d& X, double height) {
    return {X.x() + lean * X.y(), depth * X.y() + rise * height};
  }

  static std::string subscript(int number) {
    static constexpr const char* digits[] = {"₀", "₁", "₂", "₃", "₄", "₅", "₆", "₇", "₈", "₉"};
    std::string text;
    for (const char c : std::to_string(number)) text += digits[c - '0'];
    return text;
  }

  // Which node's hill is shown: that of the key, or one after the other and then the sum of all.
  int turn(const sim::State& state) const {
    if (node_ >= 0) return node_;
    return static_cast<int>(std::floor(body_.time(state) / pace_ + 1e-9)) % (body_.mesh().node_count() + 1);
  }
  Eigen::VectorXd shown(const sim::State& state) const {
    const int nodes = body_.mesh().node_count(), node = turn(state);
    if (!values_.empty()) return Eigen::Map<const Eigen::VectorXd>(values_.data(), nodes);
    return node == nodes ? Eigen::VectorXd(Eigen::VectorXd::Ones(nodes))
                         : Eigen::VectorXd(Eigen::VectorXd::Unit(nodes, node));
  }

  // Around the middle of the mesh once in eight paces.
  sim::PointOfElement point(const sim::State& state) const {
    const Eigen::MatrixXd& X = body_.mesh().X;
    const Eigen::Vector2d low = X.rowwise().minCoeff(), high = X.rowwise().maxCoeff();
    const double angle = 2 * std::numbers::pi * body_.time(state) / (8 * pace_) + 0.7;
    const Eigen::Vector2d at =
        (low + high) / 2 + 0.27 * (high - low).minCoeff() * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    return sim::find_point_of_element(body_.mesh(), at);
  }

  render::Diagram hill(const Eigen::VectorXd& heights, const sim::State& state) const {
    const sim::Mesh& mesh = body_.mesh();
    render::Diagram d{.place = {0.02, 0.11, 0.64, 0.86}, .equal = true};
    const Eigen::Vector2d low = mesh.X.rowwise().minCoeff(), high = mesh.X.rowwise().maxCoeff();
    const render::Spot a = lifted(low, 0), b = lifted(high, 1.15);
    d.x = {a[0] - 0.1, b[0] + 0.1};
    d.y = {a[1] - 0.25, b[1]};
    // What is behind comes first.
    std::vector<int> order(static_cast<std::size_t>(mesh.element_count()));
    std::iota(order.begin(), order.end(), 0);
    const auto place = [&](int e) { return corners(mesh, e, mesh.X).row(1).mean(); };
    std::ranges::stable_sort(order, [&](int a, int b) { return place(a) > place(b); });
    for (const int e : order) add_element(mesh, e, d);
    for (const int e : order) add_hill(mesh, e, heights, d);
    for (int i = 0; i < mesh.node_count(); ++i) {
      const render::Spot foot = lifted(mesh.X.col(i), 0), top = lifted(mesh.X.col(i), heights[i]);
      if (heights[i] != 0) d.strokes.push_back({{foot, top}, Ink::blue});
      d.dots.push_back({top, Ink::blue, true});
    }
    const sim::PointOfElement at = point(state);
    const sim::ShapeValues values = sim::shape_values(mesh, at);
    double f = 0;
    for (Eigen::Index k = 0; k < values.N.size(); ++k) f += values.N[k] * heights[mesh.elements(k, at.element)];
    d.strokes.push_back({{lifted(values.X, 0), lifted(values.X, f)}, Ink::red, false, true});
    d.dots.push_back({lifted(values.X, f), Ink::red});
    return d;
  }

  static void add_element(const sim::Mesh& mesh, int e, render::Diagram& d) {
    std::vector<render::Spot> outline;
    const Eigen::MatrixXd X = corners(mesh, e, mesh.X);
    for (Eigen::Index a = 0; a < X.cols(); ++a) outline.push_back(lifted(X.col(a), 0));
    d.patches.push_back({outline, {240, 242, 247}});
    d.strokes.push_back({outline, Ink::black, true});
  }

  // The surface over one element, in small facets; blue where it is high, red where it is below zero.
  static void add_hill(const sim::Mesh& mesh, int e, const Eigen::VectorXd& heights, render::Diagram& d) {
    bool flat = true;
    for (const std::vector<sim::PointOfElement>& facet : sim::facets_of_element(mesh, e, fine)) {
      render::Patch patch;
      double mean = 0;
      for (const sim::PointOfElement& corner : facet) {
        const sim::ShapeValues values = sim::shape_values(mesh, corner);
        double f = 0;
        for (Eigen::Index k = 0; k < values.N.size(); ++k) f += values.N[k] * heights[mesh.elements(k, e)];
        mean += f / static_cast<double>(facet.size());
        patch.points.push_back(lifted(values.X, f));
      }
      if (std::abs(mean) < 1e-9) continue;
      flat = false;
      patch.colour = mean > 0 ? tint(0.15 + 0.85 * mean) : std::array{250, 214, 208};
      d.patches.push_back(patch);
    }
    if (!flat) add_ridges(mesh, e, heights, d);
  }

  // The surface above the edges of an element.
  static void add_ridges(const sim::Mesh& mesh, int e, const Eigen::VectorXd& heights, render::Diagram& d) {
    const Eigen::MatrixXd X = corners(mesh, e, mesh.X);
    render::Stroke ridge{{}, Ink::blue, true};
    for (Eigen::Index a = 0; a < X.cols(); ++a)
      for (int k = 0; k < fine; ++k) {
        const Eigen::Vector2d at = X.col(a) + (X.col((a + 1) % X.cols()) - X.col(a)) * k / fine;
        const sim::PointOfElement point = sim::find_point_of_element(mesh, at);
        const sim::ShapeValues values = sim::shape_values(mesh, point);
        double f = 0;
        for (Eigen::Index n = 0; n < values.N.size(); ++n) f += values.N[n] * heights[mesh.elements(n, point.element)];
        ridge.points.push_back(lifted(at, f));
      }
    d.strokes.push_back(ridge);
  }

  ExhibitBody body_;
  int node_;
  double pace_;
  std::vector<double> values_;
};

}  // namespace

std::unique_ptr<Exhibit> make_shape_functions(const ExhibitInput& input) {
  return std::make_unique<ShapeFunctions>(input);
}

}  // namespace app
