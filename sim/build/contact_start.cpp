#include "sim/build/contact_start.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "sim/contact/freeing.h"
#include "sim/element/element.h"

namespace sim {

namespace {

std::string text_of(const Vec3& x, int D) {
  std::ostringstream text;
  text.precision(4);
  // What round-off left of a zero is one.
  const auto number = [&](double value) { return std::abs(value) < 1e-6 * x.norm() ? 0.0 : value; };
  text << '(' << number(x[0]) << ", " << number(x[1]);
  if (D == 3) text << ", " << number(x[2]);
  text << ')';
  return text.str();
}

std::string quoted(const std::string& name) {
  return "\"" + name + "\"";
}

std::string who_meets(const ContactTerm::Input& in, const Couple& couple, Meet how) {
  const bool crosses = how == Meet::crosses;
  if (couple.a == couple.b)
    return quoted(in.names[couple.a]) + (crosses         ? " crosses itself"
                                         : couple.xi > 0 ? " is no further from itself than the offset"
                                                         : " touches itself");
  return quoted(in.names[couple.a]) + " and " + quoted(in.names[couple.b]) +
         (crosses         ? " cross each other"
          : couple.xi > 0 ? " are no further apart than the offset"
                          : " touch");
}

std::string places_text(const std::vector<Vec3>& places, int D) {
  std::string text =
      " at the start, at " + std::to_string(places.size()) + (places.size() == 1 ? " place, near " : " places, near ");
  const std::size_t shown = std::min<std::size_t>(3, places.size());
  for (std::size_t k = 0; k < shown; ++k) text += (k ? ", " : "") + text_of(places[k], D);
  return text;
}

// An obstacle stays where it is; of two bodies the second is moved.
std::string how_to_free(const ContactTerm::Input& in, const Surfaces& surfaces, const Couple& couple,
                        const Eigen::Matrix3Xd& x) {
  const int last_point = in.skin.parts[couple.b].points.first;
  const int mover = in.skin.node[last_point] >= in.first_given ? couple.a : couple.b;
  const auto way = freeing_translation(surfaces, couple, mover, x);
  if (!way) return "";
  return "; " + quoted(in.names[mover]) + " is free where it is moved by " + text_of(*way, in.skin.D) + " m";
}

std::vector<bool> solid_parts(const Model& model, const ContactTerm::Input& in) {
  std::vector<bool> all;
  for (const Skin::Part& part : in.skin.parts) {
    const int node = in.skin.node[part.points.first];
    bool is_solid = false;
    for (const BodyRange& range : model.ranges)
      if (node >= range.first_node && node < range.first_node + range.node_count)
        is_solid = info(range.mesh->kind).dimension == model.D;
    all.push_back(is_solid);
  }
  return all;
}

}  // namespace

void check_contact_start(const Model& model, const ContactTerm& term, const Eigen::VectorXd& x,
                         const std::string& key) {
  const ContactTerm::Input& in = term.input();
  const Eigen::Matrix3Xd points = points_at(in.skin, x);
  const BroadPhase broad_phase(in.skin, points);
  const Surfaces surfaces{in.skin, broad_phase, solid_parts(model, in)};
  std::string first, others;  // what is said of the first pair, and who the others are
  int more = 0;
  std::vector<Vec3> places;
  for (const Couple& couple : in.couples) {
    const Meeting it = meeting(surfaces, couple, points);
    if (it.how == Meet::apart) continue;
    places.insert(places.end(), it.places.begin(), it.places.end());
    if (first.empty())
      first =
          who_meets(in, couple, it.how) + places_text(it.places, in.skin.D) + how_to_free(in, surfaces, couple, points);
    else if (++more <= 5)
      others += (more > 1 ? "; " : "") + who_meets(in, couple, it.how);
  }
  if (places.empty()) return;
  if (more > 0)
    first += "; " + std::to_string(more) + " more " + (more == 1 ? "pair does" : "pairs do") +
             " not start apart: " + others + (more > 5 ? "; ..." : "");
  throw StartError(key, first + ": bodies of a contact must start apart, however small the gap", std::move(places));
}

}  // namespace sim
