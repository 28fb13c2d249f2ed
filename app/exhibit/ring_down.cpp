// A body that starts in a vibration mode rings down: its amplitude over time with the envelope that damping gives, and
// the ratio of successive maxima, measured beside exp(-2 pi zeta/sqrt(1 - zeta^2)), zeta = alpha/(2 omega) + beta
// omega/2.
#include <cmath>
#include <numbers>

#include "app/exhibit/body.h"
#include "app/exhibit/exhibit.h"
#include "app/exhibit/print.h"
#include "sim/study/body_motion.h"
#include "sim/study/modes.h"
#include "sim/study/ring.h"

namespace app {
namespace {

using render::Ink;

class RingDown : public Exhibit {
 public:
  explicit RingDown(const ExhibitInput& input) : body_(input), seconds_(input.scene.time.seconds) {
    const sim::Body& body = body_.body();
    if (body.start.shape != "mode")
      throw sim::InputError("body", "must start in a mode: start = { shape = \"mode\", ... }");
    const sim::Modes modes = sim::vibration_modes(body_.alone(), 0, body.start.mode);
    omega_ = modes.omega[body.start.mode - 1];
    psi_ = modes.shape.col(body.start.mode - 1);
    zeta_ = body.damping.alpha / (2 * omega_) + body.damping.beta * omega_ / 2;
    start_ = sim::modal_motion(body_.system(), body_.system().initial_state(), body_.number(), psi_).q;
  }

  void note(const sim::State& state) override {
    trace_.add(body_.time(state), Eigen::VectorXd::Constant(1, share(state)));
  }
  Trace* trace() override { return &trace_; }

  void show(const sim::State&, render::Sheet& sheet) const override {
    render::Diagram d{.place = {0.61, 0.50, 0.99, 0.84}, .title = "ring-down", .axes = true};
    d.x = {0, seconds_};
    d.y = {-1.1, 1.1};
    for (const double sign : {1.0, -1.0}) {
      render::Stroke envelope{{}, Ink::black, false, true};
      for (int k = 0; k <= 60; ++k) {
        const double t = seconds_ * k / 60;
        envelope.points.push_back({t, sign * std::exp(-zeta_ * omega_ * t)});
      }
      d.strokes.push_back(envelope);
    }
    d.strokes.push_back(trace_.curve(0, Ink::blue));
    sheet.diagrams.push_back(d);
    std::vector<double> values;
    for (std::size_t k = 0; k < trace_.size(); ++k) values.push_back(trace_.value(k, 0));
    const double law = std::exp(-2 * std::numbers::pi * zeta_ / std::sqrt(1 - zeta_ * zeta_));
    const std::vector<double> maxima = sim::maxima(values);
    render::Block block{"ring-down, mode " + std::to_string(body_.body().start.mode), {}};
    block.items.push_back(render::Line{"ζ = α/2ω + βω/2", number("zeta", "%.5f", zeta_)});
    block.items.push_back(render::Line{"maxima, law", number("ratio.law", "%.5f", law)});
    sheet.blocks.push_back(block);
    sheet.formula = "f = −α M v − β K v";
    if (maxima.size() < 2) return;
    sheet.proof_label = "ratio of maxima, measured:";
    sheet.proof = number("ratio", "%.4f", maxima.back() / maxima[maxima.size() - 2]);
  }

 private:
  double share(const sim::State& state) const {
    return sim::modal_motion(body_.system(), state, body_.number(), psi_).q / start_;
  }

  ExhibitBody body_;
  double seconds_, omega_ = 0, zeta_ = 0, start_ = 1;
  Eigen::VectorXd psi_;
  Trace trace_{{"q"}};  // the modal coordinate, of its start
};

}  // namespace

std::unique_ptr<Exhibit> make_ring_down(const ExhibitInput& input) {
  return std::make_unique<RingDown>(input);
}

}  // namespace app
