#include "sim/build/contact_start.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace sim {

namespace {

std::string text_of(const Vec3& x, int D) {
  std::ostringstream text;
  text << '(' << x[0] << ", " << x[1];
  if (D == 3) text << ", " << x[2];
  text << ')';
  return text.str();
}

}  // namespace

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

}  // namespace sim
