// The deck of the lecture in a real window: pages are turned, rings dragged, and a replay has the same numbers.
#include <cmath>

#include "app/picture/frame_history.h"
#include "app/scene/deck.h"
#include "app/scene/simulation.h"
#include "tests/app/lecture/deck.h"
#include "tests/app/window_scene.h"

namespace app {
namespace {

constexpr int window_width = 640, window_height = 360;

class DeckWindowTest : public WindowTest {
 protected:
  static std::filesystem::path page(const std::string& number) {
    for (const std::filesystem::path& file : pages_of(lecture_deck))
      if (file.filename().string().starts_with(number + "-")) return file;
    ADD_FAILURE() << "no page " << number;
    return {};
  }
  // How often Page down is pressed from the first page.
  static int presses(const std::filesystem::path& file) {
    const std::vector<std::filesystem::path> pages = pages_of(lecture_deck);
    return static_cast<int>(std::ranges::find(pages, file) - pages.begin());
  }
  void turn(const std::string& key, int times) const {
    for (int k = 0; k < times; ++k) tool("key " + key);
  }
  // Drags a ring of a page that has just been opened along spots of its diagram.
  void drag(const std::filesystem::path& file, std::size_t number, const std::vector<render::Spot>& along) const {
    Options options;
    options.scene = file;
    const Simulation simulation = build_simulation(options);
    const FrameHistory history(simulation);
    const Ring ring = history.rings(simulation.system->initial_state()).at(number);
    const auto to = [&](const render::Spot& spot) {
      const render::Spot pixel = render::to_page(ring.diagram, spot, window_width, window_height);
      tool("mousemove " + std::to_string(std::lround(pixel[0])) + " " + std::to_string(std::lround(pixel[1])));
    };
    to(ring.grip.at);
    tool("mousedown 1");
    for (const render::Spot& spot : along) to(spot);
    tool("mouseup 1");
    tool("mousemove 450 200");
  }
  // The numbers that the window wrote are those of the replay, to the byte.
  void expect_replayed(const std::filesystem::path& file, const std::string& session) const {
    const std::filesystem::path out = folder_ / ("replay of " + session);
    replay_of(file, folder_ / (session + ".toml"), out, {"--size", "64x36", "--quiet"});
    const std::string written = read_all(folder_ / (session + ".csv"));
    EXPECT_GT(std::ranges::count(written, '\n'), 20);
    EXPECT_EQ(written, read_all(out / "numbers.csv"));
  }
};

TEST_F(DeckWindowTest, PagesAreTurnedRingsDraggedAndReplayed) {
  const std::filesystem::path residuals = page("05"), xray = page("09"), newton = page("12");
  const auto ritz = view_of(lecture_deck, std::to_string(window_width) + "x" + std::to_string(window_height), {},
                            pages_of(lecture_deck)[0].stem().string());
  tool("key Tab");
  turn("Next", presses(residuals) + 1);
  turn("Prior", 1);
  drag(residuals, 0, {{0.4, 0}, {0.3, 0}});
  turn("Right", 2);
  turn("Next", presses(xray) - presses(residuals));
  drag(xray, 2, {{0.6, 1.0}, {0.8, -0.4}, {0.8, -0.9}});
  turn("Right", 2);
  turn("Next", presses(newton) - presses(xray));
  turn("Right", 1);
  drag(newton, 0, {{0.7, 0.4}, {0.9, 0.5}});
  turn("Right", 2);
  tool("key ctrl+q");
  ASSERT_EQ(ritz->wait(10s), 0) << read_all(log("ritz"));
  // Every page that is opened begins a session of its own: the first is that of page 01; one page was turned twice.
  const auto session_of = [&](const std::filesystem::path& file) {
    return "session-" + std::to_string(presses(file) + 2);
  };
  for (const std::filesystem::path& file : {residuals, xray, newton}) {
    SCOPED_TRACE(file);
    expect_replayed(file, session_of(file));
  }
  const auto written = [&](const std::filesystem::path& file, const std::string& ending) {
    return read_all(folder_ / (session_of(file) + ending));
  };
  EXPECT_NE(written(residuals, ".toml").find("key = \"exhibit.0.values\""), std::string::npos);
  EXPECT_NE(written(residuals, ".csv").find("\n0,collocation-own.c11,"), std::string::npos) << "the point is dragged";
  EXPECT_NE(written(xray, ".csv").find("\n0,J,-"), std::string::npos) << "the triangle is turned over";
  EXPECT_NE(written(newton, ".toml").find("key = \"exhibit.0.nodes\""), std::string::npos);
}

}  // namespace
}  // namespace app
