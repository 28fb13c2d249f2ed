// A body sinks under its weight, in all of its nodes and in r numbers, x = X + U c: in vibration modes, and in modes
// with their derivatives. r counts up, and shows which error falls.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "app/exhibit/body.h"
#include "app/exhibit/draw.h"
#include "app/exhibit/exhibit.h"
#include "app/exhibit/mesh_drawing.h"
#include "app/exhibit/print.h"
#include "sim/mesh/input_error.h"
#include "sim/study/basis.h"
#include "sim/study/projection.h"

namespace app {
namespace {

using render::Ink;

constexpr int most_numbers = 40;
const std::vector<double> counted = {1, 2, 5, 9, 14, 20, most_numbers};
constexpr double rising = 0.6;  // of the pace: the weight rises, then it stays

struct BasisWay {
  sim::BasisKind kind;
  const char* name;
  Ink ink;
};
constexpr std::array<BasisWay, 2> basis_ways = {
    {{sim::BasisKind::modes, "modes", Ink::red}, {sim::BasisKind::derivatives, "derivatives", Ink::blue}}};

class ReducedBasis : public Exhibit {
 public:
  explicit ReducedBasis(const ExhibitInput& input)
      : body_(input), pace_(input.spec.pace), counts_(input.spec.values.empty() ? counted : input.spec.values) {
    if (body_.dimension() != 2) throw sim::InputError("body", "must be of a plane scene");
    for (const double count : counts_)
      if (!(count >= 1 && count <= most_numbers && count == std::floor(count)))
        throw sim::InputError("values", "must be whole numbers from 1 to " + std::to_string(most_numbers));
    scene_ = body_.alone();
    scene_.solver = {};
    scene_.solver.tolerance = 1e-8;
    scene_.bodies[0].basis.reset();
    unknowns_ = sim::System(scene_).counts().free_dofs;
    if (unknowns_ < 2 * most_numbers)
      throw sim::InputError("body", "has " + std::to_string(unknowns_) + " unknowns: too few for a basis to matter");
    rest_ = at_rest(scene_, 1);
    if (rest_.size() == 0 || rest_.isZero())
      throw sim::InputError("body", "must come to rest elsewhere under its weight");
    settle(0);
  }

  void note(const sim::State& state) override {
    settle(body_.time(state));
    trace_.add(body_.time(state), Eigen::Vector3d(r_, errors_[0], errors_[1]));
  }
  Trace* trace() override { return &trace_; }

  void show(const sim::State&, render::Sheet& sheet) const override {
    const std::map<int, Errors> seen = errors_by_count();
    sheet.bodies = false;
    sheet.column = 0.64;
    sheet.diagrams = {beams(), curves(seen)};
    render::Table table{{"r", "modes", "+ derivatives"}, {}, {}};
    for (const auto& [r, errors] : seen) {
      if (r != r_ && std::ranges::find(counted, r) == counted.end()) continue;
      const std::string text = std::to_string(r);
      table.rows.push_back(
          {text,
           {number("modes." + text, "%.4f", 100 * errors[0]), number("derivatives." + text, "%.4f", 100 * errors[1])}});
      if (r == r_) table.boxed = {{static_cast<int>(table.rows.size()) - 1, 1}};
    }
    sheet.blocks.push_back({"error at rest, % of the length", {table}});
    sheet.blocks.push_back({"how many numbers",
                            {render::Line{"all nodes", number("unknowns", "%.0f", unknowns_)},
                             render::Line{"basis", number("r", "%.0f", r_), Ink::blue}}});
    sheet.formula = "x = X + U c     Uᵀ ∇U(X + U c) = 0";
    sheet.proof_label = parts_text() + ":";
    sheet.proof = number("error", "%.4f", 100 * errors_[1], "%");
  }

  std::vector<Grip> grips(const sim::State&) const override {
    return {{1, ring(), "values", [](const render::Spot& to) {
               return "[" + std::to_string(std::clamp<long>(std::lround(std::exp2(to[0])), 1, most_numbers)) + "]";
             }}};
  }

 private:
  using Errors = std::array<double, basis_ways.size()>;

  // Displacements under this share of the weight; none where the body does not come to rest.
  static Eigen::VectorXd at_rest(sim::Scene scene, double share) {
    scene.world.gravity *= share;
    const Eigen::MatrixXd u = sim::displacement_at_rest(std::move(scene), 1);
    return u.cols() > 0 ? Eigen::VectorXd(u.col(0)) : Eigen::VectorXd();
  }

  // The bodies as they are at this time.
  void settle(double t) {
    const auto which = std::min(counts_.size() - 1, static_cast<std::size_t>(t / pace_ + 1e-9));
    if (const int r = static_cast<int>(counts_[which]); r != r_) take_basis(r);
    const double phase = std::clamp((t - static_cast<double>(which) * pace_) / (rising * pace_), 0.0, 1.0);
    const double share = phase * phase * (3 - 2 * phase);
    full_ = placed(share < 1 ? at_rest(scene_, share) : rest_);
    for (std::size_t k = 0; k < basis_ways.size(); ++k)
      reduced_[k] = placed(share < 1 ? at_rest(in_basis_[k], share) : in_basis_rest_[k]);
  }

