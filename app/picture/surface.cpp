#include "app/picture/surface.h"

#include <algorithm>
#include <array>
#include <map>
#include <span>
#include <utility>

#include "sim/element/edge3.h"
#include "sim/element/element.h"
#include "sim/element/tri6.h"
#include "sim/mesh/boundary.h"

namespace app {
namespace {

// Pieces per edge of a quadratic facet: fewer where there are many facets, which then are small on the screen.
int pieces_per_edge(const sim::Mesh& mesh, Eigen::Index facets) {
  if (sim::info(mesh.kind).order == 1) return 1;
  return facets > 2000 ? 2 : 4;
}

}  // namespace

class Surface::Builder {
 public:
  Builder(Surface& surface, int node_count, int pieces) : surface_(surface), pieces_(pieces) {
    surface_.vertex_of_node_.assign(static_cast<std::size_t>(node_count), -1);
  }

  void add_facet(std::span<const int> nodes) {
    if (nodes.size() == 4) {
      add_quad(nodes);
    } else {
      add_lattice(nodes);
    }
  }

  // An edge of the rim: two ends, then the middle where there is one.
  void add_rim(std::span<const int> nodes) {
    append_pairs(nodes.size() == 3 ? line(nodes[0], nodes[1], nodes[2]) : line(nodes[0], nodes[1]), surface_.outline_);
  }

  void add_edges() {
    for (const auto& [ends, vertices] : lines_) append_pairs(vertices, surface_.edges_);
  }

 private:
  using Line = std::vector<int>;  // vertices along an element edge

  int add_vertex(std::span<const int> nodes, std::span<const double> weights) {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (weights[i] == 0) continue;
      surface_.nodes_.push_back(nodes[i]);
      surface_.weights_.push_back(weights[i]);
    }
    surface_.starts_.push_back(static_cast<int>(surface_.nodes_.size()));
    return surface_.vertex_count() - 1;
  }

  int node_vertex(int node) {
    int& vertex = surface_.vertex_of_node_[static_cast<std::size_t>(node)];
    if (vertex < 0) vertex = add_vertex(std::array{node}, std::array{1.0});
    return vertex;
  }

  // The vertices from node a to node b; made once for the facets that share the edge. middle = -1: a straight edge.
  Line line(int a, int b, int middle = -1) {
    const bool turned = a > b;
    const auto [place, is_new] = lines_.try_emplace(std::minmax(a, b));
    Line& stored = place->second;
    if (is_new) {
      const int low = std::min(a, b), high = std::max(a, b);
      stored.push_back(node_vertex(low));
      for (int i = 1; middle >= 0 && i < pieces_; ++i) {
        const double xi = -1.0 + 2.0 * i / pieces_;
        stored.push_back(add_vertex(std::array{low, high, middle}, sim::Edge3::N({xi})));
      }
      stored.push_back(node_vertex(high));
    }
    return turned ? Line(stored.rbegin(), stored.rend()) : stored;
  }

  void add_triangle(int a, int b, int c) {
    for (const int vertex : {a, b, c}) surface_.triangles_.push_back(static_cast<std::uint32_t>(vertex));
  }

  void add_quad(std::span<const int> nodes) {
    std::array<int, 4> corner{};
    for (std::size_t i = 0; i < 4; ++i) corner[i] = line(nodes[i], nodes[(i + 1) % 4]).front();
    add_triangle(corner[0], corner[1], corner[2]);
    add_triangle(corner[0], corner[2], corner[3]);
  }

  // A triangle of three or six nodes: a lattice of vertices (i, j), i steps from corner 0 towards 1 and j towards 2.
  void add_lattice(std::span<const int> nodes) {
    const auto middle = [&](std::size_t k) { return nodes.size() == 6 ? nodes[3 + k] : -1; };
    const Line side01 = line(nodes[0], nodes[1], middle(0));
    const Line side12 = line(nodes[1], nodes[2], middle(1));
    const Line side02 = line(nodes[0], nodes[2], middle(2));
    std::vector<Line> lattice(static_cast<std::size_t>(pieces_) + 1);
    for (int i = 0; i <= pieces_; ++i) {
      for (int j = 0; i + j <= pieces_; ++j) {
        int vertex = 0;
        if (j == 0) {
          vertex = side01[static_cast<std::size_t>(i)];
        } else if (i == 0) {
          vertex = side02[static_cast<std::size_t>(j)];
        } else if (i + j == pieces_) {
          vertex = side12[static_cast<std::size_t>(j)];
        } else {
          vertex = add_vertex(nodes, sim::Tri6::N({double(i) / pieces_, double(j) / pieces_}));
        }
        lattice[static_cast<std::size_t>(i)].push_back(vertex);
      }
    }
    for (std::size_t i = 0; i + 1 < lattice.size(); ++i) {
      const Line& row = lattice[i];
      const Line& next = lattice[i + 1];
      for (std::size_t j = 0; j < next.size(); ++j) {
        add_triangle(row[j], next[j], row[j + 1]);
        if (j + 1 < next.size()) add_triangle(next[j], next[j + 1], row[j + 1]);
      }
    }
  }

