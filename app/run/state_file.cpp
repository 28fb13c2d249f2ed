#include "app/run/state_file.h"

#include <bit>
#include <cmath>
#include <fstream>
#include <stdexcept>

#include "app/base/output_file.h"
#include "sim/math/checksum.h"

namespace app {
namespace {

constexpr std::string_view magic = "RITZSTAT";
// Of states of nodes alone, and of those that have coordinates in a basis as well.
constexpr std::uint32_t format = 7, format_with_coordinates = 8;
constexpr std::size_t checksum_bytes = 8;

template <typename Unsigned>
void put(std::string& bytes, Unsigned value) {
  for (std::size_t i = 0; i < sizeof(Unsigned); ++i) bytes.push_back(static_cast<char>((value >> (8 * i)) & 0xff));
}

void put(std::string& bytes, double value) {
  put(bytes, std::bit_cast<std::uint64_t>(value));
}
void put(std::string& bytes, std::int64_t value) {
  put(bytes, static_cast<std::uint64_t>(value));
}

void put(std::string& bytes, const Eigen::VectorXd& values) {
  for (const double value : values) put(bytes, value);
}

// Takes numbers from the front of some bytes.
class Reader {
 public:
  Reader(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {}

  std::string_view take(std::size_t count) {
    if (count > bytes_.size()) fail("is cut short");
    const std::string_view front = bytes_.substr(0, count);
    bytes_.remove_prefix(count);
    return front;
  }

  template <typename Unsigned>
  Unsigned number() {
    Unsigned value = 0;
    int shift = 0;
    for (const char byte : take(sizeof(Unsigned))) {
      value |= static_cast<Unsigned>(static_cast<unsigned char>(byte)) << shift;
      shift += 8;
    }
    return value;
  }

  std::int64_t integer() { return static_cast<std::int64_t>(number<std::uint64_t>()); }
  double real() { return std::bit_cast<double>(number<std::uint64_t>()); }

  Eigen::VectorXd vector(std::uint64_t length) {
    // Compared before anything is allocated: a damaged length may be anything.
    if (length > bytes_.size() / sizeof(double)) fail("is cut short");
    Eigen::VectorXd values(static_cast<Eigen::Index>(length));
    for (double& value : values) value = real();
    return values;
  }

  std::size_t left() const { return bytes_.size(); }

  [[noreturn]] void fail(const std::string& why) const { throw std::runtime_error(name_ + ": the saved state " + why); }

 private:
  std::string_view bytes_;
  std::string name_;
};

// One field of a state: how it is written, how it is read.
void put_field(std::string& bytes, const Eigen::VectorXd& values) {
  put(bytes, static_cast<std::uint64_t>(values.size()));
  put(bytes, values);
}
void put_field(std::string& bytes, std::int64_t value) {
  put(bytes, value);
}
void put_field(std::string& bytes, double value) {
  put(bytes, value);
}
void take_field(Reader& reader, Eigen::VectorXd& values) {
  values = reader.vector(reader.number<std::uint64_t>());
}
void take_field(Reader& reader, std::int64_t& value) {
  value = reader.integer();
}
void take_field(Reader& reader, double& value) {
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
  for_each_nodal_field(state, [&](const auto& field) {
    if constexpr (requires { field.allFinite(); })
      good = good && field.allFinite() && (field.size() == 0 || field.size() == state.x.size());
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
  const auto put_it = [&](const auto& field) { put_field(bytes, field); };
  for_each_nodal_field(state, put_it);
  if (reduced) for_each_coordinate_field(state.coordinates, put_it);
  put(bytes, sim::checksum(bytes));
  return bytes;
}

SavedRun decode(std::string_view bytes, const std::string& name) {
  Reader reader(bytes, name);
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
  if (reader.left() != checksum_bytes) reader.fail("has the wrong length");
  const std::uint64_t expected = sim::checksum(bytes.substr(0, bytes.size() - checksum_bytes));
  if (reader.number<std::uint64_t>() != expected) reader.fail("is damaged (wrong checksum)");
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
