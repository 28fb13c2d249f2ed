// A hand in the window, from the mouse's move to the picture, at 1280 x 720: a ring of a page of the lecture that is
// dragged (the page's number is the argument), and a body that is pulled while it moves.
#include <benchmark/benchmark.h>

#include <filesystem>
#include <memory>

#include "app/scene/basis_cache.h"
#include "app/scene/deck.h"
#include "app/view/workbench.h"
#include "render/renderer.h"

namespace {

using Kind = render::WindowEvent::Kind;

constexpr int page_width = 1280, page_height = 720;

render::WindowEvent mouse(Kind kind, const render::Spot& at, bool control = false) {
  render::WindowEvent event{};
  event.kind = kind;
  event.button = render::Button::left;
  event.control = control;
  event.x = static_cast<float>(at[0]);
  event.y = static_cast<float>(at[1]);
  return event;
}

class Hand {
 public:
  explicit Hand(const app::Options& options)
      : bench_(options, std::make_unique<app::Session>(options)),
        context_(render::make_offscreen_context()),
        renderer_(*context_, page_width, page_height, 1) {}

  app::Workbench& bench() { return bench_; }
  void does(const render::WindowEvent& event) { bench_.handle(event, page_width, page_height, false); }
  void draw() { benchmark::DoNotOptimize(renderer_.draw(bench_.frame(page_width, page_height))); }
  // Moves to and fro about a spot, takes the step that follows, and draws.
  void move(benchmark::State& state, const render::Spot& about, bool steps) {
    draw();  // the first picture makes ready what others have
    double pixels = 0;
    for (auto _ : state) {
      pixels = pixels > 0 ? -20 : 20;
      does(mouse(Kind::move, {about[0] + pixels, about[1] + pixels}));
      if (steps) bench_.act(app::Action::step);
      draw();
    }
    if (!bench_.message().empty()) state.SkipWithError(bench_.message().c_str());
  }

 private:
  app::Workbench bench_;
  std::unique_ptr<render::Context> context_;
  render::Renderer renderer_;
};

void drag(benchmark::State& state) {
  app::Options options;
  options.scene = app::pages_of(std::filesystem::path(RITZ_SOURCE_DIR) / "assets/lectures").at(state.range(0) - 1);
  Hand hand(options);
  const app::Session& session = hand.bench().session();
  const app::FrameHistory history(*session.simulation());
  const app::Ring ring = history.rings(session.state()).at(0);
  const render::Spot at = render::to_page(ring.diagram, ring.grip.at, page_width, page_height);
  hand.bench().frame(page_width, page_height);
  hand.does(mouse(Kind::press, at));
  hand.move(state, at, false);
}

// 19,440 tets in 20 numbers, or (argument 0) in all of their nodes.
void pull(benchmark::State& state) {
  app::Options options;
  options.scene = std::filesystem::path(RITZ_SOURCE_DIR) / "assets/scenes/benchmarks/beam-cost.toml";
  options.overrides = {{"body.0.mesh.cells", "[40, 9, 9]", "here"},
                       {"body.0.basis.kind", state.range(0) > 0 ? "derivatives" : "none", "here"},
                       {"body.0.basis.cubature", "0.02", "here"}};
  options.cache = app::cache_folder();
  Hand hand(options);
  // Where the body is taken hold of: the first spot from the right that is on it.
  render::Spot at = {page_width, page_height / 2.0};
  for (double y = 20; y < page_height && !hand.bench().session().pull(); y += 20)
    for (double x = page_width - 20; x > 0 && !hand.bench().session().pull(); x -= 20) {
      hand.does(mouse(Kind::release, {x, y}));
      hand.does(mouse(Kind::press, {x, y}, true));
      at = {x, y};
    }
  if (!hand.bench().session().pull()) return state.SkipWithError("nothing to pull at");
  hand.move(state, at, true);
}

BENCHMARK(drag)
    ->Arg(2)
    ->Arg(4)
    ->Arg(5)
    ->Arg(6)
    ->Arg(9)
    ->Arg(11)
    ->Arg(12)
    ->Arg(14)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(pull)->Arg(20)->Arg(0)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
