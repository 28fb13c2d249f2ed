// The panel without a window: it has a widget for every key, its widgets do what they say, and it looks as it did.
#include "app/panel/panel.h"

#include <imgui.h>

#include <map>
#include <set>

#include "app/base/exit_code.h"
#include "app/command/commands.h"
#include "app/scene/key_positions.h"
#include "app/session/session.h"
#include "render/compare.h"
#include "render/gui.h"
#include "render/png.h"
#include "tests/app/scene_fixture.h"
#include "tests/app/session_scene.h"

namespace app {
namespace {

constexpr int frame_width = 340, frame_height = 640;

// A panel of a session, with a mouse that is moved by hand.
struct Desk {
  explicit Desk(const Options& options) : session(options) {
    gui.listen(
        [this](int, int) {
          ImGuiIO& io = ImGui::GetIO();
          io.MousePos = mouse;
          io.MouseDown[0] = pressed;
        },
        [] {});
  }

  render::Image draw() {
    const PanelState state{session.document(),  *session.simulation()->system, session.waiting(), samples, 0,
                           session.state().step};
    return gui.picture(frame_width, frame_height, [&] {
      const PanelRequests now = panel.draw(state, frame_width, frame_height);
      requests.actions.insert(requests.actions.end(), now.actions.begin(), now.actions.end());
      requests.changes.insert(requests.changes.end(), now.changes.begin(), now.changes.end());
    });
  }
  void move(float x, float y) {
    mouse = {x, y};
    draw();
  }
  void press(bool down) {
    pressed = down;
    draw();
  }
  Session session;
  std::unique_ptr<render::Context> context = render::make_offscreen_context();
  render::Gui gui{*context, 13};
  Panel panel;
  std::vector<Sample> samples;
  PanelRequests requests;
  ImVec2 mouse{-1, -1};
  bool pressed = false;
};

class PanelTest : public SceneFile {
 protected:
  Options options() const {
    Options options;
    options.scene = file("scene.toml", beam_scene);
    return options;
  }
};

TEST_F(PanelTest, HasAnEntryForEveryKeyOfTheScene) {
  const Document document = load(beam_scene);
  std::map<std::string, int> entries;
  for (const Section& section : sections(document)) {
    EXPECT_FALSE(section.title.empty());
    for (const Group& group : section.groups) {
      for (const Entry& entry : group.entries) ++entries[entry.path];
    }
  }
  std::size_t expected = 0;
  for (const Key& key : keys()) {
    if (key.kind == Kind::table || key.kind == Kind::list || key.dimension == 2) continue;
    for_each_position(document, key, [&](const Indices& indices) {
      EXPECT_EQ(entries[path_at(key.path, indices)], 1) << path_at(key.path, indices);
      ++expected;
    });
  }
  EXPECT_EQ(entries.size(), expected);
  EXPECT_GT(expected, 80U);
}

TEST_F(PanelTest, ButtonsAskForWhatTheySay) {
  Desk desk(options());
  desk.draw();
  for (const float y : {20.0F, 45.0F}) {
    for (float x = 12; x < frame_width; x += 10) {
      desk.move(x, y);
      desk.press(true);
      desk.press(false);
    }
  }
  const std::set<Action> actions(desk.requests.actions.begin(), desk.requests.actions.end());
  EXPECT_EQ(actions, (std::set<Action>{Action::play, Action::back, Action::step, Action::reset, Action::save,
                                       Action::reload, Action::help}));
}

// To store a new one after a wanted change: build/ritz record SCENE --panel --size 640x360 --still, with the scene of
// tests/app/session_scene.h, and copy the frame to tests/data/golden/panel.png.
using PanelPicture = SessionScene;
TEST_F(PanelPicture, LooksAsItDid) {
  Options recorded = options();
  recorded.out = folder_ / "out";
  recorded.width = 640;
  recorded.height = 360;
  recorded.panel = recorded.still = true;
  ASSERT_EQ(record(recorded), exit_done);
  const std::filesystem::path golden = std::filesystem::path(RITZ_SOURCE_DIR) / "tests/data/golden/panel.png";
  const render::Image stored = render::decode_png(read_all(golden));
  const auto differs = [&](const std::string& frame) {
    return render::compare(stored, render::decode_png(read_all(folder_ / frame)), 40).share;
  };
  EXPECT_LT(differs("out/frames/frame_00010.png"), 0.01);
  // Another value is another picture.
  recorded.out = folder_ / "other";
  recorded.overrides = {{"body.0.material.young", "1e3", "test"}};
  ASSERT_EQ(record(recorded), exit_done);
  EXPECT_GT(differs("other/frames/frame_00010.png"), 0.01);
}

TEST_F(PanelTest, FitsIntoAnyFrame) {
  for (const auto& [width, height] : {std::pair{1, 1}, {2, 2}, {64, 48}, {320, 180}, {4096, 2160}}) {
    const int panel = Panel::width(width, height);
    EXPECT_GE(panel, 0);
    EXPECT_LE(panel, width / 2);
    EXPECT_GE(Panel::text_size(width, height), 11);
  }
}

}  // namespace
}  // namespace app
