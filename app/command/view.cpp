// `ritz view`: the window around a workbench.
#include <imgui.h>

#include <algorithm>
#include <iostream>
#include <memory>

#include "app/base/exit_code.h"
#include "app/base/interrupt.h"
#include "app/base/output_file.h"
#include "app/base/stopwatch.h"
#include "app/command/commands.h"
#include "app/scene/deck.h"
#include "app/view/workbench.h"
#include "render/gui.h"
#include "render/png.h"
#include "render/renderer.h"
#include "render/window.h"

namespace app {
namespace {

// The window with all that draws in it; in the order of their making.
class Screen {
 public:
  Screen(const Options& options, const std::string& title)
      : samples_(options.samples),
        window_(options.width, options.height, title),
        gui_(window_, Panel::text_size(window_.width(), window_.height())) {
    window_.serve(gui_);
  }

  render::Window& window() { return window_; }

  // An event of the window, in the picture or for the panel.
  void pass(render::WindowEvent event, Workbench& bench) const {
    const int width = window_.width(), height = window_.height(), panel = bench.panel_width(width, height);
    if (width - panel < 1 || height < 1) return;
    event.x -= static_cast<float>(panel);
    bool taken = event.x < 0;
    gui_.use([&] {
      const bool key = event.kind == render::WindowEvent::Kind::key;
      taken = key ? ImGui::GetIO().WantTextInput : taken || ImGui::GetIO().WantCaptureMouse;
    });
    bench.handle(event, width - panel, height, taken);
  }

  void draw(Workbench& bench) {
    const int width = window_.width(), height = window_.height(), panel = bench.panel_width(width, height);
    if (width - panel < 1 || height < 1) return;  // minimised
    if (width - panel != width_ || height != height_) {
      renderer_ = nullptr;
      renderer_ = std::make_unique<render::Renderer>(window_, width - panel, height, samples_);
      gui_.set_text(Panel::text_size(width, height));
      width_ = width - panel;
      height_ = height;
    }
    renderer_->paint(bench.frame(width_, height_));
    renderer_->present(panel);
    gui_.draw(width, height, [&] { bench.draw_panel(width, height); });
    if (const auto file = bench.take_screenshot()) save_picture(*file, bench);
    window_.swap();
  }

 private:
  void save_picture(const std::filesystem::path& file, Workbench& bench) const {
    try {
      const render::Image image = gui_.read(window_.width(), window_.height());
      write_atomically(file, as_text(render::encode_png(image)), false);
    } catch (const WriteError& error) {
      bench.say(error.what());
    }
  }

  int samples_;
  render::Window window_;
  render::Gui gui_;
  std::unique_ptr<render::Renderer> renderer_;
  int width_ = 0, height_ = 0;  // of the picture
};

// Sleeps while nothing moves; a few pictures follow every event, so that widgets settle.
void run(Workbench& bench, Screen& screen) {
  constexpr double blink = 0.1;     // s: the longest sleep, so that Ctrl+C is heard
  constexpr double moment = 0.002;  // s: between two looks at the clock while it plays
  constexpr int settling = 3;
  const Interrupt interrupt;
  Stopwatch watch;
  int to_draw = settling;
  while (!bench.quits() && !screen.window().wants_to_close() && !interrupt.requested()) {
    const auto events = screen.window().events(to_draw > 0 ? 0 : bench.playing() ? moment : blink);
    for (const render::WindowEvent& event : events) screen.pass(event, bench);
    if (!events.empty()) to_draw = settling;
    const double passed = watch.seconds();
    watch = {};
    if (bench.advance(passed)) to_draw = std::max(to_draw, 1);
    if (to_draw == 0) continue;
    --to_draw;
    screen.draw(bench);
  }
}

}  // namespace

int view(const Options& given) {
  Options options = given;
  options.deck = pages_of(given.scene);
  options.scene = options.deck.front();
  auto session = std::make_unique<Session>(options);
  try {
    Screen screen(options, "Ritz: " + options.scene.filename().string());
    for (const std::string& remark : session->simulation()->remarks()) {
      if (!options.quiet) std::cerr << "note: " << remark << '\n';
    }
    Workbench bench(options, std::move(session));
    run(bench, screen);
    bench.finish();
  } catch (const render::NoDisplay& none) {
    std::cerr << "ritz: no window can be opened (" << none.what() << "); `ritz record " << options.scene.string()
              << "` draws without a display\n";
    return exit_bad_input;
  }
  return exit_done;
}

}  // namespace app
