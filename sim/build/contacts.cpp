#include "sim/build/contacts.h"

#include <algorithm>
#include <set>
#include <sstream>

#include "sim/build/contact_start.h"
#include "sim/build/impact.h"
#include "sim/build/key_path.h"
#include "sim/build/obstacles.h"
#include "sim/mesh/input_error.h"
#include "sim/term/contact.h"

namespace sim {

namespace {

constexpr double thousandth = 1e-3;

int body_named(const Model& model, const std::string& name, const std::string& key) {
  const auto found =
      std::find_if(model.ranges.begin(), model.ranges.end(), [&](const BodyRange& r) { return r.name == name; });
  if (found != model.ranges.end()) return static_cast<int>(found - model.ranges.begin());
  std::string names;
  for (const BodyRange& range : model.ranges) names += (names.empty() ? "" : ", ") + range.name;
  throw InputError(key, "\"" + name + "\" is not the name of a body; there are: " + names);
}

// The pairs of bodies of an entry: its own, or every two.
std::vector<std::pair<int, int>> pairs_of(const Model& model, const Contact& contact, const std::string& key) {
  if (!contact.between.empty()) {
    if (contact.between.size() != 2)
      throw InputError(key + ".between", "must name two bodies, or one twice for contact with itself");
    return {std::minmax(body_named(model, contact.between[0], key + ".between"),
                        body_named(model, contact.between[1], key + ".between"))};
  }
  std::vector<std::pair<int, int>> all;
  const int bodies = static_cast<int>(model.ranges.size());
  if (bodies < 2) throw InputError(key, "there is one body only: name it twice in 'between' for contact with itself");
  for (int a = 0; a < bodies; ++a)
    for (int b = a + 1; b < bodies; ++b) all.emplace_back(a, b);
  return all;
}

Couple couple_of(const Parts& parts, const Contact& contact, int a, int b, const std::string& key) {
  const Model& model = parts.model;
  Couple couple{a, b, 0, 0};
  const double size = std::min(model.ranges[a].size, model.ranges[b].size);
  if (contact.distance && *contact.distance > size)
    throw InputError(key + ".distance", "must be small beside the bodies, and is more than the size of \"" +
                                            model.ranges[model.ranges[a].size == size ? a : b].name + "\", " +
                                            std::to_string(size) +
                                            " m: take a small part of that; none is a thousandth");
  couple.dh = contact.distance.value_or(thousandth * size);
  const double speed = speed_of_body(parts, a) + speed_of_body(parts, b);
  couple.kappa = contact.stiffness.value_or(
      std::min(barrier_stiffness(model.bodies[a], speed), barrier_stiffness(model.bodies[b], speed)));
  couple.xi = contact.offset.value_or(0);
  return couple;
}

// The surface of a body, as a part of the skin.
void add_body_part(ContactTerm::Input& input, const Model& model, int body) {
  input.names.push_back(model.ranges[body].name);
  add_part(input.skin, model.bodies[body], model.ranges[body].first_node);
}

ContactTerm::Input input_of(const Parts& parts, const Contact& contact, const std::string& key,
                            std::set<std::pair<int, int>>& named) {
  const Model& model = parts.model;
  ContactTerm::Input input;
  input.skin.D = model.D;
  input.friction = contact.friction;
  std::vector<int> part(model.bodies.size(), -1);  // of each body
  for (const auto& [a, b] : pairs_of(model, contact, key)) {
    // A pair that has an entry of its own keeps it.
    if (!named.insert({a, b}).second) {
      if (contact.between.empty()) continue;
      throw InputError(key + ".between", "\"" + contact.between[0] + "\" and \"" + contact.between[1] +
                                             "\" have a [[contact]] before this one");
    }
    for (const int body : {a, b}) {
      if (part[body] >= 0) continue;
      part[body] = static_cast<int>(input.skin.parts.size());
      add_body_part(input, model, body);
    }
    Couple couple = couple_of(parts, contact, a, b, key);
    couple.a = part[a];
    couple.b = part[b];
    input.couples.push_back(couple);
  }
  return input;
}

// Pairs that are near each other at rest already must not push: of a body with itself, and where an offset is given.
void settle_distance(ContactTerm::Input& input, const Contact& contact, const std::string& key, const Model& model) {
  const Motion rest{model.X, model.X, 0, 0};
  for (Couple& couple : input.couples) {
    if (couple.a != couple.b) continue;
    ContactTerm::Input alone{input.name, input.skin, {couple}, 0, 0, input.names};
    alone.couples[0].dh = 2 * couple.dh;
    const double gap = ContactTerm(std::move(alone), model.X).reports(rest, rest)[0].gap;
    if (contact.distance && gap < couple.dh)
      throw InputError(key + ".distance", "\"" + input.names[couple.a] +
                                              "\" is within the distance of itself at rest: " + std::to_string(gap) +
                                              " m, so take a smaller one");
    if (!contact.distance) couple.dh = std::min(couple.dh, gap / 2);
  }
}

// In the plane, where an obstacle is as thick as what touches it.
double thickest(const Model& model) {
  double thickness = 0;
  for (const Body& body : model.bodies) thickness = std::max(thickness, body.thickness);
  return thickness;
}

// Friction is fully grown at a thousandth of the smallest body a second.
void add_term(Model& model, ContactTerm::Input input, const std::string& key) {
  input.eps = thousandth * model.smallest_size();
  auto term = std::make_unique<ContactTerm>(std::move(input), model.X);
  Eigen::VectorXd start = model.x_start, v = Eigen::VectorXd::Zero(model.dofs());
  model.pins.prescribe(0, start, v);
  check_contact_start(model, *term, start, key);
  model.contacts.push_back(term.get());
  model.terms.push_back(std::move(term));
}

// Of the latest term, whose distance was given: pairs that start so near that they push with more than kappa, and would
// fly apart.
void note_pushes(Parts& parts, const std::string& key) {
  constexpr double near = 0.5;  // of dh
  const ContactTerm& term = *parts.model.contacts.back();
  const Motion start{parts.model.x_start, parts.model.x_start, 0, 0};
  const std::vector<ContactReport> reports = term.reports(start, start);
  for (std::size_t k = 0; k < reports.size(); ++k) {
    const Couple& couple = term.input().couples[k];
    if (reports[k].pairs == 0 || reports[k].gap >= near * couple.dh) continue;
    std::ostringstream text;
    text << key << ".distance: \"" << reports[k].first << "\" and \"" << reports[k].second << "\" start "
         << reports[k].gap << " m apart, less than half of " << couple.dh << " m: they push each other from the start";
    parts.remarks.push_back(text.str());
  }
}

}  // namespace

void add_contacts(Parts& parts, const Scene& scene) {
  Model& model = parts.model;
  std::set<std::pair<int, int>> named;
  // Entries that name their bodies come before those that mean every pair.
  std::vector<std::size_t> order;
  for (const bool every : {false, true})
    for (std::size_t k = 0; k < scene.contacts.size(); ++k)
      if (scene.contacts[k].between.empty() == every) order.push_back(k);
  for (const std::size_t k : order) {
    const Contact& contact = scene.contacts[k];
    ContactTerm::Input input = input_of(parts, contact, key_of("contact", k), named);
    if (input.couples.empty()) continue;
    for (const std::string& name : contact.between) input.name += (input.name.empty() ? "" : " ") + name;
    if (input.name.empty()) input.name = "of every pair";
    settle_distance(input, contact, key_of("contact", k), model);
    add_term(model, std::move(input), key_of("contact", k));
    if (contact.distance) note_pushes(parts, key_of("contact", k));
  }
}

void add_contacts_with_obstacle(Parts& parts, std::size_t k) {
  Model& model = parts.model;
  const Obstacle& obstacle = model.obstacles[k];
  const RigidSurface& surface = std::get<RigidSurface>(obstacle.shape);
  ContactTerm::Input input;
  input.name = name_of_obstacle(model, k);
  input.skin.D = model.D;
  input.friction = obstacle.friction;
  input.first_given = model.body_nodes;
  if (obstacle.release) input.release = *obstacle.release;
  const int bodies = static_cast<int>(model.bodies.size());
  for (int b = 0; b < bodies; ++b) {
    add_body_part(input, model, b);
    const double speed = speed_of_body(parts, b) + speed_of_obstacle(parts, k);
    input.couples.push_back({b, bodies, thousandth * model.ranges[b].size, barrier_stiffness(model.bodies[b], speed)});
  }
  input.names.push_back(input.name);
  add_part(input.skin, surface.faces, surface.X, model.obstacle_nodes[k].first, thickest(model));
  add_term(model, std::move(input), key_of("obstacle", k));
}

}  // namespace sim
