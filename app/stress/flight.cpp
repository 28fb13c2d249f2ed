#include "app/stress/flight.h"

#include <atomic>
#include <thread>

#include "app/base/text.h"
#include "sim/mesh/generate.h"
#include "sim/time/scheme.h"

namespace app {
namespace {

// Six tets, 1 m; flying it moves at 5 m/s and turns at 2 rad/s. A tolerance at which round-off is what remains.
sim::Scene body(std::string_view scheme, bool flying) {
  sim::Scene scene;
  sim::Body body;
  body.name = "body";
  body.mesh = sim::generate_box({1, 1, 1}, {1, 1, 1}, {1, 1, 1}, sim::ElementKind::tet4);
  body.materials = {sim::MaterialSpec{"stable-neo-hookean", 1e5, 0.3, 1000, ""}};
  if (flying) {
    body.velocity = {3, 4, 0};
    body.spin = {{0, 0, 1}, 2};
  }
  scene.world.gravity = {0, 0, 0};
  scene.time.integrator = scheme;
  const sim::Scheme& integrator = *sim::find_scheme(scheme);
  scene.time.substeps = integrator.is_explicit() ? 0 : 1;
  // Of one iteration it is that of the linear solve.
  scene.solver.tolerance = integrator.one_iteration ? 1e-14 : 1e-10;
  scene.solver.on_failure = sim::OnFailure::accept;
  scene.bodies = {body};
  return scene;
}

}  // namespace

std::vector<Flight> fly(std::int64_t steps, int threads, const std::function<bool()>& interrupted) {
  std::vector<Flight> flights;
  for (const sim::Scheme& scheme : sim::schemes())
    if (!scheme.is_static) flights.push_back({std::string(scheme.name), {}, {}});
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t k = next++; k < flights.size() && !interrupted(); k = next++) {
      flights[k].flying = sim::flight_drift(sim::System(body(flights[k].scheme, true)), steps, interrupted);
      flights[k].resting = sim::flight_drift(sim::System(body(flights[k].scheme, false)), steps, interrupted);
    }
  };
  std::vector<std::thread> workers;
  for (int k = 0; k < threads; ++k) workers.emplace_back(work);
  for (std::thread& worker : workers) worker.join();
  return flights;
}

std::string flight_table(const std::vector<Flight>& flights, std::int64_t steps) {
  std::string table =
      formatted("%lld steps of a body in free flight, and of one at rest\n%-20s %10s %10s %10s %12s\n",
                static_cast<long long>(steps), "integrator", "|dp|/|p|", "|dL|/|L|", "dE/E", "at rest |u|");
  for (const Flight& f : flights) {
    table += formatted("%-20s %10.1e %10.1e %10.1e %12.1e", f.scheme.c_str(), f.flying.p, f.flying.L, f.flying.energy,
                       f.resting.away);
    for (const sim::FlightDrift* d : {&f.flying, &f.resting})
      if (!d->failure.empty()) table += "  after " + std::to_string(d->steps) + " steps: " + d->failure;
    table += '\n';
  }
  return table;
}

}  // namespace app
