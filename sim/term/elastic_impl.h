// The elastic term as a template on element, dimension and material; included only by the files elastic_*.cpp.
#pragma once

#include "sim/element/list.h"
#include "sim/material/list.h"
#include "sim/math/volume.h"
#include "sim/scene.h"
#include "sim/term/build_batches.h"
#include "sim/term/elastic.h"
#include "sim/term/stress.h"

namespace sim {

template <class Material>
concept NeedsRestFrame = requires {
  Material::in_rest_frame;
};

// What does not depend on the material: K p, K, its diagonal, J, from the tangents in the store.
template <class Element, int D>
class ElasticBlock : public ElasticTerm {
 protected:
  static constexpr int N = Element::nodes, M = Element::dimension, Q = static_cast<int>(Element::rule.size());
  using Elements = ElementBatches<Element, D>;
  using Point = Tangent<Lanes, D, M>;

  struct Tangents : Store {
    LargeArray<Point> tangent;   // [batch][Q]
    LargeArray<Lanes> energies;  // [batch]; J in smallest_J
  };
  static Tangents& own(Store& store) { return static_cast<Tangents&>(store); }
  static const Tangents& own(const Store& store) { return static_cast<const Tangents&>(store); }

  Elements elements_;
  int first_node_ = 0;

 public:
  std::unique_ptr<Store> make_store(int threads) const override {
    auto store = std::make_unique<Tangents>();
    store->threads = threads;
    store->energies.resize(elements_.batch_count());
    return store;
  }

  void couple(Coupling& coupling) const override {
    elements_.for_each_element([&](std::span<const int> nodes) { coupling.add(nodes); });
  }
  void bind(const BlockPattern& pattern) override { elements_.bind(pattern); }

  // df = w dP G^T, dP = (dP/dF) (dx_e G)
  void add_product(const Store& store, double scale, const Eigen::VectorXd& p, Eigen::VectorXd& y) const override {
    const Tangents& s = own(store);
    elements_.chunks->for_each_batch(s.threads, [&](int batch) {
      Lanes dx[N - 1][D], df[N - 1][D] = {};
      elements_.gather(batch, p.data(), dx);
      for (int q = 0; q < Q; ++q) {
        const Lanes* G = elements_.G(batch, q);
        const Mat<Lanes, D, M> dP = apply(s.tangent[batch * Q + q], Elements::deformation(dx, G));
        Elements::accumulate(dP, G, Lanes(scale) * elements_.w(batch, q), df);
      }
      elements_.scatter(batch, df, y.data());
    });
  }

  void add_matrix(const Store& store, double scale, BlockMatrix& A) const override {
    const Tangents& s = own(store);
    elements_.chunks->for_each_batch(s.threads, [&](int batch) { add_batch(s, scale, batch, A); });
  }

  void add_diagonal(const Store& store, double scale, Eigen::VectorXd& d) const override {
    const Tangents& s = own(store);
    elements_.chunks->for_each_batch(s.threads, [&](int batch) {
      Mat<Lanes, D, D> K[N][N];
      stiffness(s, scale, batch, K);
      const int* n = elements_.nodes(batch);
      const int lanes = elements_.lanes_in(batch);
      for (int a = 0; a < N; ++a)
        for (int c = 0; c < D; ++c)
          for (int k = 0; k < lanes; ++k) d[n[a * lane_count + k] * D + c] += K[a][a](c, c)[k];
    });
  }

  double volume() const override {
    double sum = 0;
    for (const Lanes& w : elements_.weight)
      for (int k = 0; k < lane_count; ++k) sum += w[k];
    return sum;
  }
  std::int64_t bytes() const override {
    const std::size_t points = elements_.weight.size();
    return static_cast<std::int64_t>(points * (sizeof(Point) + ((N - 1) * M + 1) * sizeof(Lanes)) +
                                     (elements_.node.size() + elements_.slot.size()) * sizeof(int));
  }

  SmallestJ smallest_J(const Eigen::VectorXd& x, Store& store) const override {
    Tangents& s = own(store);
    elements_.chunks->for_each_batch(s.threads, [&](int batch) {
      Lanes x_e[N - 1][D];
      elements_.gather(batch, x.data(), x_e);
      Lanes least = volume_ratio(Elements::deformation(x_e, elements_.G(batch, 0)));
      for (int q = 1; q < Q; ++q) {
        const Lanes J = volume_ratio(Elements::deformation(x_e, elements_.G(batch, q)));
        least = select(J < least, J, least);
      }
      s.energies[batch] = least;
    });
    SmallestJ r{std::numeric_limits<double>::infinity(), -1, 0};
    for (int e = 0; e < elements_.count; ++e) {
      const double J = s.energies[e / lane_count][e % lane_count];
      if (!(J > 0)) ++r.inverted;
      if (!(J >= r.J)) r = {J, elements_.element[e], r.inverted};
      if (std::isnan(J)) break;
    }
    return r;
  }

