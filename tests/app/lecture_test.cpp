// The pages of assets/lectures: each shows its numbers and proves its point.
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
#include "tests/app/lecture/deck.h"
#include "tests/app/lecture/pages.h"
#include "tests/app/scene_fixture.h"
#include "tests/sim/residual/problems.h"

namespace app {
namespace {

TEST(LecturePages, AreSmallAndSayWhatTheyProve) {
  const std::vector<std::filesystem::path> pages = pages_of(lecture_deck);
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
  const render::Sheet xray = sheets(lecture_deck / "09-x-ray.toml", 1)[0];
  EXPECT_EQ(text_of(xray, "F11"), "1.2000");
  EXPECT_EQ(text_of(xray, "F12"), "-0.3333");
  EXPECT_EQ(text_of(xray, "J"), "1.4300");
  EXPECT_EQ(text_of(xray, "s1"), "1.2946");
  EXPECT_EQ(text_of(xray, "P11"), "48.439");
  EXPECT_EQ(text_of(xray, "f12"), "-39.80");
  EXPECT_EQ(text_of(xray, "torque"), "0.000");
  const render::Sheet mass = sheets(lecture_deck / "08-mass-lumping.toml", 1)[0];
  EXPECT_EQ(text_of(mass, "exact"), "27.6699");
  EXPECT_EQ(text_of(mass, "consistent.error"), "+7.92");
  EXPECT_EQ(text_of(mass, "lumped.error"), "-7.69");
  EXPECT_EQ(text_of(mass, "consistent.limit"), "4.6303");
  EXPECT_EQ(text_of(mass, "lumped.limit"), "7.9439");
  const render::Sheet limit = sheets(lecture_deck / "11-explicit-and-implicit.toml", 1)[0];
  EXPECT_EQ(text_of(limit, "limit"), "5.5731");
  EXPECT_EQ(text_of(limit, "growth"), "1.3266");
  const render::Sheet newton = sheets(lecture_deck / "12-definiteness.toml", 145).back();
  EXPECT_EQ(text_of(newton, "none.end"), "maximum");
  EXPECT_EQ(text_of(newton, "abs.end"), "minimum");
  EXPECT_EQ(text_of(newton, "abs.steps"), "8");
  EXPECT_EQ(text_of(newton, "clamp.end"), "K = 0: stuck");
  const render::Sheet hills = sheets(lecture_deck / "02-shape-functions.toml", 1)[0];
  EXPECT_EQ(text_of(hills, "sum"), "1.000000");
  const render::Sheet order = sheets(lecture_deck / "03-interpolation.toml", 65).back();
  EXPECT_EQ(text_of(order, "order"), "1.99");
}

// reduced.json: 2 modes and 3 derivatives 0.0265 %, 40 modes 2.30 %; and r counts up, its curve with it.
TEST(LecturePages, FewNumbersHaveTheErrorsOfTheReference) {
  const std::filesystem::path file = lecture_deck / "14-reduced-basis.toml";
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
  const std::filesystem::path file = lecture_deck / "04-five-vectors.toml";
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
  const std::filesystem::path file = lecture_deck / "05-weighted-residuals.toml";
  std::map<std::string, render::Sheet> shown;  // by problem and basis
  int compared = 0;
  for (const auto& row : sim::test::rows_of("residuals.csv")) {
    const std::string &problem = row[0], &basis = row[1], &method = row[2];
    if (row[3] != "4" || method == "ritz-anyway") continue;
    if (!shown.contains(problem + basis))
      shown[problem + basis] = sheets(file, 3,
                                      {{"exhibit.0.problem", lecture_deck / "problems" / (problem + ".toml")},
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
  const std::filesystem::path file = lecture_deck / "05-weighted-residuals.toml";
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
  EXPECT_NE(missing.find("Z.toml: there is no such file"), std::string::npos) << missing;
}

TEST(LecturePages, RitzIsRefusedWhereItDoesNotApply) {
  const std::filesystem::path file = lecture_deck / "06-self-adjoint.toml";
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
  Options options = page(lecture_deck / "09-x-ray.toml");
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
      const Simulation simulation = build_simulation(changed(page(lecture_deck / "12-definiteness.toml"), changes));
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
  const Simulation simulation = build_simulation(changed(page(lecture_deck / "12-definiteness.toml"), changes));
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
  const render::Sheet vectors = sheets(lecture_deck / "04-five-vectors.toml", 7, fast).back();
  EXPECT_EQ(text_of(vectors, "projection.c11"), "0.6150");
  const render::Sheet residuals = sheets(lecture_deck / "05-weighted-residuals.toml", 18, fast).back();
  EXPECT_EQ(residuals.proof.text, "0.008730");
  EXPECT_EQ(text_of(residuals, "ritz.c11"), "-4.6649");
}

}  // namespace
}  // namespace app
