#include "app/run/csv.h"

#include <gtest/gtest.h>

#include "app/base/number_text.h"
#include "tests/app/temporary_folder.h"

namespace app {
namespace {

std::string text_of(double number) {
  std::string text;
  append_number(text, number);
  return text;
}

TEST(NumberText, ReadsBackAsTheSameNumberInFewDigits) {
  for (const double number : {1.0 / 3.0, -9.81, 1.7976931348623157e308, 2.2250738585072014e-308, 123456789.0}) {
    EXPECT_EQ(std::stod(text_of(number)), number) << text_of(number);
  }
  EXPECT_EQ(text_of(0.1), "0.1");
  EXPECT_EQ(text_of(-0.0), "-0");
  EXPECT_EQ(text_of(5e-324), "5e-324");
}

TEST(Csv, HeadersAreTheDocumentedColumns) {
  const std::vector<sim::Probe> probes = {{"tip", "beam", {0, 0, 0}}, {"root", "beam", {0, 0, 0}}};
  EXPECT_EQ(probes_header(probes, 3), "t,tip.ux,tip.uy,tip.uz,root.ux,root.uy,root.uz\n");
  EXPECT_EQ(probes_header(probes, 2), "t,tip.ux,tip.uy,root.ux,root.uy\n");
  EXPECT_EQ(probes_header({}, 3), "t\n");
  const std::string header = "step,t,kinetic,elastic,potential,px,py,pz,Lx,Ly,Lz,newton,linear,min_J,seconds";
  EXPECT_EQ(steps_header(false), header + "\n");
  EXPECT_EQ(steps_header(true), header + ",min_gap,contacts\n");
}

TEST(Csv, GoingOnCutsLaterRowsOff) {
  const TemporaryFolder folder;
  write_all(folder / "t.csv", "t,a\n0,1\n1,2\n2,3\n3,");
  Csv table(folder / "t.csv", "t,a\n", 2);
  table.row("2,30\n");
  table.close();
  EXPECT_EQ(read_all(folder / "t.csv"), "t,a\n0,1\n1,2\n2,30\n");
}

TEST(Csv, ARowWithoutItsEndDoesNotCount) {
  const TemporaryFolder folder;
  write_all(folder / "t.csv", "t,a\n0,1\n1,2");
  const std::string message = error_of([&] { Csv(folder / "t.csv", "t,a\n", 2); });
  EXPECT_NE(message.find("has 1 whole rows, the saved state needs 2"), std::string::npos) << message;
  EXPECT_EQ(read_all(folder / "t.csv"), "t,a\n0,1\n1,2");  // nothing is lost by the attempt
}

TEST(Csv, AnotherTableIsRefused) {
  const TemporaryFolder folder;
  write_all(folder / "t.csv", "t,b\n0,1\n");
  EXPECT_NE(error_of([&] { Csv(folder / "t.csv", "t,a\n", 1); }), "");
  EXPECT_NE(error_of([&] { Csv(folder / "absent.csv", "t,a\n", 1); }), "");
}

}  // namespace
}  // namespace app
