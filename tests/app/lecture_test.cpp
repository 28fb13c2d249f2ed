// The pages of assets/lectures: each shows its numbers and proves its point; numbers.csv holds what the frames show.
#include <cmath>
#include <map>
#include <set>
#include <sstream>

#include "app/base/exit_code.h"
#include "app/command/commands.h"
#include "app/exhibit/exhibit.h"
#include "app/exhibit/print.h"
#include "app/picture/frame_history.h"
#include "app/scene/deck.h"
#include "app/scene/scene_text.h"
#include "sim/stepper.h"
#include "sim/study/pure_newton.h"
#include "tests/app/workbench_scene.h"
#include "tests/sim/residual/problems.h"

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

// Keys and values, as --set has them.
using Changes = std::vector<std::pair<std::string, std::string>>;
Options changed(Options options, const Changes& changes) {
  for (const auto& [key, value] : changes) options.overrides.push_back({key, value, "--set"});
  return options;
}

// The sheets of the first frames of a page.
std::vector<render::Sheet> sheets(const std::filesystem::path& file, int frames, const Changes& changes = {}) {
  const Simulation simulation = build_simulation(changed(page(file), changes));
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

// reduced.json: 2 modes and 3 derivatives 0.0265 %, 40 modes 2.30 %; and r counts up, its curve with it.
TEST(LecturePages, FewNumbersHaveTheErrorsOfTheReference) {
  const std::filesystem::path file = deck_folder / "14-reduced-basis.toml";
  EXPECT_EQ(text_of(sheets(file, 1, {{"exhibit.0.values", "[5]"}})[0], "derivatives.5"), "0.0264");
  EXPECT_EQ(text_of(sheets(file, 1, {{"exhibit.0.values", "[40]"}})[0], "modes.40"), "2.2982");
  const std::vector<render::Sheet> counting = sheets(file, 70);
  for (const auto& [frame, r] : {std::pair{0, "1"}, {29, "1"}, {30, "2"}, {60, "5"}})
    EXPECT_EQ(text_of(counting[static_cast<std::size_t>(frame)], "r"), r) << frame;
  const render::Diagram& curves = counting.back().diagrams[1];
  ASSERT_EQ(curves.strokes.size(), 2U);
  for (const render::Stroke& curve : curves.strokes) EXPECT_EQ(curve.points.size(), 3U);
  EXPECT_EQ(text_of(counting.back(), "derivatives.5"), "0.0264");
  EXPECT_NE(error_of([&] {
              sheets(file, 1, {{"exhibit.0.values", "[41]"}});
            }).find("whole numbers from 1 to 40"),
            std::string::npos);
}

// With another basis, other rows, another matrix: low_dimensional.json as it is printed.
TEST(LecturePages, FiveVectorsAreThoseOfTheTable) {
  const std::filesystem::path file = deck_folder / "04-five-vectors.toml";
  const render::Sheet sheet = sheets(file, 1)[0];
  EXPECT_EQ(text_of(sheet, "rows.residual"), "1134.05");
  EXPECT_EQ(text_of(sheet, "least-squares.residual"), "69.52");
  EXPECT_EQ(text_of(sheet, "galerkin.energy"), "1.3757");
  EXPECT_EQ(text_of(sheet, "energy.energy"), "1.3757");
  EXPECT_EQ(text_of(sheet, "galerkin.distance"), "0.04103");
  EXPECT_EQ(text_of(sheet, "projection.distance"), "0.03256");
  EXPECT_LT(std::stod(sheet.proof.text), 1e-9);
  // Each is least in its own norm, Galerkin and the energy in the same.
  const auto& table = std::get<render::Table>(sheet.blocks[0].items[0]);
  EXPECT_EQ(table.boxed, (std::vector<std::array<int, 2>>{{1, 0}, {2, 1}, {3, 1}, {4, 2}}));
  const auto with = [&](const std::string& key, const std::string& value) {
    return sheets(file, 1, {{"exhibit.0." + key, value}})[0];
  };
  EXPECT_NEAR(std::stod(text_of(with("rows", "first"), "rows.residual")), 25451.72, 0.1) << "digits are lost there";
  EXPECT_EQ(text_of(with("rows", "pivoted"), "rows.residual"), "90.06");
  EXPECT_EQ(text_of(with("values", "[33, 67, 100, 134, 167]"), "rows.residual"), "1134.05");
  EXPECT_EQ(text_of(with("basis", "sines"), "galerkin.energy"), "0.9276");
  const render::Sheet wind = with("wind", "30.0");
  EXPECT_EQ(text_of(wind, "galerkin.distance"), "0.05857");
  EXPECT_EQ(text_of(wind, "energy.distance"), "0.75435");
  EXPECT_EQ(text_of(with("method", "energy"), "energy.c11"), "0.6906");
  EXPECT_NE(error_of([&] { with("values", "[1, 2, 3, 4, 4]"); }).find("exhibit.0.values"), std::string::npos);
  EXPECT_NE(error_of([&] { with("values", "[1, 2, 3]"); }).find("as many rows as vectors, 5"), std::string::npos);
  EXPECT_NE(error_of([&] { with("method", "luck"); }).find("must be rows, least-squares"), std::string::npos);
}

// The last row of a method, as residuals.csv has it for n = 4, is what the page prints.
TEST(LecturePages, WeightedResidualsAreThoseOfTheTable) {
  const std::filesystem::path file = deck_folder / "05-weighted-residuals.toml";
  std::map<std::string, render::Sheet> shown;  // by problem and basis
  int compared = 0;
  for (const auto& row : sim::test::rows_of("residuals.csv")) {
    const std::string &problem = row[0], &basis = row[1], &method = row[2];
    if (row[3] != "4" || method == "ritz-anyway") continue;
    if (!shown.contains(problem + basis))
      shown[problem + basis] = sheets(file, 3,
                                      {{"exhibit.0.problem", deck_folder / "problems" / (problem + ".toml")},
                                       {"exhibit.0.basis", basis},
                                       {"exhibit.0.pace", "0.0333333"}})
                                   .back();
    const render::Sheet& sheet = shown.at(problem + basis);
    EXPECT_EQ(text_of(sheet, method + ".L2"), printed("%.3e", std::stod(row[4]))) << problem << basis << method;
    EXPECT_EQ(text_of(sheet, method + ".H1"), printed("%.3e", std::stod(row[5]))) << problem << basis << method;
    EXPECT_EQ(text_of(sheet, method + ".residual"), row[7].empty() ? "none" : printed("%.3e", std::stod(row[7])));
    ++compared;
  }
  EXPECT_GT(compared, 30);
  const render::Sheet& a = shown.at("Apolynomials");
  EXPECT_EQ(a.proof.text, "0.008730");
  EXPECT_EQ(a.proof_label, "least H₁ error, Galerkin:");
  EXPECT_EQ(text_of(a, "least-squares.residual"), "1.707e-01");
  const auto& table = std::get<render::Table>(a.blocks[0].items[0]);
  EXPECT_NE(std::ranges::find(table.boxed, std::array{2, 2}), table.boxed.end()) << "squares: least residual";
  EXPECT_NE(std::ranges::find(table.boxed, std::array{3, 1}), table.boxed.end()) << "Galerkin: least H1";
  EXPECT_EQ(text_of(shown.at("C0.1polynomials"), "ritz.H1"), "refused");
  EXPECT_EQ(text_of(shown.at("Ahats"), "collocation-gauss.L2"), "refused");
}

TEST(LecturePages, PointsOfCollocationAreThoseThatAreGiven) {
  const std::filesystem::path file = deck_folder / "05-weighted-residuals.toml";
  const auto with = [&](const Changes& changes) { return sheets(file, 1, changes)[0]; };
  // Those of Gauss, (1 -+ 1/sqrt 3)/2.
  const render::Sheet sheet = with({{"exhibit.0.values", "[0.2113248654051871, 0.7886751345948129]"}});
  EXPECT_EQ(text_of(sheet, "collocation-own.L2"), text_of(sheet, "collocation-gauss.L2"));
  EXPECT_EQ(sheet.diagrams[1].dots.size(), 2U);
  const render::Sheet twice = with({{"exhibit.0.values", "[0.3, 0.3]"}});
  EXPECT_EQ(text_of(twice, "collocation-own.L2"), "refused");
  EXPECT_NE(error_of([&] { with({{"exhibit.0.values", "[0.5, 1.0]"}}); }).find("between 0 and 1"), std::string::npos);
  const std::string missing = error_of([&] { with({{"exhibit.0.problem", "problems/Z.toml"}}); });
  EXPECT_NE(missing.find("exhibit.0.problem"), std::string::npos) << missing;
  EXPECT_NE(missing.find("Z.toml: cannot be read"), std::string::npos) << missing;
}

TEST(LecturePages, RitzIsRefusedWhereItDoesNotApply) {
  const std::filesystem::path file = deck_folder / "06-self-adjoint.toml";
  const auto with = [&](const Changes& changes) { return sheets(file, 1, changes)[0]; };
  const render::Sheet usual = with({{"exhibit.0.eps", "0.1"}});
  EXPECT_EQ(usual.proof.text, "-0.0333333");
  EXPECT_EQ(text_of(usual, "ritz.L2.4"), "refused");
  EXPECT_EQ(text_of(usual, "galerkin.L2.4"), "0.01201838");
  EXPECT_EQ(text_of(usual, "peclet"), "1.000");
  const char* const straight[] = {"0.2000", "0.4000", "0.6000", "0.8000"};
  for (int i = 0; i < 4; ++i) EXPECT_EQ(text_of(usual, "hats.u" + std::to_string(i + 1) + "1"), straight[i]);
  const render::Sheet anyway = with({{"exhibit.0.eps", "0.1"}, {"exhibit.0.anyway", "true"}});
  for (const char* n : {"1", "2", "4", "8"}) EXPECT_EQ(text_of(anyway, std::string("ritz.L2.") + n), "0.53225795");
  const render::Sheet thin = with({{"exhibit.0.eps", "0.01"}});
  EXPECT_EQ(text_of(thin, "hats.u11"), "-0.3962");
  EXPECT_EQ(text_of(thin, "hats.u41"), "1.1304");
  EXPECT_EQ(text_of(thin, "asymmetry"), "-0.0333333") << "whatever eps is";
}

// Other materials, other numbers: the torque of a triangle that is not rotation invariant.
TEST(LecturePages, FollowTheSceneThatTheyAreGiven) {
  Options options = page(deck_folder / "09-x-ray.toml");
  options.overrides = {{"body.0.material.model", "linear", "--set"}};
  const Simulation simulation = build_simulation(options);
  render::Sheet sheet;
  make_exhibits(simulation.document, simulation.system).all[0]->show(simulation.system->initial_state(), sheet);
  EXPECT_EQ(sheet.proof.text, "24399.038");
}

// The paths of page 12 are those of its scene with solver.newton = "pure": a step is an iteration, which a page of
// three paths at once cannot be.
TEST(LecturePages, PathsOfNewtonAreThoseOfTheKey) {
  const std::map<std::string, std::array<int, 3>> lengths = {{"[0.6, 0.25]", {5, 0, 8}}, {"[0.9, 0.35]", {7, 6, 7}}};
  for (const auto& [start, expected] : lengths) {
    Changes changes = {{"body.0.start", "{ shape = \"nodes\", nodes = [[0, 0], [1, 0], " + start + "] }"},
                       {"solver.newton", "pure"},
                       {"solver.max_iterations", "1"},
                       {"solver.on_failure", "accept"},
                       {"solver.tolerance", "1e-9"}};
    int k = 0;
    for (const sim::Definiteness fix : {sim::Definiteness::none, sim::Definiteness::clamp, sim::Definiteness::abs}) {
      changes.push_back({"solver.definiteness", std::string(sim::name_of(fix))});
      const Simulation simulation = build_simulation(changed(page(deck_folder / "12-definiteness.toml"), changes));
      sim::State state = simulation.system->initial_state();
      const sim::NewtonPath path = sim::pure_newton(*simulation.system, state.x, fix);
      EXPECT_EQ(path.iterations(), expected[static_cast<std::size_t>(k++)]) << start << sim::name_of(fix);
      const auto stepper = sim::make_stepper(*simulation.system, 1);
      for (int n = 1; n <= path.iterations(); ++n) {
        EXPECT_EQ(stepper->step(state).failure, "");
        EXPECT_LT((state.x - path.points[static_cast<std::size_t>(n)]).norm(), 1e-9) << start << n;
      }
      EXPECT_EQ(stepper->step(state).converged, !path.singular);
    }
  }
}

// Whole steps wander about before they find where the slope is zero; nothing ends them for want of progress.
TEST(LecturePages, PureNewtonWandersToItsEnd) {
  const Changes changes = {{"body.0.start", "{ shape = \"nodes\", nodes = [[0, 0], [1, 0], [1.54, -0.2]] }"},
                           {"solver.newton", "pure"},
                           {"solver.definiteness", "none"},
                           {"solver.tolerance", "1e-9"}};
  const Simulation simulation = build_simulation(changed(page(deck_folder / "12-definiteness.toml"), changes));
  sim::State state = simulation.system->initial_state();
  const sim::NewtonPath path = sim::pure_newton(*simulation.system, state.x, sim::Definiteness::none);
  const sim::StepReport report = sim::make_stepper(*simulation.system, 1)->step(state);
  EXPECT_GT(path.iterations(), 20);
  EXPECT_NEAR(report.newton, path.iterations(), 1);
  EXPECT_TRUE(report.converged);
  EXPECT_LT((state.x - path.points.back()).norm(), 1e-9);
}

TEST(LecturePages, StayAtTheLastMethod) {
  const Changes fast = {{"exhibit.0.pace", "0.0333333"}};
  const render::Sheet vectors = sheets(deck_folder / "04-five-vectors.toml", 7, fast).back();
  EXPECT_EQ(text_of(vectors, "projection.c11"), "0.6150");
  const render::Sheet residuals = sheets(deck_folder / "05-weighted-residuals.toml", 18, fast).back();
  EXPECT_EQ(residuals.proof.text, "0.008730");
  EXPECT_EQ(text_of(residuals, "ritz.c11"), "-4.6649");
}

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
  for (const std::filesystem::path& file : pages_of(deck_folder)) {
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
    Options options = page(deck_folder / file);
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
