// Milliseconds per drawn and per encoded frame; and a whole `ritz record` against the largest of its three stages.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>

#include "app/base/output_file.h"
#include "app/command/commands.h"
#include "app/record/pipeline.h"
#include "render/png.h"
#include "render/renderer.h"
#include "tests/benchmark/ball.h"

namespace {

render::Frame frame() {
  render::Frame frame;
  frame.camera.eye = {0, 2, 6};
  frame.camera.target = {0, 1, 0};
  frame.surfaces = {benchmarks::ball(100)};
  frame.ground = render::Ground{};
  return frame;
}

void draw(benchmark::State& state) {
  const auto context = render::make_offscreen_context();
  render::Renderer renderer(*context, 1280, 720, static_cast<int>(state.range(0)));
  const render::Frame picture = frame();
  for (auto _ : state) benchmark::DoNotOptimize(renderer.draw(picture));
}

void encode(benchmark::State& state) {
  const auto context = render::make_offscreen_context();
  const render::Image image = render::Renderer(*context, 1280, 720, 4).draw(frame());
  for (auto _ : state) benchmark::DoNotOptimize(render::encode_png(image));
}

// Frames as a recording makes them, without steps: drawn in one thread, encoded and written in another. Time per frame.
void draw_encode_write(benchmark::State& state) {
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "ritz-benchmark-frames";
  std::filesystem::create_directories(folder);
  const auto make = [] {
    struct Drawing {
      std::unique_ptr<render::Context> context = render::make_offscreen_context();
      render::Renderer renderer{*context, 1280, 720, 4};
    };
    return [drawing = std::make_shared<Drawing>()](const render::Frame& picture) {
      return drawing->renderer.draw(picture);
    };
  };
  std::atomic<int> number = 0;
  const auto write = [&](const render::Image& image) {
    app::write_atomically(folder / std::to_string(number++ % 10), app::as_text(render::encode_png(image)), false);
  };
  app::Pipeline<render::Frame, render::Image> stages(make, write);
  const render::Frame picture = frame();
  for (auto _ : state) stages.push(picture);
  stages.finish();
  std::filesystem::remove_all(folder);
}

double number_after(const std::string& text, const std::string& key) {
  const std::size_t at = text.find("\"" + key + "\":");
  return at == std::string::npos ? 0 : std::stod(text.substr(at + key.size() + 3));
}

// The first second of a scene; the counter is the whole over the largest stage.
void record(benchmark::State& state) {
  const std::filesystem::path out = std::filesystem::temp_directory_path() / "ritz-benchmark";
  app::Options options;
  options.scene = std::filesystem::path(RITZ_SOURCE_DIR) / "assets/scenes/bear.toml";
  options.out = out;
  options.overwrite = options.quiet = true;
  options.overrides = {{"time.seconds", "1.0", "benchmark"}};
  options.threads = 2;
  for (auto _ : state) app::record(options);
  std::ifstream file(out / "run.json");
  const std::string run{std::istreambuf_iterator<char>(file), {}};
  const std::string seconds = run.substr(run.find("\"seconds\": {\n"));
  for (const char* stage : {"stepping", "drawing", "writing"}) state.counters[stage] = number_after(seconds, stage);
  const double largest =
      std::max({number_after(seconds, "stepping"), number_after(seconds, "drawing"), number_after(seconds, "writing")});
  state.counters["whole/largest"] = number_after(seconds, "total") / largest;
  std::filesystem::remove_all(out);
}

BENCHMARK(draw)->Arg(1)->Arg(4)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(encode)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(draw_encode_write)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(record)->Iterations(1)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