  static void append_pairs(const Line& vertices, std::vector<std::uint32_t>& pairs) {
    for (std::size_t i = 0; i + 1 < vertices.size(); ++i) {
      pairs.push_back(static_cast<std::uint32_t>(vertices[i]));
      pairs.push_back(static_cast<std::uint32_t>(vertices[i + 1]));
    }
  }

  Surface& surface_;
  std::map<std::pair<int, int>, Line> lines_;
  int pieces_;
};

Surface::Surface(const sim::Mesh& mesh) {
  const Eigen::MatrixXi facets = sim::surface_facets(mesh);
  linear_ = pieces_per_edge(mesh, facets.cols()) == 1;
  Builder builder(*this, mesh.node_count(), pieces_per_edge(mesh, facets.cols()));
  for (Eigen::Index f = 0; f < facets.cols(); ++f) {
    builder.add_facet({facets.col(f).data(), static_cast<std::size_t>(facets.rows())});
  }
  builder.add_edges();
  if (mesh.dimension() != 2) return;
  const Eigen::MatrixXi rim = sim::boundary_facets(mesh);
  for (Eigen::Index f = 0; f < rim.cols(); ++f) {
    builder.add_rim({rim.col(f).data(), static_cast<std::size_t>(rim.rows())});
  }
}

Surface::Surface(const sim::Mesh& mesh, const Skin& skin) {
  constexpr Eigen::Index few = 4000;  // triangles: more of them are round enough
  linear_ = skin.triangles.cols() <= few;
  vertex_of_node_.assign(static_cast<std::size_t>(mesh.node_count()), -1);
  std::vector<double> most(vertex_of_node_.size(), 0);  // by node: its weight in the vertex that it moves most
  for (const sim::MaterialPoint& point : skin.points) {
    for (std::size_t i = 0; i < point.weights.size(); ++i) {
      const int node = mesh.elements(static_cast<Eigen::Index>(i), point.element);
      nodes_.push_back(node);
      weights_.push_back(point.weights[i]);
      if (point.weights[i] <= most[static_cast<std::size_t>(node)]) continue;
      most[static_cast<std::size_t>(node)] = point.weights[i];
      vertex_of_node_[static_cast<std::size_t>(node)] = vertex_count();
    }
    starts_.push_back(static_cast<int>(nodes_.size()));
  }
  for (const auto& t : skin.triangles.colwise()) {
    for (int k = 0; k < 3; ++k) {
      triangles_.push_back(static_cast<std::uint32_t>(t[k]));
      const int next = t[(k + 1) % 3];
      if (t[k] > next) continue;  // the other triangle of the edge draws it
      edges_.push_back(static_cast<std::uint32_t>(t[k]));
      edges_.push_back(static_cast<std::uint32_t>(next));
    }
  }
}

int Surface::vertex_of(int node) const {
  const bool known = node >= 0 && node < static_cast<int>(vertex_of_node_.size());
  return known ? vertex_of_node_[static_cast<std::size_t>(node)] : -1;
}

std::vector<float> Surface::points(const Eigen::Ref<const Eigen::MatrixXd>& positions,
                                   const Eigen::Vector3d& origin) const {
  std::vector<float> result;
  result.reserve(3 * static_cast<std::size_t>(vertex_count()));
  for (int vertex = 0; vertex < vertex_count(); ++vertex) {
    Eigen::Vector3d point = Eigen::Vector3d::Zero();
    const auto v = static_cast<std::size_t>(vertex);
    for (int k = starts_[v]; k < starts_[v + 1]; ++k) {
      const auto i = static_cast<std::size_t>(k);
      point.head(positions.rows()) += weights_[i] * positions.col(nodes_[i]);
    }
    point.head(positions.rows()) -= origin.head(positions.rows());
    for (const double coordinate : point) result.push_back(static_cast<float>(coordinate));
  }
  return result;
}

std::vector<float> Surface::values(const Eigen::Ref<const Eigen::VectorXd>& node_values) const {
  std::vector<float> result;
  result.reserve(static_cast<std::size_t>(vertex_count()));
  for (int vertex = 0; vertex < vertex_count(); ++vertex) {
    double value = 0;
    const auto v = static_cast<std::size_t>(vertex);
    for (int k = starts_[v]; k < starts_[v + 1]; ++k) {
      const auto i = static_cast<std::size_t>(k);
      value += weights_[i] * node_values[nodes_[i]];
    }
    result.push_back(static_cast<float>(value));
  }
  return result;
}

}  // namespace app
