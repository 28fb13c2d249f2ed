// The pages of assets/lectures as scenes: run, recorded, dragged, turned, and read again; numbers.csv holds what the
// frames show.
#include <map>
#include <sstream>

#include "app/base/exit_code.h"
#include "app/command/commands.h"
#include "app/exhibit/exhibit.h"
#include "app/scene/deck.h"
#include "app/scene/scene_text.h"
#include "tests/app/lecture/deck.h"
#include "tests/app/lecture/pages.h"
#include "tests/app/workbench_scene.h"

namespace app {
namespace {

// A page of numbers alone is a scene: explained, run and recorded as any other.
TEST(LecturePages, NeedNoBody) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder / "scene.toml";
  write_all(file, "[time]\nseconds = 0.1\n[[exhibit]]\nkind = \"five-vectors\"\n");
  const Simulation simulation = build_simulation(page(file));
  EXPECT_EQ(simulation.system->counts().dofs, 0);
  EXPECT_EQ(simulation.system->dimension(), 2);
  EXPECT_TRUE(simulation.remarks().empty()) << simulation.remarks()[0];
  Options options = page(file);
  EXPECT_EQ(explain(options), exit_done);
  options.out = folder / "run";
  EXPECT_EQ(record(options), exit_done);
  EXPECT_NE(read_all(folder / "run/numbers.csv").find("0,galerkin.energy,"), std::string::npos);
  // What it was is read again from the folder of the run, with the files that it names.
  const Simulation again = build_simulation(page(folder / "run/run.toml"));
  EXPECT_EQ(again.identity, simulation.identity);
  for (const auto command : {modes, trade, stress}) {
    options.out = folder / "none";
    EXPECT_NE(error_of([&] { command(options); }).find("there is no body"), std::string::npos);
  }
  write_all(file, "[[exhibit]]\nkind = \"x-ray\"\n");
  const Simulation without = build_simulation(page(file));
  const std::string error = error_of([&] { make_exhibits(without.document, without.system); });
  EXPECT_NE(error.find(":2: exhibit.0.kind"), std::string::npos) << error;
  EXPECT_NE(error.find("there is none"), std::string::npos) << error;
}

// The folder of a run has the whole scene, with every key that is the exhibit's and files by their way from there.
TEST(LecturePages, AreReadAgainAsTheyWereWritten) {
  const TemporaryFolder folder;
  for (const std::filesystem::path& file : pages_of(lecture_deck)) {
    SCOPED_TRACE(file.filename());
    const Simulation simulation = build_simulation(page(file));
    write_all(folder / "page.toml", scene_toml(simulation.document, folder.path()));
    EXPECT_EQ(build_simulation(page(folder / "page.toml")).identity, simulation.identity);
    EXPECT_EQ(sheets(folder / "page.toml", 1)[0].proof.text, sheets(file, 1)[0].proof.text);
  }
}

TEST(LecturePages, KeysOfOtherExhibitsAreRefused) {
  const TemporaryFolder folder;
  const std::string scene = "[[body]]\nmesh = { rectangle = [1, 1], cells = [1, 1] }\n[[exhibit]]\nkind = \"x-ray\"\n";
  const auto error = [&](const std::string& more) {
    write_all(folder / "scene.toml", scene + more);
    return error_of([&] {
      const Simulation simulation = build_simulation(page(folder / "scene.toml"));
      make_exhibits(simulation.document, simulation.system);
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
  // Drags a ring of a diagram and takes a step, with a log. What is seen then is what the replay writes.
  render::Sheet dragged(const std::string& file, std::size_t diagram, const render::Spot& from,
                        const render::Spot& to) {
    Options options = page(lecture_deck / file);
    options.log = folder_ / (file + ".session");
    constexpr int width = 640, height = 360;
    Workbench bench(options, std::make_unique<Session>(options));
    const auto mouse = [&](render::WindowEvent::Kind kind, const render::Spot& at) {
      render::WindowEvent event{kind};
      event.x = static_cast<float>(at[0]);
      event.y = static_cast<float>(at[1]);
      bench.handle(event, width, height, false);
    };
    const render::Diagram shown = bench.frame(width, height).sheet->diagrams[diagram];
    mouse(render::WindowEvent::Kind::press, render::to_page(shown, from, width, height));
    mouse(render::WindowEvent::Kind::move, render::to_page(shown, to, width, height));
    mouse(render::WindowEvent::Kind::release, render::to_page(shown, to, width, height));
    EXPECT_EQ(bench.message(), "");
    bench.act(Action::step);
    const render::Sheet seen = *bench.frame(width, height).sheet;
    bench.finish();
    Options again = page(options.scene);
    again.replay = options.log;
    again.out = folder_ / (file + ".replayed");
    EXPECT_EQ(record(again), exit_done);
    const auto written = numbers(again.out / "numbers.csv");
    for (const render::Number& number : render::numbers_of(seen)) {
      const std::string name = "1," + number.name;
      EXPECT_TRUE(written.contains(name) && written.at(name) == number.text) << name;
    }
    return seen;
  }
  TemporaryFolder folder_;
};

TEST_F(LectureRuns, NumbersCsvHoldsWhatTheFramesShow) {
  Options options = page(lecture_deck / "10-force-algorithm.toml");
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

// A corner of the x-ray is dragged until the triangle is turned over.
TEST_F(LectureRuns, ADragIsAnInputOfTheSession) {
  const render::Sheet seen = dragged("09-x-ray.toml", 1, {0.3, 1.9}, {0.8, -0.9});
  EXPECT_EQ(text_of(seen, "J")[0], '-') << "the triangle is turned over";
  EXPECT_EQ(text_of(seen, "Ds12"), "0.600");
}

TEST_F(LectureRuns, PointsRowsAndEpsAreDragged) {
  const render::Sheet points = dragged("05-weighted-residuals.toml", 1, {0.5, 0}, {0.25, 0.4});
  EXPECT_EQ(points.diagrams[1].dots.size(), 1U);
  EXPECT_NEAR(points.diagrams[1].dots[0].at[0], 0.25, 1e-6);
  EXPECT_NE(text_of(points, "collocation-own.L2"), text_of(points, "collocation-gauss.L2"));
  const render::Sheet rows = dragged("04-five-vectors.toml", 0, {33.0 / 201, 0}, {1.0 / 201, 0});
  EXPECT_NE(text_of(rows, "rows.residual"), "1134.05");
  const render::Sheet eps = dragged("06-self-adjoint.toml", 1, {0, 0}, {-1, 0});
  EXPECT_EQ(text_of(eps, "eps"), "0.1000");
  EXPECT_EQ(text_of(eps, "peclet"), "1.000");
}

TEST_F(LectureRuns, PagesAreTurned) {
  Options options = page(lecture_deck);
  options.deck = pages_of(lecture_deck);
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
