// How much of its momentum every free body keeps: alpha drains it like e^(-alpha t), beta does not.
#include <algorithm>
#include <cmath>

#include "app/exhibit/body.h"
#include "app/exhibit/exhibit.h"
#include "app/exhibit/print.h"
#include "sim/study/body_motion.h"

namespace app {
namespace {

using render::Ink;

constexpr Ink inks[] = {Ink::red, Ink::blue, Ink::purple};

class MomentumPlot : public Exhibit {
 public:
  explicit MomentumPlot(const ExhibitInput& input) : system_(input.system), seconds_(input.scene.time.seconds) {
    for (std::size_t b = 0; b < input.scene.bodies.size(); ++b) {
      const sim::Body& body = input.scene.bodies[b];
      if (!body.pins.empty() || body.velocity.norm() == 0) continue;
      flyers_.push_back(
          {b, body.name, body.damping.alpha, sim::momentum(system_, system_.initial_state(), b).linear.norm()});
    }
    if (flyers_.empty() || flyers_.size() > std::size(inks))
      throw sim::InputError("kind", "\"momentum\" needs one to three bodies without pins that have a velocity");
    std::vector<std::string> names;
    for (const Flyer& flyer : flyers_) names.push_back(flyer.name + ".p");
    trace_ = Trace(names);
  }

  void note(const sim::State& state) override { trace_.add(system_.time(state.step), shares(state)); }
  Trace* trace() override { return &trace_; }

  void show(const sim::State& state, render::Sheet& sheet) const override {
    const double t = system_.time(state.step);
    render::Diagram d{.place = {0.01, 0.50, 0.60, 0.87}, .title = "p(t) / p(0)", .axes = true, .x_label = "t [s]"};
    d.x = {0, seconds_};
    d.y = {0, 1.1};
    const Eigen::VectorXd now = shares(state);
    render::Block block{"momentum left", {}};
    for (std::size_t k = 0; k < flyers_.size(); ++k) {
      const int which = static_cast<int>(k);
      d.strokes.push_back(trace_.curve(which, inks[k]));
      const std::string& name = flyers_[k].name;
      block.items.push_back(render::Line{name, number(name + ".p", "%.5f", now[which]), inks[k]});
    }
    for (const Flyer& flyer : flyers_) {
      if (flyer.alpha == 0) continue;
      render::Stroke law{{}, Ink::black, false, true};
      for (int i = 0; i <= 60; ++i)
        law.points.push_back({seconds_ * i / 60, std::exp(-flyer.alpha * seconds_ * i / 60)});
      d.strokes.push_back(law);
      block.items.push_back(render::Line{"e⁻ᵅᵗ", number("exp", "%.5f", std::exp(-flyer.alpha * t))});
    }
    sheet.diagrams.push_back(d);
    sheet.blocks.push_back(block);
    sheet.picture = {0.01, 0.11, 0.62, 0.50};
  }

 private:
  struct Flyer {
    std::size_t body;
    std::string name;
    double alpha;  // 1/s
    double start;  // kg m/s
  };
  Eigen::VectorXd shares(const sim::State& state) const {
    Eigen::VectorXd all(static_cast<Eigen::Index>(flyers_.size()));
    for (std::size_t k = 0; k < flyers_.size(); ++k)
      all[static_cast<Eigen::Index>(k)] =
          sim::momentum(system_, state, flyers_[k].body).linear.norm() / flyers_[k].start;
    return all;
  }

  const sim::System& system_;
  double seconds_;
  std::vector<Flyer> flyers_;
  Trace trace_{{}};  // shares of the momenta at the start
};

}  // namespace

std::unique_ptr<Exhibit> make_momentum(const ExhibitInput& input) {
  return std::make_unique<MomentumPlot>(input);
}

}  // namespace app
