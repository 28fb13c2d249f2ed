#include "sim/body/start.h"

#include <Eigen/Geometry>
#include <numbers>

#include "sim/body/random.h"
#include "sim/element/element.h"
#include "sim/mesh/input_error.h"

namespace sim {

// What a shape is made from. `direction` has unit length; `low`, `high`: corners of the rest bounding box.
struct StartMaking {
  const Mesh& mesh;
  const Start& start;
  int D;  // dimensions of the scene
  double amount;
  Vec3 direction;
  Vec3 low, high;
  double size;
  Random random;
  Eigen::Matrix3Xd x;  // in: rest positions; out: the start

  Vec3 centre() const { return (low + high) / 2; }
};

namespace {

void keep(StartMaking&) {}

// Every node anywhere in the box, which is `amount` times the rest bounding box.
void scramble(StartMaking& m) {
  for (int i = 0; i < m.x.cols(); ++i)
    for (int c = 0; c < 3; ++c) {
      const double half = m.amount * (m.high[c] - m.low[c]) / 2;
      m.x(c, i) = m.centre()[c] + m.random.uniform(-half, half);
    }
}

// Lengths along the direction times `factor`.
void scale_along(StartMaking& m, double factor) {
  for (auto x : m.x.colwise()) x += (factor - 1) * m.direction.dot(x - m.centre()) * m.direction;
}
void scale(StartMaking& m) {
  scale_along(m, m.amount);
}
void mirror(StartMaking& m) {
  scale_along(m, -m.amount);
}
void flatten(StartMaking& m) {
  scale_along(m, 0);
}
void to_line(StartMaking& m) {
  for (auto x : m.x.colwise()) x = m.centre() + m.direction.dot(x - m.centre()) * m.direction;
}
void to_point(StartMaking& m) {
  for (auto x : m.x.colwise()) x = m.centre();
}

// Ends turned against each other by `amount` degrees about the direction; in the plane the rim against the centre.
void twist(StartMaking& m) {
  const bool plane = m.mesh.dimension() == 2;
  const double length = plane ? m.size / 2 : m.direction.cwiseAbs().dot(m.high - m.low);
  for (auto x : m.x.colwise()) {
    const Vec3 arm = x - m.centre();
    const double share = plane ? arm.norm() / length : m.direction.dot(arm) / length;
    const double angle = share * m.amount * std::numbers::pi / 180;
    x = m.centre() + Eigen::AngleAxisd(angle, plane ? Vec3(Vec3::UnitZ()) : m.direction) * arm;
  }
}

void move_away(StartMaking& m) {
  for (auto x : m.x.colwise()) x += m.amount * m.size * m.direction;
}

// The corner of one element in the middle of the body goes through the middle of the element's other corners, to
// `amount` times its distance on their other side; middle nodes of edges follow.
void invert_one(StartMaking& m) {
  const ElementInfo& element = info(m.mesh.kind);
  int chosen = 0;
  double nearest = -1;
  for (int e = 0; e < m.mesh.element_count(); ++e) {
    Vec3 middle = Vec3::Zero();
    for (int a = 0; a < element.corners; ++a) middle += m.x.col(m.mesh.elements(a, e)) / element.corners;
    const double distance = (middle - m.centre()).norm();
    if (nearest < 0 || distance < nearest) {
      nearest = distance;
      chosen = e;
    }
  }
  const int moved = m.mesh.elements(0, chosen);
  Vec3 others = Vec3::Zero();
  for (int a = 1; a < element.corners; ++a) others += m.x.col(m.mesh.elements(a, chosen)) / (element.corners - 1);
  m.x.col(moved) = others - m.amount * (m.x.col(moved) - others);
  for (int e = 0; e < m.mesh.element_count(); ++e)
    for (const auto& [a, b, middle] : element.edges) {
      const int i = m.mesh.elements(a, e), j = m.mesh.elements(b, e);
      if (middle >= 0 && (i == moved || j == moved))
        m.x.col(m.mesh.elements(middle, e)) = (m.x.col(i) + m.x.col(j)) / 2;
    }
}

// x = A X about the origin.
void map_affinely(StartMaking& m) {
  if (m.start.matrix.size() != static_cast<std::size_t>(m.D * m.D))
    throw InputError("start.matrix", "must have " + std::to_string(m.D) + " rows of " + std::to_string(m.D) +
                                         " numbers: the map x = A X of shape = \"affine\"");
  const Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>> A(
      m.start.matrix.data(), m.D, m.D);
  m.x.topRows(m.D) = A * Eigen::MatrixXd(m.x.topRows(m.D));
}

void place(StartMaking& m) {
  if (static_cast<Eigen::Index>(m.start.nodes.size()) != m.x.cols())
    throw InputError("start.nodes", "there are " + std::to_string(m.start.nodes.size()) +
                                        " positions, and the mesh has " + std::to_string(m.x.cols()) + " nodes");
  for (int i = 0; i < m.x.cols(); ++i) m.x.col(i) = m.start.nodes[static_cast<std::size_t>(i)];
}

constexpr std::string_view longest = "longest", thinnest = "thinnest";

constexpr double flat = 1e-3;  // of the size: leaves the plane, line or point in which symmetry would keep a body
constexpr StartShape table[] = {
    {"rest", 1, 0, "", "as the mesh is", keep},
    {"scrambled", 1, 0, "", "every node anywhere in the rest box times amount", scramble},
    {"plane", 1, flat, thinnest, "flattened into a plane", flatten},
    {"line", 1, flat, longest, "drawn onto a line", to_line},
    {"point", 1, flat, "", "all nodes in one point", to_point},
    {"mirrored", 1, 0, longest, "mirrored and stretched amount times, J = -amount", mirror},
    {"inverted", 1, 0, "", "one corner pushed through its element, amount times as far", invert_one},
    {"twisted", 360, 0, longest, "end turned against end by amount degrees", twist},
    {"stretched", 10, 0, longest, "amount times as long", scale},
    {"squashed", 0.01, 0, thinnest, "to amount times the thickness", scale},
    {"far", 1e6, 0, longest, "amount body sizes away", move_away},
    {"affine", 1, 0, "", "by the map x = A X of matrix", map_affinely, true},
    {"nodes", 1, 0, "", "where nodes, or file, says", place, true},
    {"mode", 0.1, 0, "", "in vibration mode number mode, its largest displacement amount metres", place, true},
};

// The axis along which the rest bounding box is longest, or shortest but not flat.
Vec3 default_direction(std::string_view along, const Vec3& extent) {
  int best = 0;
  for (int c = 1; c < 3; ++c) {
    const bool better = along == thinnest ? extent[c] > 0 && extent[c] < extent[best] : extent[c] > extent[best];
    if (better) best = c;
  }
  return Vec3::Unit(best);
}

}  // namespace

std::span<const StartShape> start_shapes() {
  return table;
}

const StartShape* find_start_shape(std::string_view name) {
  for (const StartShape& shape : table)
    if (shape.name == name) return &shape;
  return nullptr;
}

Eigen::MatrixXd start_positions(const Mesh& mesh, const Start& start, int D, std::uint64_t seed) {
  const StartShape* shape = find_start_shape(start.shape);
  if (!shape) throw InputError("start.shape", "\"" + start.shape + "\" is not a start");
  StartMaking m{mesh, start, D, start.amount.value_or(shape->amount), {}, {}, {}, 0, Random(seed), {}};
  m.x = Eigen::Matrix3Xd::Zero(3, mesh.node_count());
  m.x.topRows(mesh.dimension()) = mesh.X;
  m.low = m.x.rowwise().minCoeff();
  m.high = m.x.rowwise().maxCoeff();
  m.size = (m.high - m.low).maxCoeff();
  m.direction = start.direction.value_or(default_direction(shape->along, m.high - m.low)).normalized();
  shape->make(m);
  const double amplitude = start.perturbation.value_or(shape->perturbation) * m.size;
  for (auto x : m.x.colwise())
    for (int c = 0; c < 3; ++c) x[c] += amplitude * m.random.uniform(-1, 1);
  return m.x.topRows(D);
}

}  // namespace sim
