#include "app/run/vtu.h"

#include <bit>
#include <cstdint>

#include "app/base/base64.h"
#include "app/base/number_text.h"
#include "sim/element/element.h"

namespace app {
namespace {

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      default:
        safe += c;
    }
  }
  return safe;
}

template <typename Number>
constexpr const char* vtk_type() {
  if constexpr (std::is_same_v<Number, double>) return "Float64";
  if constexpr (std::is_same_v<Number, std::int64_t>) return "Int64";
  if constexpr (std::is_same_v<Number, std::int32_t>) return "Int32";
  if constexpr (std::is_same_v<Number, std::uint8_t>) return "UInt8";
}

// <DataArray>: the byte count (UInt64) and the numbers, as one base64 text.
template <typename Number>
std::string data_array(const std::string& name, int components, const std::vector<Number>& numbers) {
  static_assert(std::endian::native == std::endian::little, "the header says LittleEndian");
  const std::uint64_t size = numbers.size() * sizeof(Number);
  std::string bytes(reinterpret_cast<const char*>(&size), sizeof size);
  bytes.append(reinterpret_cast<const char*>(numbers.data()), size);
  std::string text = "        <DataArray type=\"";
  text += vtk_type<Number>();
  text += "\" Name=\"" + name + "\" NumberOfComponents=\"" + std::to_string(components) + "\" format=\"binary\">";
  return text + base64(bytes) + "</DataArray>\n";
}

struct Cells {
  std::vector<std::int64_t> nodes, ends;  // nodes of all cells in a row; where each cell ends in it
  std::vector<std::uint8_t> types;
  std::vector<std::int32_t> bodies;
};

Cells cells_of(const sim::System& system) {
  Cells cells;
  std::int32_t number = 0;
  for (const sim::BodyRange& body : system.bodies()) {
    const Eigen::MatrixXi& elements = body.mesh->elements;
    for (Eigen::Index e = 0; e < elements.cols(); ++e) {
      for (const int node : elements.col(e)) cells.nodes.push_back(body.first_node + node);
      cells.ends.push_back(static_cast<std::int64_t>(cells.nodes.size()));
      cells.types.push_back(static_cast<std::uint8_t>(sim::info(body.mesh->kind).vtk));
      cells.bodies.push_back(number);
    }
    ++number;
  }
  return cells;
}

// Three numbers per node, the third zero in 2D.
std::vector<double> in_space(const Eigen::VectorXd& values, int dimension) {
  const Eigen::Index nodes = values.size() / dimension;
  std::vector<double> result(static_cast<std::size_t>(3 * nodes), 0.0);
  for (Eigen::Index node = 0; node < nodes; ++node) {
    for (int axis = 0; axis < dimension; ++axis) {
      result[static_cast<std::size_t>(3 * node + axis)] = values[dimension * node + axis];
    }
  }
  return result;
}

Eigen::VectorXd rest_positions(const sim::System& system) {
  Eigen::VectorXd rest(system.dimension() * system.counts().nodes);
  for (const sim::BodyRange& body : system.bodies()) {
    const Eigen::MatrixXd& X = body.mesh->X;
    rest.segment(system.dimension() * body.first_node, X.size()) = X.reshaped();
  }
  return rest;
}

std::string point_data(const sim::System& system, const sim::State& state) {
  const Eigen::VectorXd displacement = system.of_bodies(state.x) - rest_positions(system);
  const Eigen::VectorXd stress = system.node_values(state, sim::Quantity::stress);
  std::string text = "      <PointData Scalars=\"stress\" Vectors=\"displacement\">\n";
  text += data_array("displacement", 3, in_space(displacement, system.dimension()));
  text += data_array("velocity", 3, in_space(system.of_bodies(state.v), system.dimension()));
  text += data_array("stress", 1, std::vector<double>(stress.begin(), stress.end()));
  return text + "      </PointData>\n";
}

}  // namespace

std::string vtu_text(const sim::System& system, const sim::State& state) {
  const Cells cells = cells_of(system);
  std::string text =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
      "  <UnstructuredGrid>\n"
      "    <Piece NumberOfPoints=\"" +
      std::to_string(system.counts().nodes) + "\" NumberOfCells=\"" + std::to_string(cells.types.size()) + "\">\n";
  text += point_data(system, state);
  text += "      <CellData>\n" + data_array("body", 1, cells.bodies) + "      </CellData>\n";
  text += "      <Points>\n" + data_array("points", 3, in_space(system.of_bodies(state.x), system.dimension())) +
          "      </Points>\n";
  text += "      <Cells>\n" + data_array("connectivity", 1, cells.nodes) + data_array("offsets", 1, cells.ends) +
          data_array("types", 1, cells.types) + "      </Cells>\n";
  return text + "    </Piece>\n  </UnstructuredGrid>\n</VTKFile>\n";
}

std::string pvd_text(const std::vector<std::pair<double, std::string>>& files) {
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
      "  <Collection>\n";
  for (const auto& [time, name] : files) {
    text += "    <DataSet timestep=\"";
    append_number(text, time);
    text += "\" part=\"0\" file=\"" + escaped(name) + "\"/>\n";
  }
  return text + "  </Collection>\n</VTKFile>\n";
}

}  // namespace app
