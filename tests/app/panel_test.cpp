// The panel without a window: it has a widget for every key, its widgets do what they say, and it looks as it did.
#include "app/panel/panel.h"

#include <imgui.h>

#include <map>
#include <set>

#include "app/key_positions.h"
#include "app/session/session.h"
#include "render/compare.h"
#include "render/gui.h"
#include "render/png.h"
#include "tests/app/scene_fixture.h"

namespace app {
namespace {

constexpr int kWidth = 340, kHeight = 640;

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
    return gui.picture(kWidth, kHeight, [&] {
      const PanelRequests now = panel.draw(state, kWidth, kHeight);
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
  void drag(float x0, float y0, float x1) {
    move(x0, y0);
    press(true);
    move(x1, y0);
    move(x1 + 1, y0);
    press(false);
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
    options.scene = file("scene.toml", kBeam);
    return options;
  }
};

TEST_F(PanelTest, HasAnEntryForEveryKeyOfTheScene) {
  const Document document = load(kBeam);
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
    for (float x = 12; x < kWidth; x += 10) {
      desk.move(x, y);
      desk.press(true);
      desk.press(false);
    }
  }
  const std::set<Action> actions(desk.requests.actions.begin(), desk.requests.actions.end());
  EXPECT_EQ(actions, (std::set<Action>{Action::play, Action::back, Action::step, Action::reset, Action::save,
                                       Action::reload, Action::help}));
}

// Dragging whatever can be dragged gives values that the scene accepts, or refuses with a reason.
TEST_F(PanelTest, WhatIsDraggedIsAKeyWithAValue) {
  Desk desk(options());
  desk.draw();
  std::set<std::string> changed;
  for (float y = 5; y < kHeight; y += 9) {
    desk.drag(0.8F * kWidth, y, 0.8F * kWidth + 25);
    for (const SetKey& change : desk.requests.changes) {
      changed.insert(change.key);
      const std::string refusal = error_of([&] { desk.session.apply(change); });
      if (!refusal.empty()) {
        EXPECT_NE(refusal.find(change.key), std::string::npos) << refusal;
      }
    }
    desk.requests = {};
  }
  EXPECT_TRUE(changed.contains("time.seconds")) << changed.size();
  EXPECT_TRUE(changed.contains("time.fps"));
  EXPECT_GE(changed.size(), 3U);
  EXPECT_NE(desk.session.document().scene.time.seconds, 1.5);
}

TEST_F(PanelTest, ADragChangesTheSceneOnceWhenItIsLetGo) {
  Desk desk(options());
  desk.draw();
  // Find the row of time.seconds.
  float row = 0;
  for (float y = 5; y < kHeight && row == 0; y += 9) {
    desk.drag(0.8F * kWidth, y, 0.8F * kWidth + 25);
    if (!desk.requests.changes.empty() && desk.requests.changes[0].key == "time.seconds") row = y;
    desk.requests = {};
  }
  ASSERT_GT(row, 0);
  desk.move(0.8F * kWidth, row);
  desk.press(true);
  desk.move(0.8F * kWidth + 30, row);
  desk.move(0.8F * kWidth + 60, row);
  EXPECT_TRUE(desk.requests.changes.empty()) << "while it is held nothing changes";
  desk.press(false);
  desk.draw();
  ASSERT_EQ(desk.requests.changes.size(), 1U);
  EXPECT_GT(std::stod(desk.requests.changes[0].value), 1.5);
}

TEST_F(PanelTest, LooksAsItDid) {
  Desk desk(options());
  for (int k = 0; k < 120; ++k) {
    const double t = k / 60.0;
    desk.samples.push_back({t, 1 - std::cos(6 * t), std::sin(3 * t) * std::sin(3 * t), -t, 3, 12 + k % 5,
                            1 - 0.2 * std::abs(std::sin(4 * t)), 0.002, 0.004, 0.001});
  }
  const render::Image drawn = desk.draw();
  const std::filesystem::path golden = std::filesystem::path(RITZ_SOURCE_DIR) / "tests/data/golden/panel.png";
  const auto png = render::encode_png(drawn);
  write_all(std::filesystem::temp_directory_path() / "ritz-panel.png", std::string(png.begin(), png.end()));
  const render::Difference difference = render::compare(render::decode_png(read_all(golden)), drawn, 40);
  EXPECT_LT(difference.share, 0.01) << "drawn: " << std::filesystem::temp_directory_path() / "ritz-panel.png";
  // A panel with other values is another picture.
  desk.session.apply(SetKey{"body.0.mesh.cells", "[6, 2, 2]"});
  EXPECT_GT(render::compare(drawn, desk.draw(), 40).share, 0.01);
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
