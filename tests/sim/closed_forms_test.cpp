// Stress and energy of homogeneous deformations against closed forms (tests/data/reference/closed_forms.csv).
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

#include "sim/material/list.h"

namespace sim {
namespace {

struct Row {
  std::string material, mode;
  double s, lateral, P, psi;
};

std::vector<Row> rows() {
  std::ifstream file(RITZ_SOURCE_DIR "/tests/data/reference/closed_forms.csv");
  std::vector<Row> all;
  std::string line;
  std::getline(file, line);
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::stringstream cells(line);
    Row row;
    std::getline(cells, row.material, ',');
    std::getline(cells, row.mode, ',');
    char comma;
    cells >> row.s >> comma >> row.lateral >> comma >> row.P >> comma >> row.psi;
    all.push_back(row);
  }
  return all;
}

// F of a row and the component of P that it gives.
Mat<double, 3, 3> deformation(const Row& row, int& i, int& j) {
  i = j = 0;
  auto F = Mat<double, 3, 3>::identity();
  if (row.mode.starts_with("simple_shear")) {
    F(0, 1) = row.s;
    i = row.mode[row.mode.size() - 2] - '1';
    j = row.mode[row.mode.size() - 1] - '1';
    return F;
  }
  const bool two = row.mode == "equibiaxial_stress", three = row.mode == "triaxial_strain";
  F(0, 0) = row.s;
  F(1, 1) = two || three ? row.s : row.lateral;
  F(2, 2) = three ? row.s : row.lateral;
  return F;
}

template <class Material>
void compare(const std::string& name) {
  const Material material(lame(1e6, 0.3, false), 3);
  int compared = 0;
  for (const Row& row : rows()) {
    if (row.material != name) continue;
    int i, j;
    const auto F = deformation(row, i, j);
    EXPECT_NEAR(material.P(F)(i, j), row.P, 1e-8 * std::abs(row.P) + 1e-2) << name << " " << row.mode << " " << row.s;
    EXPECT_NEAR(material.psi(F), row.psi, 1e-8 * row.psi + 1e-2) << name << " " << row.mode << " " << row.s;
    ++compared;
  }
  EXPECT_GT(compared, 20) << name;
}

TEST(ClosedForms, EveryMaterialReproducesThem) {
  compare<Linear>("linear");
  compare<Corotated>("corotated_linear");
  compare<StVK>("stvk");
  compare<FixedCorotated>("fixed_corotated");
  compare<NeoHookean>("neohookean_log");
  compare<StableNeoHookean>("stable_neohookean_smith2018");
}

}  // namespace
}  // namespace sim