  void take_basis(int r) {
    r_ = r;
    const sim::System system(scene_);
    for (std::size_t k = 0; k < basis_ways.size(); ++k) {
      sim::Scene scene = scene_;
      scene.bodies[0].basis = sim::Basis{basis_ways[k].kind, r, 0, {}, {}};
      in_basis_[k] = sim::with_bases_made(std::move(scene));
      in_basis_rest_[k] = at_rest(in_basis_[k], 1);
      const bool rests = in_basis_rest_[k].size() > 0;
      errors_[k] =
          rests ? sim::share_of_size(system, in_basis_rest_[k] - rest_) : std::numeric_limits<double>::infinity();
    }
  }

  Eigen::MatrixXd placed(const Eigen::VectorXd& u) const {
    const Eigen::MatrixXd& X = body_.mesh().X;
    return u.size() == 0 ? X : X + u.reshaped(2, X.cols());
  }

  // "2 modes + 3 derivatives"
  std::string parts_text() const {
    const int modes = in_basis_[1].bodies[0].basis->vectors->modes, kept = std::min(modes, r_);
    const auto counted_text = [](int count, const std::string& what) {
      return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
    };
    return counted_text(kept, "mode") + (r_ > kept ? " + " + counted_text(r_ - kept, "derivative") : "");
  }

  // What the frames so far have shown, and what is shown now.
  std::map<int, Errors> errors_by_count() const {
    std::map<int, Errors> seen;
    for (std::size_t k = 0; k < trace_.size(); ++k)
      seen[static_cast<int>(trace_.value(k, 0))] = {trace_.value(k, 1), trace_.value(k, 2)};
    seen[r_] = errors_;
    return seen;
  }

  // In the diagram of errors, in percent.
  static render::Spot spot_of(int r, double error) {
    return {std::log2(r), std::clamp(std::log10(100 * error), lowest, highest)};
  }
  render::Spot ring() const { return spot_of(r_, errors_[1]); }

  render::Diagram beams() const {
    render::Diagram d{.place = {0.01, 0.11, 0.63, 0.50}, .title = "under its weight: grey in all nodes", .equal = true};
    Eigen::MatrixXd all(2, 2 * full_.cols());
    all << body_.mesh().X, placed(rest_);
    cover(all, 0.04, d);
    // A row of names above the body, which bends down.
    const double name = d.y[1] + 0.06 * (d.y[1] - d.y[0]), width = d.x[1] - d.x[0];
    d.y[1] += 0.2 * (d.y[1] - d.y[0]);
    add_elements(
        body_.mesh(), full_,
        [](int) {
          return std::array<int, 3>{205, 210, 219};
        },
        false, d);
    for (std::size_t k = 0; k < basis_ways.size(); ++k) add_outline(body_.mesh(), reduced_[k], basis_ways[k].ink, d);
    d.words.push_back({{d.x[0], name}, std::to_string(r_) + (r_ == 1 ? " mode" : " modes"), Ink::red});
    d.words.push_back({{d.x[0] + 0.4 * width, name}, parts_text(), Ink::blue});
    return d;
  }

  render::Diagram curves(const std::map<int, Errors>& seen) const {
    render::Diagram d{.place = {0.01, 0.50, 0.63, 0.88}, .title = "error at rest in %, over r", .axes = true};
    d.x = {-0.3, std::log2(most_numbers) + 0.3};
    d.y = {lowest, highest};
    d.logarithmic = true;
    for (const double r : counted) d.x_ticks.push_back({std::log2(r), std::to_string(static_cast<int>(r))});
    for (std::size_t k = 0; k < basis_ways.size(); ++k) {
      render::Stroke curve{{}, basis_ways[k].ink};
      for (const auto& [r, errors] : seen) {
        curve.points.push_back(spot_of(r, errors[k]));
        d.dots.push_back({curve.points.back(), basis_ways[k].ink});
      }
      d.strokes.push_back(curve);
    }
    d.dots.push_back({ring(), Ink::blue, true});
    return d;
  }

  static constexpr double lowest = -4, highest = 2;  // powers of ten of percent

  ExhibitBody body_;
  double pace_;
  std::vector<double> counts_;
  sim::Scene scene_;  // in all nodes
  int unknowns_ = 0, r_ = 0;
  Eigen::VectorXd rest_;  // displacements in all nodes
  std::array<sim::Scene, basis_ways.size()> in_basis_;
  std::array<Eigen::VectorXd, basis_ways.size()> in_basis_rest_;
  Errors errors_{};
  Eigen::MatrixXd full_;  // m: where nodes are
  std::array<Eigen::MatrixXd, basis_ways.size()> reduced_;
  Trace trace_{{"r", "modes", "derivatives"}};
};

}  // namespace

std::unique_ptr<Exhibit> make_reduced_basis(const ExhibitInput& input) {
  return std::make_unique<ReducedBasis>(input);
}

}  // namespace app
