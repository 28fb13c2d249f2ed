// `ritz trade` on a small smooth scene: orders, errors, resuming, jobs. Never seconds.
#include "app/trade/trade.h"

#include <cmath>

#include "app/base/exit_code.h"
#include "app/base/text.h"
#include "app/command/commands.h"
#include "app/scene/scene_file.h"
#include "app/scene/scene_text.h"
#include "app/trade/case_file.h"
#include "app/trade/table.h"
#include "tests/app/trade_scene.h"

namespace app {
namespace {

constexpr double no_clock = 1e6;  // s: more than any test takes
const Plan small_plan{4, 12};

TEST_F(TradeTest, ErrorsFallAsTheoryAsksAndSchemesAreOrdered) {
  const Interrupt interrupt;
  Options with = options();
  with.trade.keep_mesh = true;
  Trade trade(with, folder_ / "trade", no_clock, interrupt);
  ASSERT_TRUE(trade.measure(small_plan));
  const Diagram diagram = trade.diagram({});
  for (const Slope& slope : slopes(diagram.scores)) {
    if (slope.integrator == "linearly-implicit") continue;  // one Newton step: its order shows later
    EXPECT_NEAR(slope.slope, slope.order, 0.3) << slope.integrator;
  }
  EXPECT_GE(slopes(diagram.scores).size(), 6U);
  auto all = rows(folder_ / "trade");
  const auto error = [&](const std::string& name) { return std::stod(all.at(name).at("time_error")); };
  for (const char* step : {"h=1/30", "h=1/60", "h=1/120"}) {
    EXPECT_LT(error(std::string("tr-bdf2 ") + step), 0.3 * error(std::string("backward-euler ") + step)) << step;
    EXPECT_LT(error(std::string("tr-bdf2 ") + step), error(std::string("bdf2 ") + step)) << step;
  }
  EXPECT_LT(error("central-difference h=auto"), 0.3 * error("backward-euler h=1/120"));
}

TEST_F(TradeTest, MeshErrorsAreApartFromTimeErrorsAndFallWithTheCells) {
  const Interrupt interrupt;
  Trade trade(options(), folder_ / "trade", no_clock, interrupt);
  ASSERT_TRUE(trade.measure(small_plan));
  auto all = rows(folder_ / "trade");
  const auto mesh = [&](const std::string& name) { return std::stod(all.at(name).at("mesh_error")); };
  EXPECT_GT(mesh("tr-bdf2 h=1/60, half the cells, tri3"), 1.2 * mesh("tr-bdf2 h=1/60"));
  EXPECT_GT(mesh("tr-bdf2 h=1/60"), 1.5 * mesh("tr-bdf2 h=1/60, cells split once, tri3"));
  EXPECT_GT(mesh("tr-bdf2 h=1/60"), 2 * mesh("tr-bdf2 h=1/60, tri6"));
  EXPECT_EQ(all.at("tr-bdf2 h=1/60, tri6").at("time_error"), "");
  EXPECT_EQ(all.at("tr-bdf2 h=1/30").at("mesh_error"), "");
  // The total is within the sum of its parts.
  const auto number = [&](const std::string& name, const std::string& column) {
    return std::stod(all.at(name).at(column));
  };
  for (const char* name : {"backward-euler h=1/30", "tr-bdf2 h=1/30", "bdf2 h=1/120"})
    EXPECT_LT(number(name, "total_error"),
              1.05 * (number(name, "time_error") + mesh("tr-bdf2 h=1/60") + number("tr-bdf2 h=1/60", "time_error")))
        << name;
}

TEST_F(TradeTest, ARunThatExistsIsNotMadeAgain) {
  const Interrupt interrupt;
  Options with = options();
  with.trade.keep_mesh = true;
  {
    Trade trade(with, folder_ / "trade", no_clock, interrupt);
    ASSERT_TRUE(trade.measure(small_plan));
  }
  const auto before = rows(folder_ / "trade");
  std::map<std::filesystem::path, std::filesystem::file_time_type> times;
  for (const auto& entry : std::filesystem::directory_iterator(folder_ / "trade/cases"))
    times[entry.path()] = entry.last_write_time();
  ASSERT_GT(times.size(), 20U);
  const std::filesystem::path one = times.rbegin()->first;  // as if it had been interrupted before this one
  std::filesystem::remove(one);
  {
    Trade trade(with, folder_ / "trade", no_clock, interrupt);
    ASSERT_TRUE(trade.measure(small_plan));
  }
  for (const auto& [path, time] : times) {
    ASSERT_TRUE(std::filesystem::exists(path)) << path;
    if (path != one) {
      EXPECT_EQ(std::filesystem::last_write_time(path), time) << path;
    }
  }
  for (const auto& [name, row] : rows(folder_ / "trade")) {
    if (!before.contains(name)) continue;  // what is tried around the front depends on wall times
    for (const char* column : {"time_error", "time_pixels", "linear_per_second", "id", "status"})
      EXPECT_EQ(row.at(column), before.at(name).at(column)) << name << ' ' << column;
  }
}

// The number that a job is listed with is that which runs it; listing runs none.
TEST_F(TradeTest, JobsAreListedAsTheyAreRun) {
  Options list = options();
  list.trade.jobs = true;
  testing::internal::CaptureStdout();
  ASSERT_EQ(trade(list), exit_done);
  std::istringstream text(testing::internal::GetCapturedStdout());
  EXPECT_FALSE(std::filesystem::exists(list.out));
  const Document scene = load_scene(list.scene);
  const std::vector<TradeCase> jobs = independent_cases(scene, small_plan, false);
  std::string line;
  for (std::size_t k = 0; k < jobs.size(); ++k) {
    ASSERT_TRUE(std::getline(text, line)) << k;
    EXPECT_EQ(line, std::to_string(k) + '\t' + jobs[k].label);
  }
  EXPECT_GT(jobs.size(), 35U);
  EXPECT_FALSE(std::getline(text, line)) << line;
  Options one = options();
  one.trade.one_case = 5;
  ASSERT_EQ(trade(one), exit_done);
  std::vector<std::string> run;
  for (const auto& entry : std::filesystem::directory_iterator(one.out / "cases"))
    if (const auto read = decode_case(read_all(entry.path()))) run.push_back(read->which.label);
  EXPECT_EQ(run, std::vector<std::string>{jobs[5].label});
}

TEST_F(TradeTest, JobsAndCollectEqualOneProcess) {
  Options with = options();
  with.out = folder_ / "jobs";
  const Comparison comparison = make_comparison(with);
  const Plan plan{4, comparison.scene.last_frame()};
  const std::size_t jobs = independent_cases(comparison.scene.document, plan, false).size();
  for (std::size_t k = 0; k < jobs; ++k) {
    Options one = with;
    one.trade.one_case = static_cast<int>(k);
    ASSERT_EQ(trade(one), exit_done) << k;
  }
  with.trade.collect = true;
  testing::internal::CaptureStdout();
  ASSERT_EQ(trade(with), exit_done);
  EXPECT_NE(testing::internal::GetCapturedStdout().find("Advice for the knee"), std::string::npos);
  const Interrupt interrupt;
  Trade whole(options(), folder_ / "trade", no_clock, interrupt);
  ASSERT_TRUE(whole.measure(plan));
  const auto one = rows(folder_ / "trade"), collected = rows(folder_ / "jobs");
  std::size_t compared = 0;
  for (const auto& [name, row] : collected) {
    if (!one.contains(name)) continue;
    ++compared;
    for (const char* column :
         {"time_error", "mesh_error", "total_error", "total_pixels", "force_evaluations_per_second",
          "linear_per_second", "factorisations_per_second", "id", "status"})
      EXPECT_EQ(row.at(column), one.at(name).at(column)) << name << ' ' << column;
  }
  EXPECT_GE(compared, 35U);
  EXPECT_LT(collected.size(), jobs + 2);
}

TEST_F(TradeTest, LeavesAdviceThatIsASettingsFile) {
  Options with = options();
  with.trade.target = "5%";
  with.trade.minutes = 0.5;
  testing::internal::CaptureStdout();
  ASSERT_EQ(trade(with), exit_done);
  const std::string said = testing::internal::GetCapturedStdout();
  EXPECT_NE(said.find("Advice for an error of 5%: "), std::string::npos) << said;
  EXPECT_NE(said.find("; found "), std::string::npos);
  // The reference is as fine as the target asks, and no finer.
  const auto all = rows(with.out);
  EXPECT_TRUE(all.contains("tr-bdf2 h=1/120, tolerance 1e-6"));
  EXPECT_FALSE(all.contains("tr-bdf2 h=1/480, tolerance 1e-6"));
  // With these settings the scene is the case that is advised, which keeps to the target.
  const std::string head = "Advice for an error of 5%: ";
  const std::size_t begin = said.find(head) + head.size();
  const auto advised = rows(with.out).at(said.substr(begin, said.find('\n', begin) - begin));
  EXPECT_LE(std::stod(advised.at("error_bound")), 0.05);
  EXPECT_NE(advised.at("settings"), "") << "three steps a frame are more than that takes";
  Options applied = options();
  applied.settings = with.out / "advice.toml";
  EXPECT_EQ(hexadecimal(case_id(make_comparison(options()), build_simulation(applied).identity, applied.threads)),
            advised.at("id"));
  for (const char* file : {"trade.csv", "trade.json", "trade.gp", "plan.toml"})
    EXPECT_TRUE(std::filesystem::exists(with.out / file)) << file;
}

TEST_F(TradeTest, AFolderIsForOneScene) {
  const Interrupt interrupt;
  Options with = options();
  make_comparison(with);
  { Trade trade(with, folder_ / "trade", no_clock, interrupt); }
  with.overrides.push_back({"body.0.material.young", "1e5", "--set body.0.material.young=1e5"});
  EXPECT_NE(error_of([&] { Trade(with, folder_ / "trade", no_clock, interrupt); }).find("another scene"),
            std::string::npos);
  with.overwrite = true;
  EXPECT_EQ(error_of([&] { Trade(with, folder_ / "trade", no_clock, interrupt); }), "");
}

TEST_F(TradeTest, TheIdentityOfACaseFollowsWhatIsSimulated) {
  const Comparison comparison = make_comparison(options());
  const auto id = [&](const std::string& key, const std::string& value) {
    Options changed = options();
    if (!key.empty()) changed.overrides.push_back({key, value, key});
    return case_id(comparison, build_simulation(changed).identity, changed.threads);
  };
  const std::uint64_t same = id("", "");
  EXPECT_EQ(id("title", "other"), same);
  EXPECT_EQ(id("look.wireframe", "true"), same);
  for (const auto& [key, value] : std::map<std::string, std::string>{{"body.0.material.young", "3e4"},
                                                                     {"body.0.mesh.cells", "[5, 2]"},
                                                                     {"time.substeps", "2"},
                                                                     {"solver.tolerance", "1e-5"}})
    EXPECT_NE(id(key, value), same) << key;
  Comparison shorter = make_comparison(options());
  shorter.stretch = stretch_of(shorter, 6);
  EXPECT_NE(case_id(shorter, shorter.scene.identity, shorter.options.threads), same);
}

TEST_F(TradeTest, RunsAreReadBackAsTheyWere) {
  const Interrupt interrupt;
  const Comparison comparison = make_comparison(options());
  const TradeCase which = with({"a \"case\"", Axis::rest, {}}, "tight", "solver.tolerance", "1e-8");
  const CaseRun run =
      run_case(comparison, which, build_simulation(options_of(comparison.options, which)), {no_clock, 0}, interrupt);
  ASSERT_EQ(run.status, CaseStatus::done) << run.reason;
  const std::string bytes = encode(run);
  const auto read = decode_case(bytes);
  ASSERT_TRUE(read);
  EXPECT_EQ(encode(*read), bytes);
  EXPECT_EQ(read->path.x, run.path.x);
  EXPECT_EQ(read->which.settings, which.settings);
  EXPECT_FALSE(decode_case(bytes.substr(0, bytes.size() - 1)));
  EXPECT_FALSE(decode_case(bytes.substr(0, bytes.size() / 2)));
  EXPECT_FALSE(decode_case("nothing"));
}

TEST_F(TradeTest, RefusesWhatCannotBeTraded) {
  Options with = options();
  with.overrides.push_back({"time.integrator", "static", "--set time.integrator=static"});
  EXPECT_NE(error_of([&] { trade(with); }).find("there is no motion to trade"), std::string::npos);
  Options one = options();
  one.trade.one_case = 1000;
  EXPECT_NE(error_of([&] { trade(one); }).find("--case 1000: must be 0 to "), std::string::npos);
}

}  // namespace
}  // namespace app
