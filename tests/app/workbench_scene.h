// A workbench whose keys and mouse are moved by a test.
#pragma once

#include "app/view/workbench.h"
#include "render/view.h"
#include "tests/app/session_scene.h"

namespace app {

class WorkbenchTest : public SessionScene {
 protected:
  static constexpr int frame_width = 160, frame_height = 120;

  Options logged() const {
    Options with_log = options();
    with_log.log = folder_ / "session.toml";
    with_log.out = folder_.path();
    return with_log;
  }
  static void key(Workbench& bench, render::Key key, bool control = false, char letter = 0) {
    render::WindowEvent event{render::WindowEvent::Kind::key, key, letter};
    event.control = control;
    bench.handle(event, frame_width, frame_height, false);
  }
  static void letter(Workbench& bench, char letter, bool control) { key(bench, render::Key::letter, control, letter); }
  static void mouse(Workbench& bench, render::WindowEvent::Kind kind, float x, float y, render::Button button,
                    bool control = false) {
    render::WindowEvent event{kind};
    event.x = x;
    event.y = y;
    event.button = button;
    event.control = control;
    bench.handle(event, frame_width, frame_height, false);
  }
  static void drag(Workbench& bench, float x0, float y0, float x1, float y1, render::Button button) {
    mouse(bench, render::WindowEvent::Kind::press, x0, y0, button);
    mouse(bench, render::WindowEvent::Kind::move, x1, y1, button);
    mouse(bench, render::WindowEvent::Kind::release, x1, y1, button);
  }
  // Where a point of the scene is in the picture.
  static Eigen::Vector3f place(Workbench& bench, const sim::Vec3& point) {
    const render::Frame& frame = bench.frame(frame_width, frame_height);
    const render::View view =
        render::make_view(frame.camera, float(frame_width) / frame_height, render::bounds_of(frame));
    return view.to_window(point.cast<float>(), frame_width, frame_height);
  }
  static double distance(const Workbench& bench, const sim::Vec3& point) {
    const sim::State& state = bench.session().state();
    const auto last = static_cast<Eigen::Index>(state.x.size()) - 3;  // the corner (2, 1, 1)
    return (state.x.segment(last, 3) - point).norm();
  }
};

}  // namespace app
