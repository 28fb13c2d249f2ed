#include <iostream>

#include "app/base/exit_code.h"
#include "app/base/text.h"
#include "app/command/commands.h"
#include "app/command/explain_bases.h"
#include "app/scene/key_reference.h"
#include "app/scene/keys.h"
#include "app/scene/simulation.h"
#include "sim/mesh/locate.h"
#include "sim/study/explicit_limit.h"

namespace app {
namespace {

constexpr double drawing = 80e6;  // bytes: the rasteriser and the pictures under way, measured

std::string bytes_text(double bytes) {
  if (bytes >= 1e9) return formatted("%.1f GB", bytes / 1e9);
  return formatted("%.0f MB", bytes / 1e6);
}

void print_line(const std::string& name, const std::string& value) {
  constexpr std::size_t width = 14;
  std::cout << "  " << name << std::string(name.size() < width ? width - name.size() : 1, ' ') << value << '\n';
}

void print_time(const Simulation& simulation, int threads) {
  const sim::Time& time = simulation.document.scene.time;
  const sim::System& system = *simulation.system;
  std::cout << "time\n";
  print_line("integrator", time.integrator);
  print_line("seconds", formatted("%.6g s", time.seconds));
  print_line("frames", std::to_string(simulation.last_frame() + 1) + " at " + std::to_string(time.fps) +
                           " per second, frame 0 the initial state");
  print_line("steps",
             std::to_string(simulation.last_step()) + ", " + std::to_string(system.steps_per_frame()) + " per frame");
  print_line("step h", formatted("%.6g s", system.step_seconds()));
  if (system.bodies().empty()) return;  // a page of a lecture that moves nothing
  const double limit = sim::explicit_limit(simulation.document.scene, system, threads);
  print_line("stable h", formatted("%.3g s", limit) + " at most in an explicit scheme");
}

// Where bodies are at rest, what they weigh, and by which names their parts are known.
void print_bodies(const sim::System& system) {
  if (!system.bodies().empty()) std::cout << "bodies\n";
  for (std::size_t b = 0; b < system.bodies().size(); ++b) {
    const sim::Mesh& mesh = *system.bodies()[b].mesh;
    std::string groups;
    for (const sim::Group& group : mesh.groups)
      groups += (groups.empty() ? "; groups " : ", ") + group.name + " (" +
                (group.nodes.empty() ? std::to_string(group.elements.size()) + " elements"
                                     : std::to_string(group.nodes.size()) + " nodes") +
                ")";
    print_line(system.bodies()[b].name, formatted("%.4g kg; ", system.mass(b)) + sim::span_text(mesh) + groups);
  }
}

void print_terms(const sim::System& system) {
  std::cout << "terms\n";
  for (const sim::TermInfo& term : system.terms()) std::cout << "  " << term.name << ": " << term.what << '\n';
}

void print_costs(const sim::System& system) {
  const sim::Counts counts = system.counts();
  std::cout << "counts\n";
  print_line("nodes", std::to_string(counts.nodes));
  print_line("elements", std::to_string(counts.elements));
  print_line("dofs", std::to_string(counts.dofs) + ", of which " + std::to_string(counts.free_dofs) + " free");
  print_line("nonzeros", counts.nonzeros == 0 ? "none: no matrix is formed" : std::to_string(counts.nonzeros));
  print_line("memory", "about " + bytes_text(static_cast<double>(counts.bytes)) + ", and " + bytes_text(drawing) +
                           " more to draw");
}

// Of the keys that were given, those whose value is not the default.
void print_changed_keys(const Document& document) {
  const Document blank = blank_document();
  std::cout << "keys other than default\n";
  for (const auto& [path, place] : document.places) {
    Indices indices{};
    const Key* key = find_key_at(path, indices);
    if (key == nullptr || place.text.empty() || key->binding.get == nullptr) continue;
    if (key->binding.get(document, indices) == key->binding.get(blank, {})) continue;
    std::cout << "  " << path << " = " << place.text;
    if (!key->unit.empty()) std::cout << "  [" << key->unit << ']';
    std::cout << "  (" << place.where << ")\n";
  }
}

}  // namespace

int explain(const Options& options) {
  if (options.keys) {
    std::cout << key_reference_markdown();
    return exit_done;
  }
  const Simulation simulation = build_simulation(options);
  std::cout << simulation.document.title << '\n';
  print_time(simulation, options.threads);
  print_bodies(*simulation.system);
  print_terms(*simulation.system);
  print_costs(*simulation.system);
  print_bases(simulation, options);
  print_changed_keys(simulation.document);
  for (const std::string& remark : simulation.remarks()) std::cout << "note: " << remark << '\n';
  return exit_done;
}

}  // namespace app
