#include "app/run/state_file.h"

#include <cmath>
#include <fstream>
#include <stdexcept>

#include "app/base/number_bytes.h"
#include "app/base/output_file.h"

namespace app {
namespace {

constexpr std::string_view magic = "RITZSTAT";
// Of states of nodes alone, and of those that have coordinates in a basis as well.
constexpr std::uint32_t format = 7, format_with_coordinates = 8;

void take_field(ByteReader& reader, Eigen::VectorXd& values) {
  values = reader.vector();
}
void take_field(ByteReader& reader, std::int64_t& value) {
  value = reader.integer();
}
void take_field(ByteReader& reader, double& value) {
  value = reader.real();
}

bool plausible(const sim::Coordinates& coordinates) {
  bool good = true;
  for_each_coordinate_field(coordinates, [&](const Eigen::VectorXd& field) {
    good = good && field.allFinite() && (field.size() == 0 || field.size() == coordinates.c.size());
  });
  return good && coordinates.rate.size() == coordinates.c.size();
}

bool plausible(const sim::State& state) {
  bool good = state.step >= 0 && state.parts >= 1 && state.v.size() == state.x.size() &&
              std::abs(state.kept.definiteness) <= 1 && state.kept.what >= 0 &&
              state.kept.what <= static_cast<int>(sim::Kept::coarse) && plausible(state.coordinates);
  // The fastest vibration is that of what moves: of the coordinates, where there are some.
  const auto moving = [&](const Eigen::VectorXd& field) {
    return (&field == &state.fastest && state.coordinates.c.size() > 0 ? state.coordinates.c : state.x).size();
  };
  for_each_nodal_field(state, [&](const auto& field) {
    if constexpr (requires { field.allFinite(); })
      good = good && field.allFinite() && (field.size() == 0 || field.size() == moving(field));
    else
      good = good && std::isfinite(static_cast<double>(field));
  });
  // What is held was made somewhere.
  return good && (state.kept.what == 0 ||
                  (state.kept.x.size() == state.x.size() && state.kept.v.size() == state.x.size() &&
                   state.kept.x_begin.size() == state.x.size() && state.kept.v_begin.size() == state.x.size()));
}

}  // namespace

std::string encode(const SavedRun& run) {
  const sim::State& state = run.state;
  std::string bytes(magic);
  const bool reduced = state.coordinates.c.size() > 0;
  put(bytes, reduced ? format_with_coordinates : format);
  put(bytes, run.scene);
  for (const std::int64_t count : {run.totals.newton, run.totals.linear, run.totals.not_converged, run.totals.splits})
    put(bytes, count);
  put(bytes, run.totals.min_J);
  for (const double value : run.totals.largest) put(bytes, value);
  const auto put_it = [&](const auto& field) { put(bytes, field); };
  for_each_nodal_field(state, put_it);
  if (reduced) for_each_coordinate_field(state.coordinates, put_it);
  put_checksum(bytes);
  return bytes;
}

SavedRun decode(std::string_view bytes, const std::string& name) {
  ByteReader reader(bytes, name + ": the saved state");
  if (reader.take(magic.size()) != magic) reader.fail("does not begin with RITZSTAT: not a state file");
  const auto version = reader.number<std::uint32_t>();
  if (version != format && version != format_with_coordinates) {
    reader.fail("has version " + std::to_string(version) + ", this program reads " + std::to_string(format) + " and " +
                std::to_string(format_with_coordinates));
  }
  SavedRun run;
  run.scene = reader.number<std::uint64_t>();
  for (std::int64_t* count : {&run.totals.newton, &run.totals.linear, &run.totals.not_converged, &run.totals.splits}) {
    *count = reader.integer();
  }
  run.totals.min_J = reader.real();
  for (double& value : run.totals.largest) value = reader.real();
  const auto take_it = [&](auto& field) { take_field(reader, field); };
  for_each_nodal_field(run.state, take_it);
  if (version == format_with_coordinates) for_each_coordinate_field(run.state.coordinates, take_it);
  reader.take_checksum();
  if (!plausible(run.state)) reader.fail("holds numbers that no run leaves");
  return run;
}

void write_state_file(const std::filesystem::path& path, const SavedRun& run) {
  write_atomically(path, encode(run), true);
}

SavedRun read_state_file(const std::filesystem::path& path) {
  if (!std::filesystem::is_regular_file(path)) throw std::runtime_error(path.string() + ": no saved state there");
  std::ifstream file(path, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (file.bad() || !file.is_open()) throw std::runtime_error(path.string() + ": the saved state cannot be read");
  return decode(bytes, path.string());
}

}  // namespace app
