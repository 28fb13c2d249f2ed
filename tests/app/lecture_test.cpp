// The pages of assets/lectures: each shows its numbers and proves its point; numbers.csv holds what the frames show.
#include <cmath>
#include <map>
#include <set>
#include <sstream>

#include "app/base/exit_code.h"
#include "app/command/commands.h"
#include "app/exhibit/exhibit.h"
#include "app/picture/frame_history.h"
#include "app/scene/deck.h"
#include "sim/stepper.h"
#include "tests/app/workbench_scene.h"

namespace app {
namespace {

const std::filesystem::path deck_folder = std::filesystem::path(RITZ_SOURCE_DIR) / "assets" / "lectures";

Options page(const std::filesystem::path& file) {
  Options options;
  options.scene = file;
  options.quiet = true;
  options.width = 320;
  options.height = 180;
  return options;
}

// The sheets of the first frames of a page.
std::vector<render::Sheet> sheets(const std::filesystem::path& file, int frames) {
  const Simulation simulation = build_simulation(page(file));
  FrameHistory history(simulation);
  const auto stepper = sim::make_stepper(*simulation.system, 1);
  sim::State state = simulation.system->initial_state();
  LargestShown largest{};
  std::vector<render::Sheet> all;
  for (int k = 0; k < frames; ++k) {
    history.add(state, largest);
    Moment moment{.frame = k, .state = state};
    history.fill(largest, moment);
    all.push_back(*moment.sheet);
    for (int n = 0; n < simulation.system->steps_per_frame(); ++n) EXPECT_EQ(stepper->step(state).failure, "");
  }
  return all;
}

const render::Number& number_named(const render::Sheet& sheet, const std::string& name,
                                   std::vector<render::Number>& all) {
  all = render::numbers_of(sheet);
  const auto found = std::ranges::find(all, name, &render::Number::name);
  if (found == all.end()) throw std::runtime_error("no number " + name);
  return *found;
}
std::string text_of(const render::Sheet& sheet, const std::string& name) {
  std::vector<render::Number> all;
  return number_named(sheet, name, all).text;
}

TEST(LecturePages, AreSmallAndSayWhatTheyProve) {
  const std::vector<std::filesystem::path> pages = pages_of(deck_folder);
  EXPECT_GE(pages.size(), 8U);
  for (const std::filesystem::path& file : pages) {
    SCOPED_TRACE(file.filename());
    const Simulation simulation = build_simulation(page(file));
    EXPECT_LT(simulation.system->counts().dofs, 600);
    EXPECT_EQ(simulation.document.look.style, "lecture");
    ASSERT_FALSE(simulation.document.exhibits.empty());
    for (const render::Sheet& sheet : sheets(file, 3)) {
      EXPECT_LE(sheet.blocks.size(), 3U);
      EXPECT_FALSE(sheet.formula.empty());
      std::set<std::string> names;
      for (const render::Number& number : render::numbers_of(sheet)) {
        EXPECT_TRUE(names.insert(number.name).second) << number.name << " twice";
        EXPECT_EQ(number.name.find_first_of(",\n"), std::string::npos) << number.name;
        EXPECT_EQ(number.text.find_first_of(",\n"), std::string::npos) << number.text;
      }
      for (const render::Diagram& diagram : sheet.diagrams) {
        EXPECT_LT(diagram.x[0], diagram.x[1]);
        EXPECT_LT(diagram.y[0], diagram.y[1]);
        for (const render::Stroke& stroke : diagram.strokes)
          for (const render::Spot& spot : stroke.points) EXPECT_TRUE(std::isfinite(spot[0]) && std::isfinite(spot[1]));
      }
    }
  }
}

// The storyboard's numbers, as they are printed.
TEST(LecturePages, ShowTheNumbersThatProveThem) {
  const render::Sheet xray = sheets(deck_folder / "09-x-ray.toml", 1)[0];
  EXPECT_EQ(text_of(xray, "F11"), "1.2000");
  EXPECT_EQ(text_of(xray, "F12"), "-0.3333");
  EXPECT_EQ(text_of(xray, "J"), "1.4300");
  EXPECT_EQ(text_of(xray, "s1"), "1.2946");
  EXPECT_EQ(text_of(xray, "P11"), "48.439");
  EXPECT_EQ(text_of(xray, "f12"), "-39.80");
  EXPECT_EQ(text_of(xray, "torque"), "0.000");
  const render::Sheet mass = sheets(deck_folder / "08-mass-lumping.toml", 1)[0];
  EXPECT_EQ(text_of(mass, "exact"), "27.6699");
  EXPECT_EQ(text_of(mass, "consistent.error"), "+7.92");
  EXPECT_EQ(text_of(mass, "lumped.error"), "-7.69");
  EXPECT_EQ(text_of(mass, "consistent.limit"), "4.6303");
  EXPECT_EQ(text_of(mass, "lumped.limit"), "7.9439");
  const render::Sheet limit = sheets(deck_folder / "11-explicit-and-implicit.toml", 1)[0];
  EXPECT_EQ(text_of(limit, "limit"), "5.5731");
  EXPECT_EQ(text_of(limit, "growth"), "1.3266");
  const render::Sheet newton = sheets(deck_folder / "12-definiteness.toml", 145).back();
  EXPECT_EQ(text_of(newton, "none.end"), "maximum");
  EXPECT_EQ(text_of(newton, "abs.end"), "minimum");
  EXPECT_EQ(text_of(newton, "abs.steps"), "8");
  EXPECT_EQ(text_of(newton, "clamp.end"), "K = 0: stuck");
  const render::Sheet hills = sheets(deck_folder / "02-shape-functions.toml", 1)[0];
  EXPECT_EQ(text_of(hills, "sum"), "1.000000");
  const render::Sheet order = sheets(deck_folder / "03-interpolation.toml", 65).back();
  EXPECT_EQ(text_of(order, "order"), "1.99");
}

// Other materials, other numbers: the torque of a triangle that is not rotation invariant.
TEST(LecturePages, FollowTheSceneThatTheyAreGiven) {
  Options options = page(deck_folder / "09-x-ray.toml");
  options.overrides = {{"body.0.material.model", "linear", "--set"}};
  const Simulation simulation = build_simulation(options);
  render::Sheet sheet;
  make_exhibits(simulation.document, *simulation.system)[0]->show(simulation.system->initial_state(), sheet);
  EXPECT_EQ(sheet.proof.text, "24399.038");
}

TEST(LecturePages, KeysOfOtherExhibitsAreRefused) {
  const TemporaryFolder folder;
  const std::string scene = "[[body]]\nmesh = { rectangle = [1, 1], cells = [1, 1] }\n[[exhibit]]\nkind = \"x-ray\"\n";
  const auto error = [&](const std::string& more) {
    write_all(folder / "scene.toml", scene + more);
    return error_of([&] {
      const Simulation simulation = build_simulation(page(folder / "scene.toml"));
      make_exhibits(simulation.document, *simulation.system);
    });
  };
  EXPECT_EQ(error(""), "");
  EXPECT_NE(error("pace = 2.0").find(":5: exhibit.0.pace"), std::string::npos) << error("pace = 2.0");
  EXPECT_NE(error("element = 7").find(":5: exhibit.0.element"), std::string::npos) << error("element = 7");
  EXPECT_NE(error("element = 7").find("elements 0 to 1"), std::string::npos);
}

class LectureRuns : public testing::Test {
 protected:
  // "frame,name,value,unit" by frame and name.
  static std::map<std::string, std::string> numbers(const std::filesystem::path& csv) {
    std::istringstream lines(read_all(csv));
    std::map<std::string, std::string> all;
    std::string line;
    std::getline(lines, line);
    EXPECT_EQ(line, "frame,name,value,unit");
    while (std::getline(lines, line)) {
      const std::size_t a = line.find(','), b = line.find(',', a + 1), c = line.find(',', b + 1);
      all[line.substr(0, b)] = line.substr(b + 1, c - b - 1);
    }
    return all;
  }
  TemporaryFolder folder_;
};

TEST_F(LectureRuns, NumbersCsvHoldsWhatTheFramesShow) {
  Options options = page(deck_folder / "10-force-algorithm.toml");
  options.out = folder_ / "run";
  options.overrides = {{"time.seconds", "1.0", "--seconds"}};
  ASSERT_EQ(run(options), exit_done);
  const auto written = numbers(folder_ / "run/numbers.csv");
  std::size_t rows = 0;
  const std::vector<render::Sheet> shown = sheets(options.scene, 31);
  for (std::size_t k = 0; k < shown.size(); ++k)
    for (const render::Number& number : render::numbers_of(shown[k])) {
      ++rows;
      const std::string name = std::to_string(k) + "," + number.name;
      ASSERT_TRUE(written.contains(name)) << name;
      EXPECT_EQ(written.at(name), number.text) << name;
    }
  EXPECT_EQ(written.size(), rows);
}

// A corner of the x-ray is dragged until the triangle is turned over; the replay writes the numbers that were seen.
TEST_F(LectureRuns, ADragIsAnInputOfTheSession) {
  Options options = page(deck_folder / "09-x-ray.toml");
  options.log = folder_ / "session.toml";
  constexpr int width = 640, height = 360;
  Workbench bench(options, std::make_unique<Session>(options));
  const auto mouse = [&](render::WindowEvent::Kind kind, const render::Spot& at) {
    render::WindowEvent event{kind};
    event.x = static_cast<float>(at[0]);
    event.y = static_cast<float>(at[1]);
    bench.handle(event, width, height, false);
  };
  const render::Diagram diagram = bench.frame(width, height).sheet->diagrams[1];
  mouse(render::WindowEvent::Kind::press, render::to_page(diagram, {0.3, 1.9}, width, height));
  mouse(render::WindowEvent::Kind::move, render::to_page(diagram, {0.8, -0.9}, width, height));
  mouse(render::WindowEvent::Kind::release, render::to_page(diagram, {0.8, -0.9}, width, height));
  EXPECT_EQ(bench.message(), "");
  bench.act(Action::step);
  const render::Sheet seen = *bench.frame(width, height).sheet;
  EXPECT_EQ(text_of(seen, "J")[0], '-') << "the triangle is turned over";
  EXPECT_EQ(text_of(seen, "Ds12"), "0.600");
  bench.finish();
  Options again = page(options.scene);
  again.replay = options.log;
  again.out = folder_ / "replayed";
  ASSERT_EQ(record(again), exit_done);
  const auto written = numbers(folder_ / "replayed/numbers.csv");
  for (const render::Number& number : render::numbers_of(seen)) EXPECT_EQ(written.at("1," + number.name), number.text);
}

TEST_F(LectureRuns, PagesAreTurned) {
  Options options = page(deck_folder);
  options.deck = pages_of(deck_folder);
  options.scene = options.deck.front();
  Workbench bench(options, std::make_unique<Session>(options));
  const auto key = [&](render::Key key) {
    bench.handle(render::WindowEvent{render::WindowEvent::Kind::key, key}, 320, 180, false);
  };
  const std::string first = bench.session().document().title;
  key(render::Key::page_up);
  EXPECT_EQ(bench.session().document().title, first) << "there is none before the first";
  key(render::Key::page_down);
  EXPECT_EQ(bench.session().document().title, build_simulation(page(options.deck[1])).document.title);
  for (std::size_t k = 0; k < options.deck.size(); ++k) key(render::Key::page_down);
  EXPECT_EQ(bench.session().document().title, build_simulation(page(options.deck.back())).document.title);
  key(render::Key::page_up);
  EXPECT_EQ(bench.message().substr(0, 10), "Read again");
}

TEST_F(LectureRuns, AFolderIsRecordedPageByPage) {
  const std::string scene =
      "[time]\nseconds = 0.1\nfps = 20\n[[body]]\nmesh = { rectangle = [1, 1], cells = [1, 1] }\n";
  write_all(folder_ / "deck/2.toml", scene);
  write_all(folder_ / "deck/1.toml", scene);
  write_all(folder_ / "deck/README.md", "words");
  Options options = page(folder_ / "deck");
  options.out = folder_ / "out";
  ASSERT_EQ(record(options), exit_done);
  for (const char* name : {"1", "2"})
    EXPECT_TRUE(std::filesystem::exists(folder_ / "out" / name / "frames/frame_00002.png"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out/README"));
  options.video = folder_ / "film.mp4";
  EXPECT_NE(error_of([&] { record(options); }).find("is a folder"), std::string::npos);
  std::filesystem::create_directory(folder_ / "empty");
  EXPECT_NE(error_of([&] { pages_of(folder_ / "empty"); }).find("no scene file"), std::string::npos);
}

}  // namespace
}  // namespace app
