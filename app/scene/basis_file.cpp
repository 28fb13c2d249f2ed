#include "app/scene/basis_file.h"

#include <algorithm>
#include <cmath>

#include "app/base/number_bytes.h"

namespace app {
namespace {

constexpr std::string_view basis_magic = "RITZBASE";
constexpr std::uint32_t basis_format = 1;

void put_body(std::string& bytes, const sim::BasisVectors& vectors) {
  put(bytes, std::int64_t{vectors.modes});
  put(bytes, Eigen::VectorXd(vectors.U.reshaped()));
  put(bytes, std::int64_t{vectors.cubature.has_value()});
  if (!vectors.cubature) return;
  const sim::Cubature& cubature = *vectors.cubature;
  const auto count = std::ssize(cubature.elements);
  put(bytes, Eigen::VectorXd(Eigen::Map<const Eigen::VectorXi>(cubature.elements.data(), count).cast<double>()));
  put(bytes, Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(cubature.weights.data(), count)));
  put(bytes, cubature.error);
  put(bytes, std::int64_t{cubature.states});
}

// Numbers of elements, rising.
bool are_elements(const Eigen::VectorXd& numbers, int count) {
  for (Eigen::Index k = 0; k < numbers.size(); ++k) {
    const double least = k == 0 ? 0 : numbers[k - 1] + 1;
    if (!(numbers[k] >= least && numbers[k] < count && numbers[k] == std::floor(numbers[k]))) return false;
  }
  return numbers.size() > 0;
}

sim::Cubature take_cubature(ByteReader& reader, const sim::Body& body) {
  const Eigen::VectorXd elements = reader.vector(), weights = reader.vector();
  sim::Cubature cubature;
  cubature.error = reader.real();
  cubature.states = static_cast<int>(std::clamp<std::int64_t>(reader.integer(), 0, 1'000'000'000));
  const bool good = are_elements(elements, body.mesh.element_count()) && weights.size() == elements.size() &&
                    weights.allFinite() && weights.minCoeff() > 0 && std::isfinite(cubature.error) &&
                    cubature.error >= 0 && cubature.states > 0;
  if (!good) reader.fail("hold numbers that no cubature has");
  for (const double element : elements) cubature.elements.push_back(static_cast<int>(element));
  cubature.weights.assign(weights.begin(), weights.end());
  return cubature;
}

std::shared_ptr<const sim::BasisVectors> take_body(ByteReader& reader, const sim::Body& body, int dimension) {
  auto vectors = std::make_shared<sim::BasisVectors>();
  const std::int64_t modes = reader.integer();
  const Eigen::VectorXd U = reader.vector();
  const Eigen::Index rows = Eigen::Index{dimension} * body.mesh.node_count(), count = body.basis->count;
  if (U.size() != rows * count || !U.allFinite() || modes < 0 || modes > count)
    reader.fail("hold numbers that no basis of this body has");
  vectors->U = U.reshaped(rows, count);
  vectors->modes = static_cast<int>(modes);
  const std::int64_t has_cubature = reader.integer();
  if (has_cubature != (body.basis->cubature > 0 ? 1 : 0)) reader.fail("are of another cubature");
  if (has_cubature != 0) vectors->cubature = take_cubature(reader, body);
  return vectors;
}

}  // namespace

std::string encode(const KeptBases& bases, std::uint64_t key) {
  std::string bytes(basis_magic);
  put(bytes, basis_format);
  put(bytes, key);
  put(bytes, bases.seconds);
  put(bytes, static_cast<std::uint64_t>(bases.of_bodies.size()));
  for (const auto& vectors : bases.of_bodies) put_body(bytes, *vectors);
  put_checksum(bytes);
  return bytes;
}

KeptBases decode_bases(std::string_view bytes, std::uint64_t key, const sim::Scene& scene, const std::string& name) {
  ByteReader reader(bytes, name + ": the vectors");
  if (reader.take(basis_magic.size()) != basis_magic) reader.fail("do not begin with RITZBASE: no file of bases");
  if (reader.number<std::uint32_t>() != basis_format) reader.fail("are of another version of this program");
  if (reader.number<std::uint64_t>() != key) reader.fail("are of another scene");
  KeptBases bases;
  bases.seconds = reader.real();
  if (!(std::isfinite(bases.seconds) && bases.seconds >= 0)) reader.fail("hold a time that none is");
  if (reader.number<std::uint64_t>() != scene.bodies.size()) reader.fail("are of another number of bodies");
  for (const sim::Body& body : scene.bodies) bases.of_bodies.push_back(take_body(reader, body, scene.dimension));
  reader.take_checksum();
  return bases;
}

}  // namespace app
