#include "sim/study/overlap.h"

#include <set>

#include "sim/build/parts.h"

namespace sim {

namespace {

Skin skin_of_all(const Model& model) {
  Skin skin;
  skin.D = model.D;
  for (std::size_t b = 0; b < model.bodies.size(); ++b)
    add_part(skin, flat_faces(model.bodies[b].mesh, model.D), model.bodies[b].mesh.X, model.ranges[b].first_node,
             model.bodies[b].thickness);
  return skin;
}

Eigen::Matrix3Xd points_at(const Skin& skin, const Eigen::VectorXd& x) {
  Eigen::Matrix3Xd points = Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(skin.node.size()));
  for (std::size_t p = 0; p < skin.node.size(); ++p)
    points.col(static_cast<Eigen::Index>(p)).head(skin.D) =
        x.segment(static_cast<Eigen::Index>(skin.node[p]) * skin.D, skin.D);
  return points;
}

std::set<std::pair<std::string, std::string>> named_pairs(const Model& model) {
  std::set<std::pair<std::string, std::string>> named;
  for (const ContactTerm* term : model.contacts)
    for (const Couple& couple : term->input().couples)
      named.insert({term->input().names[couple.a], term->input().names[couple.b]});
  return named;
}

}  // namespace

Overlap::Overlap(const System& system)
    : skin_(skin_of_all(parts_of(system).model)), broad_phase_(skin_, points_at(skin_, parts_of(system).model.X)) {
  const Model& model = parts_of(system).model;
  const auto named = named_pairs(model);
  for (const BodyRange& range : model.ranges) names_.push_back(range.name);
  const int bodies = static_cast<int>(names_.size());
  for (int a = 0; a < bodies; ++a)
    for (int b = a + 1; b < bodies; ++b)
      if (!named.contains({names_[a], names_[b]}) && !named.contains({names_[b], names_[a]}))
        couples_.push_back({a, b, 0, 0});
}

std::optional<std::pair<std::string, std::string>> Overlap::find(const State& state) const {
  if (couples_.empty() || !state.x.allFinite()) return std::nullopt;
  const std::vector<Crossing> all = crossings(skin_, couples_, broad_phase_, points_at(skin_, state.x));
  if (all.empty()) return std::nullopt;
  const Couple& couple = couples_[all.front().couple];
  return std::pair(names_[couple.a], names_[couple.b]);
}

}  // namespace sim
