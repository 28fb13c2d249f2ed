#include "app/trade/search.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "app/base/text.h"
#include "app/trade/advice.h"
#include "app/trade/mesh_search.h"
#include "app/trade/reference_search.h"
#include "app/trade/step_search.h"
#include "sim/math/checksum.h"

namespace app {
namespace {

// Shares of the time that is left when a phase begins.
constexpr double time_share = 0.6, rest_share = 0.25;

// The reference's steps a frame beside the most of the ladder: the finest rung of second order is then some twenty
// times less certain than the reference.
constexpr int finer = 8;

TradeCase ladder_mesh_time(const Document& scene, const Plan& plan) {
  return time_case(scene, "tr-bdf2", std::max(1, plan.depth / 2));
}

// The least time error of what is within the budget.
double least_error_within(Measurement& m) {
  double least = 1;  // body size: nothing is known
  for (const Score* score : m.scores())
    if (score->time && meets(*score, m.goal)) least = std::min(least, score->time->rms);
  return least;
}

}  // namespace

std::vector<TradeCase> independent_cases(const Document& scene, const Plan& plan, bool keep_mesh) {
  const TradeCase own = scene_case(), mesh_time = ladder_mesh_time(scene, plan);
  std::vector<TradeCase> all = {own};
  const auto add = [&](const std::vector<TradeCase>& list) { all.insert(all.end(), list.begin(), list.end()); };
  add(reference_cases(scene, finer * plan.depth));
  add(time_cases(scene, plan.depth));
  add(explicit_cases(scene));
  if (!keep_mesh)
    for (const MeshChange& mesh : mesh_changes(scene)) all.push_back(both(mesh_time, mesh.change, Axis::mesh));
  add(rest_cases(scene, own));
  add(rest_cases(scene, mesh_time));
  return all;
}

void Search::go(const std::optional<Plan>& plan) {
  if (plan) {
    plan_ = *plan;
    m_.comparison.stretch = stretch_of(m_.comparison, plan_.frames);
  } else {
    make_plan();
  }
  if (m_.comparison.shortened())
    m_.note("only the first " + formatted("%.3g s", m_.comparison.seconds()) + " of " +
            formatted("%.3g s", m_.scene().scene.time.seconds) +
            " are measured: more does not fit into the time (--minutes)");
  if (const std::string names = schemes_that_do_not_serve(m_.scene()); !names.empty())
    m_.note("not tried, as they cannot keep bodies off each other and off obstacles: " + names);
  m_.notebook.run(scene_case(), time_share * m_.notebook.left());
  for (const TradeCase& which : m_.named) m_.notebook.run(which, time_share * m_.notebook.left());
  if (plan || m_.goal.kind == Goal::Kind::knee ? !ladder() : !aimed()) return;
  tell_what_is_below();
  MeshSearch meshes(m_, mesh_time_);
  if (!m_.keeps_mesh() && meshes.measure() && !m_.notebook.recalls_only()) meshes.combine();
  rest();
  if (!m_.notebook.recalls_only()) calibrate();
}

void Search::make_plan() {
  const Spending spending(m_, "a first look");
  const std::filesystem::path file = folder_ / "plan.toml";
  const std::int64_t frames = m_.comparison.scene.last_frame();
  const std::uint64_t key = sim::checksum(std::to_string(frames), m_.comparison.scene.identity);
  if (const auto earlier = read_plan(file, key, m_.notebook.seconds())) {
    plan_ = *earlier;
  } else {
    constexpr int tried = 8;  // steps a frame
    const double look = m_.notebook.first_look(reference_cases(m_.scene(), 2 * tried)[1]);
    plan_ = affordable_plan(time_share * m_.notebook.left(), look / tried, frames);
    write_plan(file, key, m_.notebook.seconds(), plan_);
  }
  m_.comparison.stretch = stretch_of(m_.comparison, plan_.frames);
}

// Every scheme with every step, against a reference that is finer by so much.
bool Search::ladder() {
  const int fine = find_reference(m_, finer * plan_.depth);
  if (fine == 0) return false;
  plan_.depth = std::max(1, std::min(plan_.depth, fine / finer));
  mesh_time_ = ladder_mesh_time(m_.scene(), plan_);
  const Spending spending(m_, "ladder of steps");
  for (const TradeCase& which : time_cases(m_.scene(), plan_.depth))
    m_.notebook.run(which, time_share * m_.notebook.left());
  for (const TradeCase& which : explicit_cases(m_.scene())) m_.notebook.run(which, rest_share * m_.notebook.left());
  return true;
}

// What is expected to be within the goal, against a reference that is just fine enough to tell: ten times as certain.
bool Search::aimed() {
  constexpr double certain = 0.1, mesh_certain = 0.25;
  StepSearch steps(m_);
  const bool by_time = m_.goal.kind == Goal::Kind::time;
  if (by_time) {
    prepare_reference(m_);
    steps.first_runs();
    steps.fill(m_.goal.value);
  }
  const auto target = [&] { return by_time ? least_error_within(m_) : m_.goal.value; };
  if (!refine_reference(m_, [&] { return certain * target(); })) return false;
  if (!by_time) {
    steps.first_runs();
    // Half of it is left for the error of the mesh.
    constexpr double in_hand = 0.85, half = 0.5;
    steps.reach(in_hand * (m_.goal.value - error_of(m_.scorer.references().uncertainty, m_.goal)));
    if (!m_.keeps_mesh()) steps.reach(half * m_.goal.value);
  }
  mesh_time_ = time_case(m_.scene(), "tr-bdf2", steps.substeps("tr-bdf2", mesh_certain * target()));
  const Spending spending(m_, "explicit schemes");
  for (const TradeCase& which : explicit_cases(m_.scene())) m_.notebook.run(which, rest_share * m_.notebook.left());
  return true;
}

// Of errors that are not told from zero only a bound is given.
void Search::tell_what_is_below() {
  int below = 0;
  for (const Score* score : m_.scores()) below += score->below && score->run->which.axis != Axis::reference ? 1 : 0;
  if (below > 0)
    m_.note("runs closer to the reference than " + formatted("%.0f", told_apart) + " times its uncertainty (" +
            percent(m_.scorer.references().check.uncertainty) + "): " + std::to_string(below) +
            "; of their errors only a bound is given");
}

// One setting at a time around the scene's own and around the best.
void Search::rest() {
  const Spending spending(m_, "other settings");
  constexpr int rounds = 2;
  std::vector<TradeCase> around = {scene_case()};
  if (m_.notebook.recalls_only()) around.push_back(mesh_time_);
  std::set<std::string> seen;
  for (int round = 0; round < rounds; ++round) {
    if (!m_.notebook.recalls_only())
      if (const Score* best = choose(m_.scores(), m_.goal)) around.push_back(best->run->which);
    for (const TradeCase& start : around)
      if (seen.insert(settings_text(start)).second)
        for (const TradeCase& which : rest_cases(m_.scene(), start))
          m_.notebook.run(which, rest_share * m_.notebook.left());
    around.clear();
  }
  const Score* const best = choose(m_.scores(), m_.goal);
  if (!best || m_.notebook.recalls_only()) return;
  const TradeCase which = best->run->which;
  for (const TradeCase& threads : thread_cases(*m_.comparison.scene.system, m_.comparison.options.threads, which))
    m_.notebook.run(threads, rest_share * m_.notebook.left());
}

// The kinds of runs among which the advice is chosen are timed anew, all in the same minute: what the machine did while
// they were measured is forgotten. A front that changes by it may have other kinds on it, which are timed then.
void Search::calibrate() {
  const Spending spending(m_, "timing");
  constexpr double part = 0.01, longest = 0.5;  // of the time; s
  constexpr std::size_t most_kinds = 12;
  for (bool more = true; more && m_.timed_anew.size() < most_kinds;) {
    more = false;
    std::vector<const Score*> wanted = front_of(m_.scores());
    wanted.push_back(&m_.scorer.score(m_.notebook.run(scene_case(), 0)));
    if (const Score* const best = choose(m_.scores(), m_.goal)) wanted.push_back(best);
    for (const Score* score : wanted) {
      const std::string kind = kind_of(*score->run);
      if (score->run->status != CaseStatus::done || m_.timed_anew.contains(kind)) continue;
      m_.timed_anew[kind] = m_.notebook.time_steps(*score->run, std::min(longest, part * m_.notebook.seconds()));
      more = true;
    }
  }
}

}  // namespace app
