#include "app/run/csv.h"

#include <fstream>
#include <initializer_list>
#include <stdexcept>

#include "app/base/number_text.h"
#include "app/base/text.h"
#include "app/run/contact_totals.h"

namespace app {
namespace {

// A field with a comma, a quote or a line break is quoted.
std::string field(const std::string& text) {
  return text.find_first_of(",\"\r\n") == std::string::npos ? text : quoted_field(text);
}

template <typename Number>
void append_fields(std::string& line, std::initializer_list<Number> numbers) {
  for (const Number number : numbers) {
    if (!line.empty()) line += ',';
    append_number(line, number);
  }
}

// The header and the first `rows` rows of a table, as they are in the file.
std::string kept_part(const std::filesystem::path& path, const std::string& header, std::int64_t rows) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error(path.string() + ": cannot be read, so the run cannot go on from here");
  std::string line;
  std::getline(file, line);
  if (line + '\n' != header) {
    throw std::runtime_error(path.string() + ": has the columns " + line + ", the scene gives " + header);
  }
  std::string kept = header;
  for (std::int64_t row = 0; row < rows; ++row) {
    std::getline(file, line);
    if (file.eof() || !file) {  // a line without its end was cut short
      throw std::runtime_error(path.string() + ": has " + std::to_string(row) + " whole rows, the saved state needs " +
                               std::to_string(rows) + "; record again with --overwrite");
    }
    kept += line + '\n';
  }
  return kept;
}

OutputFile::Mode keep_rows(const std::filesystem::path& path, const std::string& header, std::int64_t rows) {
  write_atomically(path, kept_part(path, header, rows), true);
  return OutputFile::Mode::append;
}

}  // namespace

Csv::Csv(const std::filesystem::path& path, const std::string& header) : file_(path, OutputFile::Mode::create) {
  file_.write(header);
}

Csv::Csv(const std::filesystem::path& path, const std::string& header, std::int64_t rows)
    : file_(path, keep_rows(path, header, rows)) {}

std::string probes_header(const std::vector<sim::Probe>& probes, int dimension) {
  std::string header = "t";
  for (const sim::Probe& probe : probes) {
    for (int axis = 0; axis < dimension; ++axis) header += ',' + field(probe.name + ".u" + "xyz"[axis]);
  }
  return header + '\n';
}

std::string probes_row(const sim::System& system, const sim::State& state, int probe_count) {
  std::string line;
  append_fields(line, {system.time(state.step)});
  for (int probe = 0; probe < probe_count; ++probe) {
    const sim::Vec3 displacement = system.probe_displacement(state, probe);
    for (int axis = 0; axis < system.dimension(); ++axis) append_fields(line, {displacement[axis]});
  }
  return line + '\n';
}

std::string steps_header(bool with_contacts) {
  const std::string header = "step,t,kinetic,elastic,potential,px,py,pz,Lx,Ly,Lz,newton,linear,min_J,seconds";
  return header + (with_contacts ? ",min_gap,contacts\n" : "\n");
}

std::string steps_row(const sim::System& system, const sim::State& state, const sim::StepReport& report,
                      const std::vector<sim::ContactReport>& contacts) {
  const sim::Measures now = system.measure(state);
  std::string line;
  append_fields(line, {state.step});
  append_fields(line, {system.time(state.step), now.kinetic, now.elastic, now.potential, now.p.x(), now.p.y(),
                       now.p.z(), now.L.x(), now.L.y(), now.L.z()});
  append_fields(line, {report.newton, report.linear});
  append_fields(line, {report.min_J, report.seconds});
  if (contacts.empty()) return line + '\n';
  const ContactTotals totals = totals_of(contacts);
  append_fields(line, {totals.gap});
  append_fields(line, {totals.pairs});
  return line + '\n';
}

std::string contacts_header() {
  return "t,first,second,pairs,fx,fy,fz,frictionx,frictiony,frictionz,gap,area\n";
}

std::string contacts_rows(double t, const std::vector<sim::ContactReport>& contacts) {
  std::string rows;
  for (const sim::ContactReport& contact : contacts) {
    std::string line;
    append_fields(line, {t});
    line += ',' + field(contact.first) + ',' + field(contact.second);
    append_fields(line, {contact.pairs});
    append_fields(line, {contact.force.x(), contact.force.y(), contact.force.z(), contact.friction.x(),
                         contact.friction.y(), contact.friction.z(), contact.gap, contact.area});
    rows += line + '\n';
  }
  return rows;
}

}  // namespace app
