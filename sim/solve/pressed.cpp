#include "sim/solve/pressed.h"

#include <sstream>

namespace sim {

namespace {

std::string quoted(const std::string& name) {
  return "\"" + name + "\"";
}

std::string body_at(const Model& model, int node) {
  for (const BodyRange& range : model.ranges)
    if (node >= range.first_node && node < range.first_node + range.node_count) return range.name;
  return "";
}

Nearness nearest_of_all(const Model& model, const Motion& motion) {
  Nearness least;
  for (const ContactTerm* term : model.contacts)
    if (const Nearness one = term->nearest(motion.x, motion.t); one.share < least.share) least = one;
  for (const ObstacleTerm* term : model.smooth)
    if (const auto one = term->nearest(motion.x, motion.t); one.share < least.share)
      least = {body_at(model, one.node), term->obstacle().name, one.gap, one.share};
  return least;
}

}  // namespace

std::string pressed_text(const Model& model, const Motion& motion, const Eigen::VectorXd& way) {
  Eigen::Index farthest;
  way.cwiseAbs().maxCoeff(&farthest);
  const Pins::Name mover = model.pins.name_of(static_cast<int>(farthest / model.D), motion.t);
  const Nearness near = nearest_of_all(model, motion);
  std::ostringstream text;
  text << mover.text << " presses ";
  if (near.first == mover.owner)
    text << quoted(near.second);
  else if (near.second == mover.owner)
    text << quoted(near.first);
  else
    text << quoted(near.first) << " against " << quoted(near.second);
  text << ", which cannot make room for what is prescribed: the gap is " << near.gap << " m";
  return text.str();
}

}  // namespace sim
