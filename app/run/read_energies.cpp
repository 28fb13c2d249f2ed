#include "app/run/read_energies.h"

#include <cstdlib>
#include <fstream>
#include <string>

#include "app/picture/energies.h"

namespace app {
namespace {

// "step,t,kinetic,elastic,potential,..."
Energies from_row(const std::string& row, std::int64_t& step) {
  const char* at = row.c_str();
  char* end = nullptr;
  const auto next = [&] {
    const double number = std::strtod(at, &end);
    at = *end == ',' ? end + 1 : end;
    return number;
  };
  step = static_cast<std::int64_t>(next());
  Energies now;
  for (double* number : {&now.t, &now.kinetic, &now.elastic, &now.potential}) *number = next();
  return now;
}

}  // namespace

std::vector<Energies> read_energies(const std::filesystem::path& steps_csv, const sim::System& system,
                                    std::int64_t last_step) {
  std::vector<Energies> energies = {energies_of(system, system.initial_state())};
  std::ifstream file(steps_csv);
  std::string row;
  std::getline(file, row);
  while (std::getline(file, row)) {
    std::int64_t step = 0;
    const Energies now = from_row(row, step);
    if (step > last_step) break;
    if (step % system.steps_per_frame() == 0) energies.push_back(now);
  }
  return energies;
}

}  // namespace app
