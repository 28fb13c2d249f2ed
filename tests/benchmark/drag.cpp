// A drag on a page of the lecture: from the mouse's move to the picture, at 1280 x 720. The page's number is the
// argument.
#include <benchmark/benchmark.h>

#include <filesystem>
#include <memory>

#include "app/scene/deck.h"
#include "app/view/workbench.h"
#include "render/renderer.h"

namespace {

constexpr int page_width = 1280, page_height = 720;

render::WindowEvent mouse(render::WindowEvent::Kind kind, const render::Spot& at) {
  render::WindowEvent event{};
  event.kind = kind;
  event.button = render::Button::left;
  event.x = static_cast<float>(at[0]);
  event.y = static_cast<float>(at[1]);
  return event;
}

void drag(benchmark::State& state) {
  using Kind = render::WindowEvent::Kind;
  app::Options options;
  options.scene = app::pages_of(std::filesystem::path(RITZ_SOURCE_DIR) / "assets/lectures").at(state.range(0) - 1);
  app::Workbench bench(options, std::make_unique<app::Session>(options));
  const app::FrameHistory history(*bench.session().simulation());
  const app::Ring ring = history.rings(bench.session().state()).at(0);
  const render::Spot at = render::to_page(ring.diagram, ring.grip.at, page_width, page_height);
  const auto context = render::make_offscreen_context();
  render::Renderer renderer(*context, page_width, page_height, 1);
  bench.frame(page_width, page_height);
  bench.handle(mouse(Kind::press, at), page_width, page_height, false);
  double pixels = 0;
  for (auto _ : state) {
    pixels = pixels > 0 ? -20 : 20;
    bench.handle(mouse(Kind::move, {at[0] + pixels, at[1] + pixels}), page_width, page_height, false);
    benchmark::DoNotOptimize(renderer.draw(bench.frame(page_width, page_height)));
  }
  if (!bench.message().empty()) state.SkipWithError(bench.message().c_str());
}

BENCHMARK(drag)->Arg(2)->Arg(4)->Arg(5)->Arg(6)->Arg(9)->Arg(11)->Arg(12)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
