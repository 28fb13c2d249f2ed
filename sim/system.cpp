#include "sim/system.h"

#include <Eigen/Geometry>
#include <sstream>

#include "sim/build/build.h"
#include "sim/build/reduction.h"
#include "sim/build/warnings.h"
#include "sim/contact/distance.h"
#include "sim/solve/contact_pressure.h"
#include "sim/solve/linear_solver.h"
#include "sim/solve/mass_product.h"
#include "sim/time/stable_step.h"

namespace sim {

namespace {

// Of a contact while a step is taken: boxes of primitives and of their trees; and a kilobyte a point, as if a tenth of
// them had ten pairs with a matrix of 12 x 12 each.
std::int64_t bytes_of(const ContactTerm& term) {
  const Skin& skin = term.input().skin;
  const std::size_t boxes = skin.node.size() + 2 * (skin.edges.size() + skin.faces.size());
  return static_cast<std::int64_t>(boxes * sizeof(Bounds) + skin.node.size() * sizeof(PairMatrix));
}

}  // namespace

System::System(const Scene& scene, int threads) : parts_(build(scene, threads)) {}
System::~System() = default;
System::System(System&&) noexcept = default;

const Parts& parts_of(const System& system) {
  return *system.parts_;
}

int System::dimension() const {
  return parts_->model.D;
}
double System::step_seconds() const {
  return parts_->model.h();
}
int System::steps_per_frame() const {
  return parts_->model.time.substeps;
}
double System::time(std::int64_t step) const {
  return parts_->model.t(step);
}
std::span<const BodyRange> System::bodies() const {
  return parts_->model.ranges;
}
double System::mass(std::size_t body) const {
  return parts_->model.masses[body].total();
}
Eigen::Ref<const Eigen::VectorXd> System::of_bodies(const Eigen::VectorXd& all) const {
  return all.head(static_cast<Eigen::Index>(parts_->model.body_nodes) * parts_->model.D);
}
std::vector<std::string> System::remarks() const {
  std::vector<std::string> all = warnings(*parts_);
  all.insert(all.end(), parts_->remarks.begin(), parts_->remarks.end());
  return all;
}
double System::stable_step() const {
  return sim::stable_step(parts_->moving());
}
std::vector<int> System::pinned_nodes(double t) const {
  std::vector<int> nodes = parts_->model.pins.nodes(t);
  std::erase_if(nodes, [&](int node) { return node >= parts_->model.body_nodes; });
  return nodes;
}

std::vector<TermInfo> System::terms() const {
  std::vector<TermInfo> all;
  for (const auto& term : parts_->model.terms) all.push_back(term->info());
  for (const Body& body : parts_->model.bodies)
    if (body.basis) all.push_back(basis_info(body, parts_->model.D));
  return all;
}

std::optional<ObstacleShape> System::obstacle(const State& state, std::size_t k) const {
  const Obstacle& it = parts_->model.obstacles[k];
  if (it.release && time(state.step) > *it.release) return std::nullopt;
  return std::visit(
      [&](const auto& shape) {
        return ObstacleShape(shape_at(shape, parts_->model.obstacle_nodes[k], state.x, parts_->model.D));
      },
      it.shape);
}

int System::contact_pairs() const {
  std::size_t pairs = 0;
  for (const ContactTerm* term : parts_->model.contacts) pairs += term->input().couples.size();
  return static_cast<int>(pairs);
}

std::vector<ContactReport> System::contacts(const State& state) const {
  const bool first = state.x_before.size() == 0;
  const Motion now{state.x, state.v, time(state.step), 0};
  const Motion begin{first ? state.x : state.x_before, first ? state.v : state.v_before, now.t, 0};
  std::vector<ContactReport> all;
  for (const ContactTerm* term : parts_->model.contacts)
    for (ContactReport& report : term->reports(begin, now)) all.push_back(std::move(report));
  return all;
}

Counts System::counts() const {
  Counts c;
  c.nodes = parts_->model.body_nodes;
  for (const BodyRange& range : parts_->model.ranges) c.elements += range.element_count;
  c.dofs = c.nodes * parts_->model.D;
  Eigen::VectorXd free(parts_->model.dofs());
  parts_->model.pins.mark(0, free);
  c.free_dofs = static_cast<int>(free.sum());
  if (parts_->model.pattern)
    c.nonzeros = static_cast<std::int64_t>(parts_->model.pattern->blocks()) * parts_->model.D * parts_->model.D;
  // Vectors of the state, its copies and the solver; the matrix in double and in single precision, and for each of its
  // blocks where it lies, comes from and goes; the factor (fill of about 12 times is usual for solids). A fifth more is
  // what building leaves behind, measured; the program itself, with its libraries, too.
  constexpr std::int64_t program = 64'000'000, vectors = 55, links = 20;
  const std::int64_t D2 = static_cast<std::int64_t>(parts_->model.D) * parts_->model.D;
  c.bytes = vectors * 8 * c.dofs + (8 + 4) * c.nonzeros + links * c.nonzeros / D2;
  if (parts_->model.solver.linear == LinearSolverKind::cholmod) c.bytes += 12ll * 12 * c.nonzeros;
  for (const ElasticPart& part : parts_->model.elastic) c.bytes += part.term->bytes();
  for (const ContactTerm* term : parts_->model.contacts) c.bytes += bytes_of(*term);
  c.bytes = program + c.bytes * 6 / 5;
  return c;
}

State System::initial_state() const {
  State state;
  state.x = parts_->model.x_start;
  state.v.resize(parts_->model.dofs());
  const int D = parts_->model.D;
  for (std::size_t b = 0; b < parts_->model.bodies.size(); ++b) {
    const Body& body = parts_->model.bodies[b];
    const Mass& mass = parts_->model.masses[b];
    Vec3 centre = Vec3::Zero();
    const auto place = [&](int node) {
      Vec3 X = Vec3::Zero();
      X.head(D) = state.x.segment(static_cast<Eigen::Index>(node) * D, D);
      return X;
    };
    for (int i = 0; i < mass.nodal().size(); ++i)
      centre += mass.nodal()[i] / mass.total() * place(mass.first_node() + i);
    const Vec3 omega = body.spin.rate * body.spin.axis.normalized();
    for (int i = 0; i < mass.nodal().size(); ++i) {
      const int node = mass.first_node() + i;
      const Vec3 v = body.velocity + omega.cross(place(node) - centre);
      state.v.segment(static_cast<Eigen::Index>(node) * D, D) = v.head(D);
    }
  }
  parts_->model.pins.prescribe(0, state.x, state.v);
  if (parts_->reduction) parts_->reduction->enter(state);
  return state;
}

Measures System::measure(const State& state) const {
  Measures m;
  const int D = parts_->model.D;
  const Eigen::VectorXd momentum = mass_product(parts_->model, state.v);
  m.kinetic = 0.5 * state.v.dot(momentum);
  for (int node = 0; node < parts_->model.body_nodes; ++node) {
    const Eigen::Index at = static_cast<Eigen::Index>(node) * D;
    Vec3 x = Vec3::Zero(), p = Vec3::Zero();
    x.head(D) = state.x.segment(at, D);
    p.head(D) = momentum.segment(at, D);
    m.p += p;
    m.L += x.cross(p);
  }
  const Motion motion{state.x, state.v, time(state.step), 0};
  for (const auto& term : parts_->model.terms) {
    const auto store = term->make_store(parts_->model.threads);
    (term->role() == Role::elastic ? m.elastic : m.potential) += term->energy(motion, *store);
  }
  return m;
}

Vec3 System::probe_position(const State& state, int probe) const {
  const ProbePlace& place = parts_->probes[probe];
  Vec3 x = Vec3::Zero();
  for (std::size_t a = 0; a < place.point.weights.size(); ++a) {
    const int node = place.first_node + place.mesh->elements(static_cast<Eigen::Index>(a), place.point.element);
    x.head(parts_->model.D) +=
        place.point.weights[a] * state.x.segment(static_cast<Eigen::Index>(node) * parts_->model.D, parts_->model.D);
  }
  return x;
}

Vec3 System::probe_displacement(const State& state, int probe) const {
  State moved;
  moved.x = state.x - parts_->model.X;
  return probe_position(moved, probe);
}

Eigen::VectorXd System::node_values(const State& state, Quantity quantity) const {
  if (quantity == Quantity::pressure)
    return contact_pressure(parts_->model, {state.x, state.v, time(state.step), 0}).head(parts_->model.body_nodes);
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(parts_->model.node_count), weights = sums;
  for (const ElasticPart& part : parts_->model.elastic) part.term->add_node_values(state.x, quantity, sums, weights);
  return (weights.array() > 0).select(sums.array() / weights.array().max(1e-300), 0.0).head(parts_->model.body_nodes);
}

std::string failure_text(const System& system, const StepReport& report) {
  std::ostringstream text;
  text << "step " << report.step << ", t = " << system.time(report.step) << " s";
  if (report.min_J_element >= 0) text << ", element " << report.min_J_element;
  text << ": " << report.failure;
  return text.str();
}

}  // namespace sim
