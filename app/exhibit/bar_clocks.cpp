// Bars that ring in one mode, with consistent and with lumped mass: a clock for each, and all frequencies beside exact
// ones.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/exhibit/body.h"
#include "app/exhibit/draw.h"
#include "app/exhibit/exhibit.h"
#include "app/exhibit/print.h"
#include "sim/study/bar.h"
#include "sim/study/body_motion.h"

namespace app {
namespace {

using render::Ink;
using std::numbers::pi;

// One bar of the scene.
struct Bar {
  std::size_t number;  // of its body
  std::string mass;    // "lumped", "consistent"
  sim::BarModes modes;
  double start = 1;  // of the modal coordinate
  Ink ink = Ink::red;
};

class BarClocks : public Exhibit {
 public:
  explicit BarClocks(const ExhibitInput& input) : scene_(input.scene), system_(input.system), mode_(input.spec.count) {
    for (std::size_t b = 0; b < scene_.bodies.size(); ++b) {
      const sim::Body& body = scene_.bodies[b];
      if (body.mesh.kind != sim::ElementKind::quad4)
        throw sim::InputError("kind", "\"bar-clocks\" needs strips of quad4, one cell high");
      cells_ = body.mesh.element_count();
      Bar bar{b, std::string(sim::name_of(body.mass)), sim::bar_modes(scene_, b, cells_)};
      bar.ink = bar.mass == "lumped" ? Ink::red : Ink::blue;
      if (bar.modes.omega.size() < mode_) throw sim::InputError("count", "is the number of a mode: the bar has fewer");
      bar.start = sim::modal_motion(system_, system_.initial_state(), b, bar.modes.shape.col(mode_ - 1)).q;
      bars_.push_back(std::move(bar));
    }
    length_ = scene_.bodies[0].mesh.X.row(0).maxCoeff() - scene_.bodies[0].mesh.X.row(0).minCoeff();
  }

  void show(const sim::State& state, render::Sheet& sheet) const override {
    const sim::MaterialSpec& material = scene_.bodies[0].materials[0];
    sheet.bodies = false;
    sheet.column = 0.63;
    for (std::size_t k = 0; k < bars_.size(); ++k) {
      sheet.diagrams.push_back(bar(bars_[k], k, state));
      sheet.diagrams.push_back(clock(bars_[k], k, state));
    }
    sheet.diagrams.push_back(spectrum(material));
    const double exact = sim::bar_frequencies(length_, material.young, material.density, cells_, mode_).exact;
    render::Block block{"mode " + std::to_string(mode_) + " of " + std::to_string(cells_), {}};
    block.items.push_back(render::Line{"exact", number("exact", "%.4f", exact / (2 * pi), "Hz")});
    render::Block limits{"h < 2/ωₘₐₓ", {}};
    for (const Bar& bar : bars_) {
      const double omega = bar.modes.omega[mode_ - 1];
      block.items.push_back(render::Line{bar.mass, number(bar.mass, "%.4f", omega / (2 * pi), "Hz"), bar.ink});
      block.items.push_back(
          render::Line{"  − exact", number(bar.mass + ".error", "%+.2f", 100 * (omega / exact - 1), "%"), bar.ink});
      limits.items.push_back(render::Line{
          bar.mass, number(bar.mass + ".limit", "%.4f", 2000 / bar.modes.omega[cells_ - 1], "ms"), bar.ink});
    }
    sheet.blocks = {block, limits};
    sheet.formula = "mᵢⱼ = ∫ ρ Nᵢ Nⱼ dV";
    if (bars_.size() < 2) return;
    sheet.proof_label = "ratio of the limits:";
    sheet.proof = number("ratio", "%.4f", bars_[1].modes.omega[cells_ - 1] / bars_[0].modes.omega[cells_ - 1]);
  }

