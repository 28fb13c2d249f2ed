// What contact tells of itself: forces between bodies, gaps, areas.
#include <algorithm>

#include "sim/term/contact_store.h"

namespace sim {

// The part of a force on points, three numbers each, that acts on the first of two bodies.
Vec3 ContactTerm::on_first(const Couple& couple, const std::array<int, 4>& points, int count,
                           const PairVector& force) const {
  Vec3 sum = Vec3::Zero();
  if (couple.a == couple.b) return sum;
  const Span& first = in_.skin.parts[couple.a].points;
  for (int i = 0; i < count; ++i)
    if (points[i] >= first.first && points[i] < first.last) sum += force.segment<3>(3 * i);
  return sum;
}

// What lies under the points that a face pushes; points of both sides carry half of it each.
double ContactTerm::area_of(const Candidate& candidate, Contacts& s) const {
  if (candidate.kind == PairKind::edge_edge) return 0;
  std::vector<Touch> touches;
  add_touches(in_.skin, in_.couples, candidate, s.x, touches);
  double area = 0;
  for (const Touch& touch : touches) area += touch.weight / in_.couples[touch.couple].kappa;
  return area;
}

std::vector<ContactReport> ContactTerm::reports(const Motion& begin, const Motion& motion) const {
  const auto store = make_store(1);
  auto& s = static_cast<Contacts&>(*store);
  std::vector<ContactReport> all;
  for (const Couple& couple : in_.couples) all.push_back({in_.names[couple.a], in_.names[couple.b]});
  begin_step(begin, s);
  if (!find_touches(motion, s) || is_gone(motion.t)) return all;
  for (const Touch& touch : s.touches) {
    const Couple& couple = in_.couples[touch.couple];
    ContactReport& report = all[touch.couple];
    ++report.pairs;
    report.gap = std::min(report.gap, touch.d - couple.xi);
    report.force += on_first(couple, touch.point, points_in(touch), -TouchPotential(touch, couple, s.x).gradient());
  }
  for (const Stick& stick : s.sticks)
    all[stick.couple].friction +=
        on_first(in_.couples[stick.couple], stick.point, stick.count,
                 spread(stick.shares(), Vec3(-stick.strength * slip_gradient(slip(stick, motion.v), in_.eps))));
  for (const Candidate& candidate : s.candidates) all[candidate.couple].area += area_of(candidate, s);
  return all;
}

Nearness ContactTerm::nearest(const Eigen::VectorXd& x, double t) const {
  const auto store = make_store(1);
  auto& s = static_cast<Contacts&>(*store);
  Nearness least;
  if (!find_touches({x, x, t, 0}, s)) return least;
  for (const Touch& touch : s.touches) {
    const Couple& couple = in_.couples[touch.couple];
    const double gap = touch.d - couple.xi;
    if (gap / couple.dh < least.share) least = {in_.names[couple.a], in_.names[couple.b], gap, gap / couple.dh};
  }
  return least;
}

}  // namespace sim
