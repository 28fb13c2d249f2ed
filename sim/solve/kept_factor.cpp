#include "sim/solve/kept_factor.h"

namespace sim {

void note(const TangentOperator& A, Kept what, KeptFactor& kept) {
  const Linearisation& where = A.linearisation();
  kept.what = static_cast<std::int64_t>(what);
  kept.excess = 0;
  kept.solves = 0;
  kept.definiteness = static_cast<int>(where.fix);
  kept.t_begin = where.begin.t;
  kept.t = where.at.t;
  kept.dv_dx = where.at.dv_dx;
  kept.c = where.c;
  kept.barriers = where.at.barriers;
  kept.x_begin = where.begin.x;
  kept.v_begin = where.begin.v;
  kept.x = where.at.x;
  kept.v = where.at.v;
}

bool same(const KeptFactor& a, const KeptFactor& b) {
  return a.what == b.what && a.definiteness == b.definiteness && a.t_begin == b.t_begin && a.t == b.t &&
         a.dv_dx == b.dv_dx && a.c == b.c && a.barriers == b.barriers && a.x_begin == b.x_begin &&
         a.v_begin == b.v_begin && a.x == b.x && a.v == b.v;
}

void return_to(const KeptFactor& kept, TangentOperator& A, Eigen::VectorXd& scratch) {
  A.begin_step({kept.x_begin, kept.v_begin, kept.t_begin, 0});
  scratch.resize(kept.x.size());
  A.linearise({kept.x, kept.v, kept.t, kept.dv_dx, kept.barriers}, kept.c, static_cast<Definiteness>(kept.definiteness),
              scratch);
}

}  // namespace sim
