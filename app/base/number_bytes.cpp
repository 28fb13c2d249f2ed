#include "app/base/number_bytes.h"

#include <stdexcept>

#include "sim/math/checksum.h"

namespace app {

void put(std::string& bytes, const Eigen::VectorXd& values) {
  put(bytes, static_cast<std::uint64_t>(values.size()));
  for (const double value : values) put(bytes, value);
}

void put_checksum(std::string& bytes) {
  put(bytes, sim::checksum(bytes));
}

std::string_view ByteReader::take(std::size_t count) {
  if (count > bytes_.size()) fail("is cut short");
  const std::string_view front = bytes_.substr(0, count);
  bytes_.remove_prefix(count);
  return front;
}

Eigen::VectorXd ByteReader::vector() {
  const auto length = number<std::uint64_t>();
  // Compared before anything is allocated: a damaged length may be anything.
  if (length > bytes_.size() / sizeof(double)) fail("is cut short");
  Eigen::VectorXd values(static_cast<Eigen::Index>(length));
  for (double& value : values) value = real();
  return values;
}

void ByteReader::take_checksum() {
  if (bytes_.size() != sizeof(std::uint64_t)) fail("has the wrong length");
  const std::uint64_t expected = sim::checksum(whole_.substr(0, whole_.size() - bytes_.size()));
  if (number<std::uint64_t>() != expected) fail("is damaged (wrong checksum)");
}

void ByteReader::fail(const std::string& why) const {
  throw std::runtime_error(what_ + " " + why);
}

}  // namespace app
