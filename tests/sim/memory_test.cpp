// No memory for the factor of the matrix: the run goes on without one, and says so.
#include <cstdlib>
#include <limits>

#include "tests/sim/cholmod_memory.h"
#include "tests/sim/stepping.h"

namespace sim {
namespace {

std::size_t most_bytes;  // of one request of CHOLMOD

void* allocate(std::size_t bytes) {
  return bytes > most_bytes ? nullptr : std::malloc(bytes);
}
void* allocate_zeros(std::size_t count, std::size_t size) {
  return count * size > most_bytes ? nullptr : std::calloc(count, size);
}
void* reallocate(void* block, std::size_t bytes) {
  return bytes > most_bytes ? nullptr : std::realloc(block, bytes);
}

class NoMemory : public testing::Test {
 protected:
  NoMemory() {
    most_bytes = std::numeric_limits<std::size_t>::max();
    test::give_memory_to_cholmod(allocate, allocate_zeros, reallocate);
  }
  ~NoMemory() override { test::give_memory_to_cholmod(std::malloc, std::calloc, std::realloc); }
  static Scene scene(LinearSolverKind linear) {
    Scene scene = test::beam("tet4", 4);
    scene.solver.linear = linear;
    return scene;
  }
};

TEST_F(NoMemory, ForTheFactorMeansConjugateGradientsWithoutMatrix) {
  test::Stepped plain(scene(LinearSolverKind::pcg));
  plain.steps(5);
  for (const std::size_t bytes : {0UL, 100'000UL}) {  // none for the analysis; some, but none for the factor
    test::Stepped run(scene(LinearSolverKind::cholmod));
    most_bytes = bytes;
    run.steps(1);
    EXPECT_TRUE(run.last.no_factor) << bytes;
    run.steps(4);
    EXPECT_FALSE(run.last.no_factor) << "said once";
    most_bytes = std::numeric_limits<std::size_t>::max();
    EXPECT_EQ(hash(run.state), hash(plain.state)) << bytes;
  }
}

TEST_F(NoMemory, ForTheFactorOfASavedRunMeansThatToo) {
  test::Stepped first(scene(LinearSolverKind::cholmod));
  first.steps(3);
  EXPECT_FALSE(first.last.no_factor);
  test::Stepped resumed(scene(LinearSolverKind::cholmod));
  resumed.state = first.state;
  most_bytes = 0;
  resumed.steps(1);
  EXPECT_TRUE(resumed.last.no_factor);
  most_bytes = std::numeric_limits<std::size_t>::max();
  first.steps(1);
  EXPECT_LT((resumed.state.x - first.state.x).cwiseAbs().maxCoeff(), 1e-5);
}

}  // namespace
}  // namespace sim