 private:
  // Cross-sections of the bar at their places, drawn so that they nearly meet at the start.
  render::Diagram bar(const Bar& bar, std::size_t row, const sim::State& state) const {
    const double top = 0.11 + 0.19 * static_cast<double>(row);
    render::Diagram d{.place = {0.01, top, 0.49, top + 0.18}, .title = bar.mass};
    d.x = {-0.05 * length_, 1.1 * length_};
    d.y = {0, 1};
    const sim::BodyRange& range = system_.bodies()[bar.number];
    const double least = range.mesh->X.row(1).minCoeff();
    std::vector<std::array<double, 2>> sections;
    for (int i = 0; i < range.node_count; ++i) {
      if (range.mesh->X(1, i) > least + 1e-9) continue;
      const double X = range.mesh->X(0, i), u = state.x[2 * (range.first_node + i)] - X;
      sections.push_back({X, u});
    }
    const double start = std::abs(bar.start) * bar.modes.shape.col(mode_ - 1).cwiseAbs().maxCoeff();
    const double scale = start > 0 ? 0.4 * length_ / cells_ / start : 0;
    std::ranges::sort(sections);
    for (std::size_t k = 0; k + 1 < sections.size(); ++k) {
      const double a = sections[k][0] + scale * sections[k][1], b = sections[k + 1][0] + scale * sections[k + 1][1];
      const double stretch = (b - a) / (sections[k + 1][0] - sections[k][0]);
      d.patches.push_back({{{a, 0.15}, {b, 0.15}, {b, 0.85}, {a, 0.85}}, tint(1.2 - 0.8 * stretch)});
    }
    for (const auto& [X, u] : sections)
      d.strokes.push_back(
          {{{X + scale * u, 0.15}, {X + scale * u, 0.85}}, bar.ink, false, false, X == 0 ? 2.5F : 1.0F});
    return d;
  }

  // The hand shows the phase of the mode: q = cos(phase), dq/dt = -omega sin(phase).
  render::Diagram clock(const Bar& bar, std::size_t row, const sim::State& state) const {
    const double top = 0.11 + 0.19 * static_cast<double>(row);
    render::Diagram d{.place = {0.49, top, 0.61, top + 0.18}, .equal = true};
    d.x = d.y = {-1.15, 1.15};
    const sim::ModalMotion motion = sim::modal_motion(system_, state, bar.number, bar.modes.shape.col(mode_ - 1));
    const double phase = std::atan2(-motion.rate / bar.modes.omega[mode_ - 1], motion.q);
    d.strokes.push_back({ellipse({0, 0}, Eigen::Matrix2d::Identity(), 1), Ink::black, true});
    d.darts.push_back({{0, 0}, {0.9 * std::sin(phase), 0.9 * std::cos(phase)}, bar.ink});
    return d;
  }

  render::Diagram spectrum(const sim::MaterialSpec& material) const {
    render::Diagram d{
        .place = {0.01, 0.49, 0.61, 0.87}, .title = "frequency over exact frequency, by mode", .axes = true};
    d.x = {0.5, cells_ + 0.5};
    d.y = {0.6, 1.25};
    d.strokes.push_back({{{0.5, 1}, {cells_ + 0.5, 1}}, Ink::black, false, true});
    for (const Bar& bar : bars_) {
      render::Stroke curve{{}, bar.ink};
      for (int k = 1; k <= cells_; ++k) {
        const double exact = sim::bar_frequencies(length_, material.young, material.density, cells_, k).exact;
        curve.points.push_back({double(k), bar.modes.omega[k - 1] / exact});
        d.dots.push_back({curve.points.back(), bar.ink});
      }
      d.words.push_back({{cells_ * (bar.mass == "lumped" ? 0.55 : 0.35), bar.mass == "lumped" ? 0.72 : 1.17},
                         bar.mass,
                         bar.ink,
                         render::Side::middle});
      d.strokes.push_back(curve);
    }
    return d;
  }

  sim::Scene scene_;
  const sim::System& system_;
  int mode_, cells_ = 1;
  double length_ = 1;
  std::vector<Bar> bars_;
};

}  // namespace

std::unique_ptr<Exhibit> make_bar_clocks(const ExhibitInput& input) {
  return std::make_unique<BarClocks>(input);
}

}  // namespace app
