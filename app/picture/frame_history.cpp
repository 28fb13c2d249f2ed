#include "app/picture/frame_history.h"

#include <algorithm>

#include "app/exhibit/exhibit.h"
#include "app/picture/colour_values.h"
#include "app/picture/energies.h"
#include "sim/study/basis.h"

namespace app {
namespace {

std::optional<sim::Quantity> free_range(const Look& look) {
  return look.range ? std::nullopt : quantity(look.colour);
}

}  // namespace

FrameHistory::FrameHistory(const Simulation& simulation, std::vector<Energies> before) : FrameHistory(simulation) {
  if (shows_energies_) energies_ = std::move(before);
}

void FrameHistory::follow(const Simulation& simulation, Exhibits made) {
  follow_full_body(simulation);
  system_ = simulation.system.get();
  coloured_ = free_range(simulation.document.look);
  shows_energies_ = simulation.document.look.energies;
  if (!shows_energies_) energies_.clear();
  follow_exhibits(simulation, std::move(made));
}

void FrameHistory::follow_full_body(const Simulation& simulation) {
  const Document& document = simulation.document;
  if (!document.look.ghost || !sim::has_basis(document.scene))
    full_.reset();
  else if (!full_)
    full_.emplace(simulation);
  else if (system_ != simulation.system.get())
    full_->follow(simulation);
}

// Anew where the system is another, or what they are to show; a curve of the same numbers goes on.
void FrameHistory::follow_exhibits(const Simulation& simulation, Exhibits made) {
  if (exhibits_.are_of(simulation.document, simulation.system)) return;
  if (!made.are_of(simulation.document, simulation.system))
    made = make_exhibits(simulation.document, simulation.system);
  for (std::size_t k = 0; k < std::min(made.all.size(), exhibits_.all.size()); ++k) {
    Trace *const before = exhibits_.all[k]->trace(), *const now = made.all[k]->trace();
    if (before != nullptr && now != nullptr && before->names() == now->names()) *now = *before;
  }
  exhibits_ = std::move(made);
}

std::vector<Ring> FrameHistory::rings(const sim::State& state) const {
  std::vector<Ring> all;
  render::Sheet sheet;
  for (std::size_t k = 0; k < exhibits_.all.size(); ++k) {
    const std::size_t first = sheet.diagrams.size();
    exhibits_.all[k]->show(state, sheet);
    for (Grip& grip : exhibits_.all[k]->grips(state)) {
      const render::Diagram& diagram = sheet.diagrams[first + grip.diagram];
      all.push_back({"exhibit." + std::to_string(k) + "." + grip.key, std::move(grip), diagram});
    }
  }
  return all;
}

void FrameHistory::revise(const Simulation& simulation, const sim::State& state, LargestShown& largest, Exhibits made) {
  follow(simulation, std::move(made));
  const double t = system_->time(state.step);
  std::erase_if(energies_, [&](const Energies& frame) { return frame.t > t; });
  for (Trace* trace : traces()) trace->cut(t);
  if (state.step % system_->steps_per_frame() == 0) add(state, largest);
}

std::vector<Trace*> FrameHistory::traces() const {
  std::vector<Trace*> all;
  for (const auto& exhibit : exhibits_.all)
    if (Trace* trace = exhibit->trace(); trace != nullptr) all.push_back(trace);
  return all;
}

void FrameHistory::add(const sim::State& state, LargestShown& largest) {
  if (coloured_) {
    double& reach = largest[static_cast<std::size_t>(*coloured_)];
    reach = std::max(reach, reach_of(*coloured_, system_->node_values(state, *coloured_)));
  }
  for (const auto& exhibit : exhibits_.all) exhibit->note(state);
  if (full_) full_->reach(state.step / system_->steps_per_frame(), state);
  if (!shows_energies_) return;
  const Energies now = energies_of(*system_, state);
  std::erase_if(energies_, [&](const Energies& other) { return other.t >= now.t; });
  energies_.push_back(now);
}

void FrameHistory::fill(const LargestShown& largest, Moment& moment) const {
  if (coloured_) moment.largest = largest[static_cast<std::size_t>(*coloured_)];
  moment.energies = energies_;
  if (full_) moment.full = full_->x();
  if (exhibits_.all.empty()) return;
  moment.sheet.emplace();
  for (const auto& exhibit : exhibits_.all) exhibit->show(moment.state, *moment.sheet);
}

}  // namespace app
