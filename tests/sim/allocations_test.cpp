#include "tests/sim/allocations.h"

#include <atomic>
#include <cstddef>

#include "tests/sim/cholmod_memory.h"
#include "tests/sim/stepping.h"

#if defined(__SANITIZE_ADDRESS__)

namespace sim::test {
bool can_count_allocations() {
  return false;
}
void start_counting() {}
long stop_counting() {
  return 0;
}
}  // namespace sim::test

#else

namespace {
std::atomic<bool> counting = false;
std::atomic<long> count = 0;
}  // namespace

extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);

void* malloc(std::size_t size) {
  if (counting) ++count;
  return __libc_malloc(size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  if (counting) ++count;
  return __libc_memalign(alignment, size);
}
}

namespace sim::test {
bool can_count_allocations() {
  return true;
}
void start_counting() {
  give_memory_to_cholmod(__libc_malloc, __libc_calloc, __libc_realloc);
  count = 0;
  counting = true;
}
long stop_counting() {
  counting = false;
  return count;
}
}  // namespace sim::test

#endif

namespace sim {
namespace {

TEST(Allocations, ACountIsSeen) {
  if (!test::can_count_allocations()) GTEST_SKIP();
  test::start_counting();
  std::vector<double>* volatile v = new std::vector<double>(100);  // volatile: compilers may leave out what is not seen
  const Eigen::VectorXd e = Eigen::VectorXd::Ones(100);
  const long count = test::stop_counting();
  EXPECT_EQ(e.sum(), v->size());
  delete v;
  EXPECT_GE(count, 3);
}

// After the first step a step allocates nothing, whatever scheme and solver.
TEST(Allocations, NoneInAStepAfterTheFirst) {
  if (!test::can_count_allocations()) GTEST_SKIP();
  for (const char* integrator :
       {"symplectic-euler", "central-difference", "backward-euler", "sdirk2", "tr-bdf2", "bdf2"})
    for (const LinearSolverKind linear : {LinearSolverKind::cholmod, LinearSolverKind::pcg,
                                          LinearSolverKind::pcg_assembled, LinearSolverKind::two_level}) {
      Scene scene = test::beam("tet4", 2);
      scene.time.integrator = integrator;
      scene.time.substeps = 20;
      scene.solver.linear = linear;
      scene.bodies[0].damping = {0.1, 1e-4};
      test::Stepped run(scene);
      run.steps(4);
      test::start_counting();
      run.stepper->step(run.state);
      const long count = test::stop_counting();
      EXPECT_EQ(count, 0) << integrator << " " << name_of(linear);
    }
}

// Nor do the terms that freeze something when a step begins, or that act here and there.
TEST(Allocations, NoneInAStepOfAScrambledBodyOnASlopeWithFriction) {
  if (!test::can_count_allocations()) GTEST_SKIP();
  Scene scene = test::beam("tet4", 2);
  scene.time.substeps = 20;
  scene.bodies[0].pins.clear();
  scene.bodies[0].untangle = 1;
  scene.bodies[0].start.shape = "scrambled";
  const Plane slope{{0, 0, -0.01}, Vec3(0.3, 0, 1).normalized()};
  scene.obstacles = {{slope, 0.4}, {Sphere{{2, 0.5, -1.01}, 1}, 0.2}};
  scene.springs = {{scene.bodies[0].name, {4, 1, 1}, {4, 2, 1}, 1e4}};
  test::Stepped run(scene);
  int touching = 0;
  const double dh = 1e-3 * run.system.bodies()[0].size;
  for (int k = 0; k < 4; ++k) run.stepper->step(run.state);
  for (int k = 0; k < 30; ++k) {
    test::start_counting();
    run.stepper->step(run.state);
    EXPECT_EQ(test::stop_counting(), 0) << "step " << run.state.step;
    for (Eigen::Index i = 0; i < run.state.x.size(); i += 3)
      touching += slope.normal.dot(run.state.x.segment<3>(i) - slope.point) < dh;
  }
  EXPECT_GT(touching, 0) << "the plane was not reached";
}

}  // namespace
}  // namespace sim