 private:
  // K_ab = sum_q w G_a (dP/dF) G_b; the row and column of node 0 follow from sum_a G_a = 0. Only a <= b is filled.
  void stiffness(const Tangents& s, double scale, int batch, Mat<Lanes, D, D> (&K)[N][N]) const {
    for (int a = 1; a < N; ++a)
      for (int b = a; b < N; ++b) K[a][b] = Mat<Lanes, D, D>::zero();
    for (int q = 0; q < Q; ++q) {
      const Point& t = s.tangent[batch * Q + q];
      const Lanes *G = elements_.G(batch, q), w = Lanes(scale) * elements_.w(batch, q);
      Lanes r[N][M], wr[N][M];  // V^T G, and w times it
      for (int a = 1; a < N; ++a)
        for (int m = 0; m < M; ++m) {
          Lanes sum = t.V(0, m) * G[(a - 1) * M];
          for (int k = 1; k < M; ++k) sum += t.V(k, m) * G[(a - 1) * M + k];
          r[a][m] = sum;
          wr[a][m] = w * sum;
        }
      for (int a = 1; a < N; ++a)
        for (int b = a; b < N; ++b) K[a][b] = K[a][b] + stiffness_block<Lanes, D, M>(t, wr[a], r[b]);
    }
    K[0][0] = Mat<Lanes, D, D>::zero();
    for (int b = 1; b < N; ++b) {
      Mat<Lanes, D, D> sum = Mat<Lanes, D, D>::zero();
      for (int a = 1; a < N; ++a) sum = sum + (a <= b ? K[a][b] : transpose(K[b][a]));
      K[0][b] = Lanes(-1.0) * sum;
      K[0][0] = K[0][0] + sum;
    }
  }

  // The blocks (a, b), a <= b, which lie in the matrix's upper half; lane by lane after a transposition.
  SIM_FLATTEN void add_batch(const Tangents& s, double scale, int batch, BlockMatrix& A) const {
    constexpr int pairs = N * (N + 1) / 2, entries = pairs * D * D;
    constexpr int groups = (entries + lane_count - 1) / lane_count;
    const int lanes = elements_.lanes_in(batch);
    const int* slot = elements_.slots(batch);
    // A large matrix is not in the cache: its blocks come while the stiffness is computed. A block spans two lines.
    for (int k = 0; k < lanes * pairs; ++k)
      for (int part = 0; part < D * D; part += 8) __builtin_prefetch(A.block(slot[k]) + part, 1);
    Mat<Lanes, D, D> K[N][N];
    stiffness(s, scale, batch, K);
    Lanes group[groups][lane_count];  // [group][entry in it][element]
    int entry = 0;
    for (int a = 0; a < N; ++a)
      for (int b = a; b < N; ++b)
        for (int i = 0; i < D; ++i)
          for (int j = 0; j < D; ++j, ++entry) group[entry / lane_count][entry % lane_count] = K[a][b](i, j);
    for (; entry < groups * lane_count; ++entry) group[entry / lane_count][entry % lane_count] = 0.0;
    double own[lane_count][groups * lane_count];  // [element][entry]
    for (int g = 0; g < groups; ++g) {
      transpose(group[g]);
      for (int k = 0; k < lane_count; ++k)
        group[g][k].copy_to(own[k] + g * lane_count, std::experimental::element_aligned);
    }
    for (int k = 0; k < lanes; ++k)
      for (int pair = 0; pair < pairs; ++pair) add<D * D>(own[k] + pair * D * D, A.block(*slot++));
  }
};

template <class Element, int D, class Material>
class Elastic final : public ElasticBlock<Element, D> {
  using Base = ElasticBlock<Element, D>;
  using Base::elements_, Base::own, Base::N, Base::M, Base::Q;
  using typename Base::Elements, typename Base::Store, typename Base::Tangents;
  static constexpr bool framed = NeedsRestFrame<Material> && (D > Base::M);

  Material material_;
  double poisson_;
  TermInfo info_;

  // F at a point, in the frame the material knows.
  Mat<Lanes, D, M> deformation(int batch, int q, const Lanes (&x_e)[N - 1][D]) const {
    const Mat<Lanes, D, M> F = Elements::deformation(x_e, elements_.G(batch, q));
    if constexpr (framed) return transpose_times(frame(batch, q), F);
    return F;
  }
  const Mat<Lanes, D, D>& frame(int batch, int q) const { return elements_.frame[batch * Q + q]; }

