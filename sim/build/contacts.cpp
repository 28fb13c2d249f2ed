#include "sim/build/contacts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <sstream>

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

double softest(const Body& body) {
  double young = std::numeric_limits<double>::infinity();
  for (const MaterialSpec& material : body.materials) young = std::min(young, material.young);
  return young;
}

Couple couple_of(const Model& model, const Contact& contact, int a, int b) {
  Couple couple{a, b, 0, 0};
  couple.dh = contact.distance.value_or(thousandth * std::min(model.ranges[a].size, model.ranges[b].size));
  couple.kappa = contact.stiffness.value_or(0.1 * std::min(softest(model.bodies[a]), softest(model.bodies[b])));
  couple.xi = contact.offset.value_or(0);
  return couple;
}

ContactTerm::Input input_of(const Model& model, const Contact& contact, const std::string& key,
                            std::set<std::pair<int, int>>& named) {
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
      input.names.push_back(model.ranges[body].name);
      const Body& it = model.bodies[body];
      add_part(input.skin, flat_faces(it.mesh, model.D), it.mesh.X, model.ranges[body].first_node, it.thickness);
    }
    Couple couple = couple_of(model, contact, a, b);
    couple.a = part[a];
    couple.b = part[b];
    input.couples.push_back(couple);
  }
  return input;
}

// Pairs that are near each other at rest already must not push: of a body with itself, and where an offset is given.
void settle_distance(ContactTerm::Input& input, const Contact& contact, const Model& model) {
  for (Couple& couple : input.couples) {
    if (couple.a != couple.b) continue;
    ContactTerm::Input alone{input.name, input.skin, {couple}, 0, 0, input.names};
    alone.couples[0].dh = 2 * couple.dh;
    const double gap = ContactTerm(std::move(alone), model.X).reports(model.X)[0].gap;
    if (contact.distance && gap < couple.dh)
      throw InputError("contact", "\"" + input.names[couple.a] + "\" is within the distance of itself at rest: " +
                                      std::to_string(gap) + " m, so take a smaller one");
    if (!contact.distance) couple.dh = std::min(couple.dh, gap / 2);
  }
}

std::string text_of(const Vec3& x, int D) {
  std::ostringstream text;
  text << '(' << x[0] << ", " << x[1];
  if (D == 3) text << ", " << x[2];
  text << ')';
  return text.str();
}

// Bodies that cross, or touch, at the start could only be forced apart.
void check_contact_start(const ContactTerm& term, const Eigen::VectorXd& x, const std::string& key) {
  const ContactTerm::Input& in = term.input();
  const auto names = [&](const Couple& couple) {
    return couple.a == couple.b ? "\"" + in.names[couple.a] + "\" crosses itself"
                                : "\"" + in.names[couple.a] + "\" and \"" + in.names[couple.b] + "\" cross each other";
  };
  const std::vector<Crossing> all = term.crossings(x);
  if (!all.empty()) {
    std::string places;
    const std::size_t shown = std::min<std::size_t>(3, all.size());
    for (std::size_t k = 0; k < shown; ++k) places += (k ? ", " : "") + text_of(all[k].at, in.skin.D);
    throw InputError(key, names(in.couples[all[0].couple]) + " at the start, at " + std::to_string(all.size()) +
                              (all.size() == 1 ? " place" : " places") + ", near " + places +
                              ": bodies of a [[contact]] must start apart");
  }
  const auto store = term.make_store(1);
  if (std::isfinite(term.energy({x, x, 0, 0}, *store))) return;
  throw InputError(key,
                   "bodies touch, or are nearer than the offset, at the start: leave a gap between them, as small "
                   "as a thousandth of the distance where the barrier begins");
}

}  // namespace

void add_contacts(Parts& parts, const Scene& scene) {
  Model& model = parts.model;
  Eigen::VectorXd start = model.x_start, v = Eigen::VectorXd::Zero(model.dofs());
  model.pins.prescribe(0, start, v);
  std::set<std::pair<int, int>> named;
  double size = std::numeric_limits<double>::infinity();
  for (const BodyRange& range : model.ranges) size = std::min(size, range.size);
  // Entries that name their bodies come before those that mean every pair.
  std::vector<std::size_t> order;
  for (const bool every : {false, true})
    for (std::size_t k = 0; k < scene.contacts.size(); ++k)
      if (scene.contacts[k].between.empty() == every) order.push_back(k);
  for (const std::size_t k : order) {
    const Contact& contact = scene.contacts[k];
    ContactTerm::Input input = input_of(model, contact, "contact." + std::to_string(k), named);
    if (input.couples.empty()) continue;
    input.eps = thousandth * size;
    for (const std::string& name : contact.between) input.name += (input.name.empty() ? "" : " ") + name;
    if (input.name.empty()) input.name = "of every pair";
    settle_distance(input, contact, model);
    auto term = std::make_unique<ContactTerm>(std::move(input), model.X);
    check_contact_start(*term, start, "contact." + std::to_string(k));
    model.contacts.push_back(term.get());
    model.terms.push_back(std::move(term));
  }
}

}  // namespace sim
