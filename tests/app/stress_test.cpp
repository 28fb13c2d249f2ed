// The matrix of `ritz stress`, its table and its files.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "app/base/exit_code.h"
#include "app/command/commands.h"
#include "app/scene/scene_file.h"
#include "app/stress/flight.h"
#include "app/stress/table.h"
#include "sim/mesh/input_error.h"
#include "sim/time/scheme.h"
#include "tests/app/temporary_folder.h"

namespace app {
namespace {

std::set<std::string> names(const std::vector<StabilityCase>& cases) {
  std::set<std::string> all;
  for (const StabilityCase& c : cases) all.insert(c.name());
  return all;
}

TEST(Stability, TheMatrixHasEveryStartForTheMaterialsAndSchemesThatAreToHold) {
  const auto subjects = built_in_subjects(false);
  const auto rows = extremes();
  const auto cases = make_cases(subjects, rows, {});
  const auto all = names(cases);
  EXPECT_EQ(all.size(), cases.size());  // no name twice
  for (const char* start : {"scrambled", "plane", "plane 1e-6", "line", "point", "mirrored", "inverted", "twisted",
                            "stretched", "squashed", "far"})
    for (const char* material : {"stable-neo-hookean", "fixed-corotated", "corotated"})
      for (const char* scheme : {"backward-euler", "sdirk2", "tr-bdf2"})
        EXPECT_TRUE(all.contains(std::string("start/") + start + " tet4 " + material + " " + scheme)) << start;
  for (const char* element : {"tri3", "tri6", "quad4", "tri3 sheet", "tri6 sheet", "tet10", "hex8"})
    EXPECT_TRUE(all.contains(std::string("start/twisted ") + element + " stable-neo-hookean backward-euler"))
        << element;
  EXPECT_FALSE(all.contains("start/mirrored tri3 sheet stable-neo-hookean backward-euler"));
  for (const sim::Scheme& scheme : sim::schemes()) {
    if (scheme.is_static || !scheme.heeds_barriers()) continue;
    for (const char* obstacle : {"dropped on a plane", "thrown at a sphere, 40 m/s", "squeezed by planes"})
      EXPECT_TRUE(
          all.contains(std::string("obstacle/") + obstacle + " tet4 stable-neo-hookean " + std::string(scheme.name)))
          << obstacle << scheme.name;
  }
  for (const char* body : {"star", "shell", "annulus", "two parts", "tri3 sheet"})
    for (const char* extreme :
         {"untangle/scrambled", "step/h = 2 s", "material/nu = 0.4999", "mesh/aspect 100",
          "script/twisted by 720 degrees in 1/60 s", "obstacle/squeezed by planes", "bending/nu = 0.499"})
      EXPECT_TRUE(all.contains(std::string(extreme) + " " + body + " stable-neo-hookean backward-euler"))
          << extreme << " " << body;
  for (const char* beam : {"tri3 beam", "quad4 beam", "tri6 beam", "tet4 beam", "hex8 beam", "tet10 beam"})
    EXPECT_TRUE(all.contains(std::string("bending/nu = 0.4999 ") + beam + " stable-neo-hookean backward-euler"))
        << beam;
}

TEST(Stability, OnlyAndQuickThinItOut) {
  const auto subjects = built_in_subjects(true);
  const auto rows = extremes();
  const auto quick = make_cases(subjects, rows, {.quick = true, .only = ""});
  EXPECT_LT(quick.size(), 100u);
  const auto only =
      make_cases(subjects, rows, {.quick = true, .only = "start/scrambled tet4*sdirk2", .seed = 5, .seeds = 2});
  ASSERT_EQ(only.size(), 2u);
  EXPECT_EQ(only[0].seed, 5u);
  EXPECT_EQ(only[1].seed, 6u);
  EXPECT_EQ(only[0].name(), "start/scrambled tet4 stable-neo-hookean sdirk2");
  EXPECT_EQ(make_cases(subjects, rows, {.quick = true, .only = "start/twisted tet4*sdirk2", .seeds = 2}).size(), 1u)
      << "nothing in it is random";
  EXPECT_TRUE(make_cases(subjects, rows, {.only = "nothing has this name"}).empty());
}

// Every scene of the matrix can be built. Only an energy that is infinite where elements are inverted refuses a start.
TEST(Stability, EveryCaseIsASceneThatCanBeBuilt) {
  const auto subjects = built_in_subjects(false);
  const auto rows = extremes();
  std::set<std::string> refused;
  for (const StabilityCase& c : make_cases(subjects, rows, {})) {
    try {
      const sim::System system(c.scene());
      EXPECT_GE(c.steps, 100) << c.name();
    } catch (const sim::InputError& error) {
      EXPECT_NE(std::string(error.what()).find(" is infinite: start elsewhere"), std::string::npos) << error.what();
      refused.insert(c.name());
    }
  }
  for (const char* start : {"scrambled", "mirrored", "inverted"})
    EXPECT_TRUE(refused.contains(std::string("start/") + start + " tet4 neo-hookean backward-euler")) << start;
}

TEST(Stability, AScenesOwnBodyIsFreedOfItsLoads) {
  const TemporaryFolder folder;
  write_all(folder / "a.toml",
            "[time]\nfps = 24\nintegrator = \"sdirk2\"\n[[body]]\nname = \"b\"\nmesh = { box = [1, 1, 1], cells = [1, "
            "1, 1] }\n"
            "material.young = 7e4\npin = [{ group = \"left\" }]\n[[obstacle]]\nplane = { point = [0, -1, 0], normal = "
            "[0, 1, 0] }\n");
  const Subject subject = subject_of(load_scene(folder / "a.toml").scene);
  EXPECT_EQ(subject.scheme, "sdirk2");
  EXPECT_EQ(subject.scene.time.fps, 24);
  EXPECT_EQ(subject.scene.bodies[0].materials[0].young, 7e4);
  EXPECT_TRUE(subject.scene.bodies[0].pins.empty() && subject.scene.obstacles.empty());
  EXPECT_EQ(subject.scene.world.gravity.norm(), 0);
}

TEST(Stability, TableAndCsvSayTheSame) {
  Subject subject = built_in_subjects(true).front();
  const auto rows = extremes();
  CaseResult result;
  result.recovery.verdict = sim::Verdict::other_equilibrium;
  result.recovery.inverted = 3;
  result.recovery.steps = 10;
  result.recovery.newton = 25;
  result.recovery.not_converged = 1;
  result.recovery.reason = "solver.max_iterations reached";
  CaseResult refused;
  refused.refused = "has a \"reason\", and more";
  const std::vector<StabilityCase> cases = {{&subject, &rows[0], 3, 10}, {&subject, &rows[1], 3, 10}};
  const std::string row = table_row(cases[0], result);
  EXPECT_NE(row.find("other equilibrium"), std::string::npos);
  EXPECT_NE(row.find(" 2.50 "), std::string::npos) << row;  // iterations a step
  const std::string csv = stability_csv(cases, {result, refused});
  EXPECT_NE(csv.find("\"start/scrambled\",3,\"tet4\",\"stable-neo-hookean\",backward-euler,\"other equilibrium\""),
            std::string::npos)
      << csv;
  EXPECT_NE(csv.find("\"has a \"\"reason\"\", and more\""), std::string::npos) << csv;
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 3);
  EXPECT_NE(table_summary(cases, {result, refused}).find("2 cases: 1 other equilibrium, 1 refused"), std::string::npos);
}

// Momentum is kept by every scheme, to the tolerance; what is at rest stays.
TEST(Stability, LongFlightsAreFlownByEveryScheme) {
  const std::vector<Flight> flights = fly(20, 2, [] { return false; });
  std::set<std::string> schemes;
  for (const Flight& flight : flights) {
    schemes.insert(flight.scheme);
    for (const sim::FlightDrift& drift : {flight.flying, flight.resting}) {
      EXPECT_EQ(drift.failure, "") << flight.scheme;
      EXPECT_EQ(drift.steps, 20) << flight.scheme;
    }
    EXPECT_LT(flight.flying.p, 1e-8) << flight.scheme;
    EXPECT_GT(flight.flying.away, 0.1) << flight.scheme << ": it flies";
    EXPECT_LT(flight.resting.away, 1e-12) << flight.scheme;
  }
  EXPECT_EQ(schemes.size(), flights.size());
  EXPECT_EQ(flights.size(), sim::schemes().size() - 1) << "all but static";
  for (const Flight& flight : fly(20, 1, [] { return true; })) EXPECT_EQ(flight.flying.steps, 0) << "interrupted";
}

TEST(Stability, TheTableOfFlightsHasALineForEach) {
  Flight good{"tr-bdf2", {}, {}}, bad{"bdf2", {}, {}};
  good.flying.p = 1e-13;
  good.flying.L = 2e-3;
  good.flying.energy = -4e-2;
  good.resting.away = 5e-17;
  bad.flying.steps = 7;
  bad.flying.failure = "no";
  const std::string table = flight_table({good, bad}, 20);
  EXPECT_TRUE(table.starts_with("20 steps of a body in free flight")) << table;
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 4);
  EXPECT_NE(table.find("tr-bdf2                 1.0e-13    2.0e-03   -4.0e-02      5.0e-17\n"), std::string::npos)
      << table;
  EXPECT_NE(table.find("  after 7 steps: no\n"), std::string::npos) << table;
}

TEST(Stability, TheCommandLeavesItsCsvAndOverwritesNone) {
  const TemporaryFolder folder;
  Options options;
  options.command = "stress";
  options.out = folder / "s";
  options.quick = options.quiet = true;
  options.threads = 2;
  options.only = "start/far";
  testing::internal::CaptureStdout();
  EXPECT_EQ(stress(options), exit_done);
  const std::string table = testing::internal::GetCapturedStdout();
  EXPECT_NE(table.find("start/far"), std::string::npos);
  EXPECT_NE(table.find("5 cases: 5 recovered"), std::string::npos) << table;
  EXPECT_TRUE(read_all(folder / "s/stress.csv").starts_with("extreme,seed,body,material,integrator,verdict,"));
  EXPECT_NE(error_of([&] { stress(options); }).find("--overwrite"), std::string::npos);
}

}  // namespace
}  // namespace app