  SIM_FLATTEN void linearise(int batch, const Motion& motion, Definiteness fix, Tangents& s, Eigen::VectorXd& f) const {
    Lanes x_e[N - 1][D], f_e[N - 1][D] = {};
    elements_.gather(batch, motion.x.data(), x_e);
    for (int q = 0; q < Q; ++q) {
      Tangent<Lanes, D, M>& t = s.tangent[batch * Q + q];
      Mat<Lanes, D, M> P;
      material_.linearise(deformation(batch, q, x_e), P, t);
      make_definite(t, fix);
      if constexpr (framed) {
        t.U = frame(batch, q) * t.U;
        P = frame(batch, q) * P;
      }
      Elements::accumulate(P, elements_.G(batch, q), -elements_.w(batch, q), f_e);
    }
    elements_.scatter(batch, f_e, f.data());
  }

 public:
  Elastic(const ElasticInput& input, const Lame& lame) : material_(lame, M), poisson_(input.material.poisson) {
    elements_ = build_batches<Element, D>(input, framed);
    info_ = {"elastic " + input.body.name + (input.material.group.empty() ? "" : "/" + input.material.group),
             std::string(Material::name) + ", " + std::to_string(elements_.count) + " " + std::string(Element::name) +
                 ", " + std::to_string(elements_.count * Q) + " points"};
  }

  TermInfo info() const override { return info_; }

  // U = sum_e sum_q w Psi(F)
  double energy(const Motion& motion, Store& store) const override {
    Tangents& s = own(store);
    elements_.chunks->for_each_batch(s.threads, [&](int batch) {
      Lanes x_e[N - 1][D];
      elements_.gather(batch, motion.x.data(), x_e);
      Lanes U = 0.0;
      for (int q = 0; q < Q; ++q) U += elements_.w(batch, q) * material_.psi(deformation(batch, q, x_e));
      s.energies[batch] = U;
    });
    double U = 0;
    for (int batch = 0; batch < elements_.batch_count(); ++batch)
      for (int k = 0; k < elements_.lanes_in(batch); ++k) U += s.energies[batch][k];
    return U;
  }

  // f_e = -w P G^T
  void add_forces(const Motion& motion, Store& store, Eigen::VectorXd& f) const override {
    elements_.chunks->for_each_batch(store.threads, [&](int batch) {
      Lanes x_e[N - 1][D], f_e[N - 1][D] = {};
      elements_.gather(batch, motion.x.data(), x_e);
      for (int q = 0; q < Q; ++q) {
        Mat<Lanes, D, M> P = material_.P(deformation(batch, q, x_e));
        if constexpr (framed) P = frame(batch, q) * P;
        Elements::accumulate(P, elements_.G(batch, q), -elements_.w(batch, q), f_e);
      }
      elements_.scatter(batch, f_e, f.data());
    });
  }

  void linearise(const Motion& motion, Definiteness fix, Store& store, Eigen::VectorXd& f) const override {
    Tangents& s = own(store);
    s.tangent.resize(static_cast<std::size_t>(elements_.batch_count()) * Q);
    elements_.chunks->for_each_batch(s.threads, [&](int batch) { linearise(batch, motion, fix, s, f); });
  }

  void add_node_values(const Eigen::VectorXd& x, Quantity quantity, Eigen::VectorXd& sums,
                       Eigen::VectorXd& weights) const override {
    for (int batch = 0; batch < elements_.batch_count(); ++batch) {
      Lanes x_e[N - 1][D], sum = 0.0, weight = 0.0;
      elements_.gather(batch, x.data(), x_e);
      for (int q = 0; q < Q; ++q) {
        const Mat<Lanes, D, M> F = deformation(batch, q, x_e);
        sum += elements_.w(batch, q) * value_at(quantity, material_, F, poisson_);
        weight += elements_.w(batch, q);
      }
      const int* n = elements_.nodes(batch);
      for (int a = 0; a < N; ++a)
        for (int k = 0; k < elements_.lanes_in(batch); ++k) {
          sums[n[a * lane_count + k]] += sum[k];
          weights[n[a * lane_count + k]] += weight[k];
        }
    }
  }
};

// The materials, by name.
template <class Element, int D>
std::unique_ptr<ElasticTerm> make_elastic_of(const ElasticInput& input) {
  const MaterialSpec& m = input.material;
  std::unique_ptr<ElasticTerm> term;
  for_each_type(Materials{}, [&]<class Material>(std::type_identity<Material>) {
    if (Material::name == m.model)
      term = std::make_unique<Elastic<Element, D, Material>>(
          input, lame(m.young, m.poisson, /*plane_stress=*/D > Element::dimension));
  });
  return term;
}

}  // namespace sim
