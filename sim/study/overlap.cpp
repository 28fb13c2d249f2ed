#include "sim/study/overlap.h"

#include <set>

#include "sim/build/parts.h"
#include "sim/contact/meeting.h"

namespace sim {

namespace {

// Nothing where no two bodies are to be looked at.
Skin skin_of_all(const Model& model, bool wanted) {
  Skin skin;
  if (!wanted) return skin;
  skin.D = model.D;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) add_part(skin, model.bodies[b], model.ranges[b].first_node);
  return skin;
}

std::set<std::pair<std::string, std::string>> named_pairs(const Model& model) {
  std::set<std::pair<std::string, std::string>> named;
  for (const ContactTerm* term : model.contacts)
    for (const Couple& couple : term->input().couples)
      named.insert({term->input().names[couple.a], term->input().names[couple.b]});
  return named;
}

std::vector<Couple> unnamed_couples(const Model& model) {
  const auto named = named_pairs(model);
  std::vector<Couple> couples;
  const int bodies = static_cast<int>(model.ranges.size());
  for (int a = 0; a < bodies; ++a)
    for (int b = a + 1; b < bodies; ++b)
      if (!named.contains({model.ranges[a].name, model.ranges[b].name}) &&
          !named.contains({model.ranges[b].name, model.ranges[a].name}))
        couples.push_back({a, b, 0, 0});
  return couples;
}

}  // namespace

Overlap::Overlap(const System& system)
    : couples_(unnamed_couples(parts_of(system).model)),
      skin_(skin_of_all(parts_of(system).model, !couples_.empty())),
      broad_phase_(skin_, points_at(skin_, parts_of(system).model.X)) {
  for (const BodyRange& range : system.bodies()) names_.push_back(range.name);
}

std::optional<std::pair<std::string, std::string>> Overlap::find(const State& state) const {
  if (couples_.empty() || !state.x.allFinite()) return std::nullopt;
  const std::vector<Crossing> all = crossings(skin_, couples_, broad_phase_, points_at(skin_, state.x));
  if (all.empty()) return std::nullopt;
  const Couple& couple = couples_[all.front().couple];
  return std::pair(names_[couple.a], names_[couple.b]);
}

}  // namespace sim
