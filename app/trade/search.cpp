#include "app/trade/search.h"

#include <algorithm>
#include <cmath>

#include "app/base/text.h"
#include "app/trade/advice.h"
#include "sim/math/checksum.h"
#include "sim/study/front.h"

namespace app {
namespace {

// Shares of the time that is left when a phase begins.
constexpr double time_share = 0.6, mesh_reference_share = 0.5, mesh_share = 0.4, rest_share = 0.25;
constexpr int most_combinations = 6;
constexpr double growth_of_work = 1.2;  // work goes as unknowns to this power, at the least

}  // namespace

TradeCase mesh_time_case(const Document& scene, const Plan& plan) {
  return time_case(scene, "tr-bdf2", std::max(1, plan.depth / 2));
}

std::vector<TradeCase> independent_cases(const Document& scene, const Plan& plan, bool keep_mesh) {
  const TradeCase own = scene_case(), mesh_time = mesh_time_case(scene, plan);
  std::vector<TradeCase> all = {own};
  const auto add = [&](const std::vector<TradeCase>& list) { all.insert(all.end(), list.begin(), list.end()); };
  add(reference_cases(scene, plan.depth));
  add(time_cases(scene, plan.depth));
  add(explicit_cases());
  if (!keep_mesh)
    for (const MeshChange& mesh : mesh_changes(scene)) all.push_back(both(mesh_time, mesh.change, Axis::mesh));
  add(rest_cases(scene, own));
  add(rest_cases(scene, mesh_time));
  return all;
}

Search::Search(Comparison& comparison, Notebook& notebook, Scorer& scorer, const Goal& goal,
               std::filesystem::path folder)
    : comparison_(comparison), notebook_(notebook), scorer_(scorer), goal_(goal), folder_(std::move(folder)) {}

void Search::note(const std::string& text) {
  notes_.push_back(text);
  notebook_.say("note: " + text);
}

std::vector<const Score*> Search::scores() {
  std::vector<const Score*> all;
  for (const CaseRun& run : notebook_.runs()) all.push_back(&scorer_.score(run));
  return all;
}

void Search::go(const std::optional<Plan>& plan) {
  if (plan) {
    plan_ = *plan;
    comparison_.stretch = stretch_of(comparison_, plan_.frames);
  } else {
    make_plan();
  }
  if (comparison_.shortened())
    note("only the first " + formatted("%.3g s", comparison_.seconds()) + " of " +
         formatted("%.3g s", scene().scene.time.seconds) +
         " are measured: more does not fit into the time (--minutes)");
  notebook_.run(scene_case(), time_share * notebook_.left());
  if (!find_references()) return;
  time_axis();
  if (!comparison_.options.trade.keep_mesh) mesh_axis();
  if (!notebook_.recalls_only() && references_.mesh) combine();
  rest();
  if (!notebook_.recalls_only()) time_front_again();
}

void Search::make_plan() {
  const std::filesystem::path file = folder_ / "plan.toml";
  const std::int64_t frames = comparison_.scene.last_frame();
  const std::uint64_t key = sim::checksum(std::to_string(frames), comparison_.scene.identity);
  if (const auto earlier = read_plan(file, key, notebook_.seconds())) {
    plan_ = *earlier;
  } else {
    constexpr int tried = 4;
    const double look = notebook_.first_look(reference_cases(scene(), tried)[1]);
    plan_ = affordable_plan(time_share * notebook_.left(), look, tried, frames);
    write_plan(file, key, notebook_.seconds(), plan_);
  }
  comparison_.stretch = stretch_of(comparison_, plan_.frames);
}

bool Search::find_references() {
  for (;; plan_.depth /= 2) {
    std::vector<const CaseRun*> runs;
    const bool all_done = std::ranges::all_of(reference_cases(scene(), plan_.depth), [&](const TradeCase& which) {
      runs.push_back(&notebook_.run(which, runs.empty() ? time_share * notebook_.left() : notebook_.left()));
      return runs.back()->status == CaseStatus::done;
    });
    if (all_done) {
      judge_references(runs);
      return true;
    }
    if (plan_.depth == 1 || runs.back()->status == CaseStatus::failed || notebook_.recalls_only()) {
      note("there is no reference, so no error is known: " + runs.back()->which.label + ": " + runs.back()->reason);
      return false;
    }
  }
}

void Search::judge_references(const std::vector<const CaseRun*>& runs) {
  references_.time = runs[0];
  references_.check =
      sim::check_reference({runs[0]->path, runs[1]->path, runs[2]->path, runs[3]->path}, comparison_.points);
  const sim::ReferenceCheck& check = references_.check;
  if (check.diverges)
    note("the motion is chaotic: halving the step of the reference moves it by 0.5 % of the size at t = " +
         formatted("%.3g s", check.horizon) +
         "; positions mean something up to there, and errors are those up to there. "
         "Beyond, compare the centre of mass and the energy (columns centre_error, mean_energy)");
  if (!check.agrees)
    note("the reference cannot be trusted: tr-bdf2 and sdirk2 are " + percent(check.apart) +
         " apart, and halving its step brings sdirk2 no nearer (halving that of tr-bdf2 moves it by " +
         percent(check.moved) + ")");
  scorer_.set(references_);
}

void Search::time_axis() {
  for (const TradeCase& which : time_cases(scene(), plan_.depth)) notebook_.run(which, time_share * notebook_.left());
  for (const TradeCase& which : explicit_cases()) notebook_.run(which, rest_share * notebook_.left());
  raise_floor();
}

// Errors below ten uncertainties of the reference are not told apart from it.
void Search::raise_floor() {
  const double floor = 10 * references_.check.uncertainty;
  int below = 0;
  for (const Score* score : scores())
    below += score->time && !score->resolved && score->run->which.axis != Axis::reference ? 1 : 0;
  if (below > 0)
    note("runs closer to the reference than ten times its uncertainty (" + percent(references_.check.uncertainty) +
         "): " + std::to_string(below) + "; their errors are given as below " + percent(floor));
}

// Leaves in `changes` those that are coarser.
const CaseRun* Search::find_finest(std::vector<MeshChange>& changes, double seconds) {
  const TradeCase time = mesh_time_case(scene(), plan_);
  const CaseRun& own = notebook_.run(time, seconds);
  while (!changes.empty()) {
    const MeshChange change = std::move(changes.back());
    changes.pop_back();
    if (!change.finest) continue;
    const TradeCase which = both(time, change.change, Axis::mesh);
    const double least = own.work.median() * comparison_.seconds() * std::pow(change.growth, growth_of_work);
    if (least > seconds && !notebook_.recalls_only()) {
      notebook_.skip(which, "would take " + formatted("%.3g s", least) + " or more");
      continue;
    }
    const CaseRun& run = notebook_.run(which, seconds);
    if (run.status == CaseStatus::done) return &run;
  }
  return nullptr;
}

void Search::mesh_axis() {
  std::vector<MeshChange> changes = mesh_changes(scene());
  const CaseRun* const finest = find_finest(changes, mesh_reference_share * notebook_.left());
  if (!finest) {
    note("no finer mesh could be afforded or made: the mesh error is not known, targets bound the time error only");
    return;
  }
  const TradeCase time = mesh_time_case(scene(), plan_);
  for (const MeshChange& change : changes)
    notebook_.run(both(time, change.change, Axis::mesh), mesh_share * notebook_.left());
  judge_meshes(*finest);
}

// The total error is uncertain by the time error of the runs on the finest mesh and by what that mesh lacks itself: a
// third of the error of the next best, as halving the cells takes 3/4 of an error of second order away.
void Search::judge_meshes(const CaseRun& finest) {
  references_.mesh_time = mesh_time_case(scene(), plan_);
  const CaseRun& own = notebook_.run(references_.mesh_time, 0);
  const Apart time = scorer_.apart(own, *references_.time);
  references_.mesh = &finest;
  scorer_.set(references_);
  Apart next{1e300, 1e300, 1e300};
  for (const Score* score : scores())
    if (score->mesh && score->mesh->rms < next.rms) next = *score->mesh;
  references_.total_uncertainty = {time.rms + next.rms / 3, time.max + next.max / 3, time.pixels + next.pixels / 3};
  scorer_.set(references_);
}

// Schemes and steps of the time axis on the other meshes: those of which it can be expected that they are worth it.
void Search::combine() {
  struct Guess {
    TradeCase which;
    sim::WorkError expected;
  };
  std::vector<const Score*> times, meshes;
  const Score& own = scorer_.score(notebook_.run(references_.mesh_time, 0));
  for (const Score* score : scores()) {
    if (score->time && score->run->which.axis == Axis::time) times.push_back(score);
    if (score->mesh && score->run->which.axis == Axis::mesh) meshes.push_back(score);
  }
  std::vector<Guess> guesses;
  for (const Score* mesh : meshes)
    for (const Score* time : times) {
      TradeCase which = mesh->run->which;
      for (const auto& [key, value] : time->run->which.settings) which = with(which, "", key, value);
      which.axis = Axis::rest;
      const std::string& label = mesh->run->which.label;
      which.label = time->run->which.label + label.substr(std::min(label.size(), own.run->which.label.size()));
      guesses.push_back({which,
                         {time->seconds() * mesh->seconds() / own.seconds(),
                          error_of(*time->time, goal_) + error_of(*mesh->mesh, goal_)}});
    }
  std::vector<sim::WorkError> expected;
  for (const Guess& guess : guesses) expected.push_back(guess.expected);
  std::vector<int> members = sim::front(expected);
  const auto distance = [&](int k) {
    if (goal_.kind == Goal::Kind::knee) return 0.0;
    return std::abs(
        std::log((goal_.kind == Goal::Kind::time ? expected[k].work : 2 * expected[k].error) / goal_.value));
  };
  std::ranges::stable_sort(members, {}, distance);
  for (std::size_t k = 0; k < members.size() && k < most_combinations; ++k)
    notebook_.run(guesses[members[k]].which, rest_share * notebook_.left());
}

// One setting at a time around the scene's own and around the best.
void Search::rest() {
  constexpr int rounds = 2;
  std::vector<TradeCase> around = {scene_case()};
  if (notebook_.recalls_only()) around.push_back(mesh_time_case(scene(), plan_));
  std::vector<std::string> seen;
  for (int round = 0; round < rounds; ++round) {
    if (!notebook_.recalls_only())
      if (const Score* best = choose(scores(), goal_)) around.push_back(best->run->which);
    for (const TradeCase& start : around) {
      if (std::ranges::find(seen, settings_text(start)) != seen.end()) continue;
      seen.push_back(settings_text(start));
      for (const TradeCase& which : rest_cases(scene(), start)) notebook_.run(which, rest_share * notebook_.left());
    }
    around.clear();
  }
}

void Search::time_front_again() {
  constexpr std::size_t enough = 3;
  for (const Score* score : front_of(scores()))
    while (score->run->work.seconds.size() < enough &&
           score->run->work.median() * comparison_.seconds() < rest_share * notebook_.left())
      notebook_.time_again(*score->run);
}

}  // namespace app
