// The command `ritz residuals`: what it refuses and what it leaves.
#include <gtest/gtest.h>

#include <algorithm>

#include "app/base/exit_code.h"
#include "app/command/commands.h"
#include "app/residuals/plot.h"
#include "app/residuals/tables.h"
#include "tests/app/temporary_folder.h"

namespace app {
namespace {

ResidualStudy study_of(const std::string& text, bool anyway = false) {
  return study_residuals(read_problem(text, "test.toml"), anyway);
}

const char* const wind = "a = \"1\"\nf = \"1\"\nn = [2, 4]\n";

TEST(ResidualsCommand, RefusesRitzWithTheNumberThatShowsWhy) {
  const ResidualStudy study = study_of(wind);
  const std::string text = study_text(study);
  EXPECT_NE(
      text.find("refused: ritz needs a self-adjoint L, and int v L u - int u L v = -0.03333333333 for u = x (1-x), "
                "v = x^2 (1-x), not 0; --anyway does it all the same"),
      std::string::npos)
      << text;
  EXPECT_EQ(residuals_csv({&study, 1}).find("ritz"), std::string::npos);
}

TEST(ResidualsCommand, DoesRitzAnyway) {
  const ResidualStudy study = study_of(wind, true);
  const std::string csv = residuals_csv({&study, 1});
  EXPECT_NE(csv.find("test,sines,ritz-anyway,2,"), std::string::npos) << csv;
  EXPECT_NE(csv.find("test,hats,ritz-anyway,4,"), std::string::npos) << csv;
}

TEST(ResidualsCommand, RefusesHatsWithTheReasonOnceAMethod) {
  const ResidualStudy study = study_of("f = \"1\"\nn = [1, 2, 4]\n");
  ASSERT_EQ(study.refusals.size(), 3u);
  for (const std::string& refusal : study.refusals)
    EXPECT_NE(refusal.find("needs u'', and hats have none"), std::string::npos) << refusal;
}

TEST(ResidualsCommand, TablesHaveTheColumnsOfTheLecture) {
  const ResidualStudy study = study_of("f = \"1\"\nn = [2, 4]\n");
  const std::string residuals = residuals_csv({&study, 1}), coefficients = coefficients_csv({&study, 1}),
                    orders = orders_csv({&study, 1});
  EXPECT_TRUE(residuals.starts_with("problem,basis,method,n,L2,H1_seminorm,energy_norm,residual_L2,max_1001,F\n"));
  EXPECT_TRUE(coefficients.starts_with("problem,basis,method,n,i,c\n"));
  EXPECT_TRUE(orders.starts_with("problem,basis,method,n,order_L2,order_H1,order_residual,order_max\n"));
  EXPECT_EQ(std::ranges::count(residuals, '\n'), 1 + (5 + 5 + 2) * 2);
  EXPECT_EQ(std::ranges::count(coefficients, '\n'), 1 + (5 + 5 * 2 + 2) * (2 + 4));
  EXPECT_NE(coefficients.find("test,polynomials:x^i(1-x),galerkin,2,1,0.5\n"), std::string::npos) << coefficients;
  EXPECT_NE(orders.find("test,hats,galerkin,2 to 4,2"), std::string::npos) << orders;
}

TEST(ResidualsCommand, MarksTheLeastOfEachColumn) {
  const std::string text = study_text(study_of("k = \"1+x\"\nf = \"exp(x)\"\nn = [4]\nbases = [\"polynomials\"]"));
  const std::size_t squares = text.find("least-squares"), galerkin = text.find("galerkin"), ritz = text.find("ritz  ");
  ASSERT_NE(ritz, std::string::npos);
  EXPECT_EQ(std::ranges::count(text.substr(squares, galerkin - squares), '*'), 1) << text;  // the residual
  EXPECT_GE(std::ranges::count(text.substr(galerkin, ritz - galerkin), '*'), 2) << text;    // H1 or L2, and energy
  EXPECT_NE(text.find("no exact u is given: errors are against a computed one"), std::string::npos);
  EXPECT_NE(text.find("Galerkin and Ritz, assembled apart"), std::string::npos);
}

TEST(ResidualsCommand, DrawsEveryBasisAndTheOrders) {
  const std::string script = residual_plot_script(study_of("f = \"exp(x)\"\nn = [16, 32]\n"), "folder/it's");
  EXPECT_NE(script.find("set output 'folder/it''s-solutions.svg'"), std::string::npos);
  EXPECT_NE(script.find("set multiplot layout 2,3"), std::string::npos);
  EXPECT_NE(script.find("title 'hats galerkin: 2.0"), std::string::npos);
}

TEST(ResidualsCommand, LeavesItsFilesAndKeepsThem) {
  const TemporaryFolder folder;
  Options options;
  options.problem = folder / "load.toml";
  options.out = folder / "out";
  write_all(options.problem, "f = \"1\"\nn = [1, 2]\n");
  EXPECT_EQ(residuals(options), exit_done);
  EXPECT_TRUE(read_all(folder / "out/residuals.csv").find("\nload,sines,collocation-equal,1,") != std::string::npos);
  EXPECT_FALSE(read_all(folder / "out/coefficients.csv").empty());
  EXPECT_FALSE(read_all(folder / "out/load.gnuplot").empty());
  EXPECT_NE(error_of([&] { residuals(options); }).find("--overwrite"), std::string::npos);
  options.overwrite = true;
  EXPECT_EQ(residuals(options), exit_done);
}

TEST(ResidualsCommand, ShippedProblemsAreThoseOfTheLecture) {
  for (const char* const name : {"A", "B", "C0.1", "C0.01"}) {
    const ProblemFile file = read_problem(std::string(RITZ_SOURCE_DIR) + "/assets/lectures/problems/" + name + ".toml");
    EXPECT_EQ(file.name, name);
    EXPECT_FALSE(file.exact_is_computed());
  }
}

}  // namespace
}  // namespace app
