// What a basis can represent of the full body's motion, beside what the body in it does.
#include "sim/study/projection.h"

#include "sim/reduce/at_rest.h"
#include "sim/study/modes.h"
#include "sim/study/swing.h"
#include "tests/sim/basis_support.h"
#include "tests/sim/json.h"

namespace sim {
namespace {

using test::frames;
using test::plane_cantilever;
using test::reduced;

// tests/data/lecture/reduced.json: static_best and dynamic_best, and the errors that runs come to.
TEST(Projection, IsThatOfTheReference) {
  const test::Json reference = test::lecture_data("reduced.json");
  const Scene full = plane_cantilever(1e6, "trapezoidal");
  const Eigen::MatrixXd run = frames(full, 120), u = run.rightCols(120).colwise() - run.col(0);
  std::vector<std::int64_t> steps(120);
  for (std::size_t k = 0; k < steps.size(); ++k) steps[k] = static_cast<std::int64_t>(k) + 1;
  for (const auto& [kind, name] : {std::pair{BasisKind::modes, "linear modes"},
                                   std::pair{BasisKind::derivatives, "k modes and their k(k+1)/2 derivatives"}})
    for (const test::Json& row : reference["large"]["rows"].list) {
      if (row["basis"].text != name || row["r"].number > 20) continue;
      const System system(reduced(full, kind, static_cast<int>(row["r"].number)));
      const Compared compared = compare(system, steps, u, 1);
      EXPECT_NEAR(compared.best / row["dynamic_best"].number, 1, 0.05) << name << row["r"].number;
      EXPECT_NEAR(compared.made / row["dynamic_rms"].number, 1, 0.05) << name << row["r"].number;
      EXPECT_GT(compared.most, compared.made);
      // The share of the static solution: the reference divides by the length, not by what is displaced.
      const Eigen::MatrixXd rest = rest_of_full(full, 1);
      ASSERT_EQ(rest.cols(), 1);
      const double norm = std::sqrt(rest.col(0).squaredNorm() / (33 * 9)) / 4;
      EXPECT_NEAR(*projection_error(system, rest) * norm / row["static_best"].number, 1, 0.2);
    }
}

TEST(Projection, OfWhatIsInTheBasisIsNothing) {
  const Scene scene = reduced(plane_cantilever(5e6, "trapezoidal", 8, 2), BasisKind::derivatives, 5);
  const System system(scene);
  const Eigen::MatrixXd& U = scene.bodies[0].basis->vectors->U;
  EXPECT_LT(*projection_error(system, U), 1e-12);
  EXPECT_FALSE(projection_error(system, Eigen::MatrixXd::Zero(U.rows(), 2)).has_value());
  EXPECT_GT(*projection_error(system, test::random_vector(U.rows(), 1, 1)), 0.5);
}

// The slowest motion of the basis is the first mode, and half of its period brings a beam to its far end.
TEST(Swing, GoesToItsFarEnd) {
  const Scene full = plane_cantilever(5e6, "trapezoidal", 16, 4);
  const Scene scene = reduced(full, BasisKind::derivatives, 9);
  const Response response = response_in_basis(alone_in_basis(scene, 0));
  EXPECT_NEAR(response.omega / vibration_modes(full, 0, 1).omega[0], 1, 1e-9);
  const Eigen::MatrixXd swing = swing_of_full(scene, 1), rest = rest_of_full(scene, 1);
  ASSERT_EQ(swing.cols(), steps_a_swing / 2);
  const auto lowest = [](const Eigen::VectorXd& u) { return u.minCoeff(); };
  EXPECT_NEAR(lowest(swing.rightCols(1)) / lowest(rest), 2, 0.1) << "twice as far as where it comes to rest";
  // A unit of weight along y bends it 1/9.81 times as far as its own does.
  EXPECT_NEAR(response.per_axis[1] * 9.81 / -lowest(rest), 1, 0.1);
}

TEST(Basis, ModesThatTurnHaveARemark) {
  const auto remarks = [](const Scene& scene) {
    std::string all;
    for (const std::string& remark : System(scene).remarks()) all += remark + "\n";
    return all;
  };
  const Scene soft = plane_cantilever(5e6, "backward-euler", 16, 4),
              stiff = plane_cantilever(5e8, "backward-euler", 16, 4);
  EXPECT_NE(remarks(reduced(soft, BasisKind::modes, 5)).find("take kind = \"derivatives\""), std::string::npos);
  EXPECT_EQ(remarks(reduced(soft, BasisKind::derivatives, 5)).find("vibration modes"), std::string::npos);
  EXPECT_EQ(remarks(reduced(stiff, BasisKind::modes, 5)).find("vibration modes"), std::string::npos);
}

}  // namespace
}  // namespace sim
