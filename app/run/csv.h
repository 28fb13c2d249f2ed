// probes.csv and steps.csv: one row per step, numbers that read back exactly. SI units.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "app/base/output_file.h"
#include "sim/report.h"
#include "sim/system.h"

namespace app {

// A table that grows by rows. Throws WriteError.
class Csv {
 public:
  // A new table with its header line.
  Csv(const std::filesystem::path& path, const std::string& header);
  // Goes on with a table of which the first `rows` rows stay and later ones are cut off. Throws std::runtime_error when
  // the header is another or when there are fewer rows.
  Csv(const std::filesystem::path& path, const std::string& header, std::int64_t rows);

  // A line with its end.
  void row(std::string_view line) { file_.write(line); }
  void sync() { file_.sync(); }
  void close() { file_.close(); }

 private:
  OutputFile file_;
};

// "t,tip.ux,tip.uy,tip.uz": displacements [m] of the probes; two per probe in 2D.
std::string probes_header(const std::vector<sim::Probe>& probes, int dimension);
std::string probes_row(const sim::System& system, const sim::State& state, int probe_count);

// "step,t,kinetic,elastic,potential,px,py,pz,Lx,Ly,Lz,newton,linear,min_J,seconds"
// With min_gap [m] and contacts (pairs that push) at the end where the scene has any [[contact]].
std::string steps_header(bool with_contacts);
std::string steps_row(const sim::System& system, const sim::State& state, const sim::StepReport& report,
                      const std::vector<sim::ContactReport>& contacts);

// "t,first,second,pairs,fx,fy,fz,frictionx,frictiony,frictionz,gap,area": for each pair that may touch, forces on the
// first [N], least gap [m]. A row for each.
std::string contacts_header();
std::string contacts_rows(double t, const std::vector<sim::ContactReport>& contacts);

}  // namespace app
