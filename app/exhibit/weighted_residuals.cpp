// Weighted residuals: u and u_n above, below what is left of the equation and what the method does to it. Everything is
// computed by the functions of `ritz residuals`.
#include <algorithm>
#include <cmath>
#include <limits>

#include "app/exhibit/exhibit.h"
#include "app/exhibit/print.h"
#include "app/exhibit/residual_plots.h"
#include "app/residuals/study.h"
#include "sim/mesh/input_error.h"

namespace app {
namespace {

using render::Ink;
using sim::residual::Errors;
using sim::residual::Method;
using sim::residual::Real;
namespace rs = sim::residual;

constexpr int most_functions = 16;

struct Style {
  std::string_view method, label;
  Ink ink;
};
constexpr Style styles[] = {{"collocation-equal", "a  equal", Ink::red},
                            {"collocation-gauss", "a  Gauss", Ink::red},
                            {"least-squares", "b  squares", Ink::purple},
                            {"galerkin", "c  Galerkin", Ink::blue},
                            {"ritz", "d  Ritz", Ink::black}};

// A method that is new has its own name.
MethodEntry entry_of(std::string_view method) {
  for (const Style& style : styles)
    if (style.method == method) return {std::string(method), std::string(style.label), style.ink};
  return {std::string(method), "e  " + std::string(method)};
}

struct ErrorColumn {
  const char *name, *label;
  std::optional<Real> (*of)(const Errors&);
};
constexpr ErrorColumn error_columns[] = {
    {"L2", "L₂", [](const Errors& e) { return std::optional(e.L2); }},
    {"H1", "H₁", [](const Errors& e) { return std::optional(e.H1_seminorm); }},
    {"residual", "residual", [](const Errors& e) { return e.residual_L2; }},
};

rs::Vector points_of(std::string_view method, int n) {
  if (method == "collocation-equal") return rs::equal_points(n);
  if (method == "collocation-gauss") return rs::gauss_points(n);
  return {};
}

ProblemFile problem_of(const ExhibitInput& input) {
  if (input.spec.problem.empty()) throw sim::InputError("problem", "is missing: a file that `ritz residuals` reads");
  try {
    return read_problem(input.folder / input.spec.problem);
  } catch (const std::runtime_error& error) {
    throw sim::InputError("problem", error.what());
  }
}

// 1, 2, 4, ... and the last itself; at points that are given as many functions as points.
std::vector<int> terms_of(const ExhibitSpec& spec) {
  const bool own = !spec.values.empty();
  const int most = own ? static_cast<int>(spec.values.size()) : spec.count;
  if (most > most_functions)
    throw sim::InputError(own ? "values" : "count", "must be at most " + std::to_string(most_functions));
  std::vector<int> terms;
  for (int n = 1; n < most && !own; n *= 2) terms.push_back(n);
  terms.push_back(most);
  return terms;
}

class WeightedResiduals : public Exhibit {
 public:
  explicit WeightedResiduals(const ExhibitInput& input)
      : system_(input.system), pace_(input.spec.pace), values_(input.spec.values) {
    if (!input.spec.method.empty()) choose(input.spec.method);
    const rs::Basis* basis = rs::find_basis(input.spec.basis.empty() ? "polynomials" : input.spec.basis);
    if (basis == nullptr) throw sim::InputError("basis", "must be sines, polynomials or hats");
    for (const double x : values_)
      if (!(x > 0 && x < 1)) throw sim::InputError("values", "must be points between 0 and 1");
    ProblemFile file = problem_of(input);
    file.bases = {basis};
    file.n = terms_of(input.spec);
    file.methods.clear();
    for (const Method& method : rs::methods()) file.methods.push_back(&method);
    solve(study_residuals(std::move(file), false));
  }

  void show(const sim::State& state, render::Sheet& sheet) const override {
    const Turn now = turn(state);
    const std::vector<MethodEntry>& row = levels_[now.level];
    const MethodEntry& entry = row[now.method];
    sheet.bodies = false;
    sheet.column = 0.54;
    sheet.diagrams.push_back(solution_plot(file_.problem, entry, {0.01, 0.11, 0.53, 0.49}));
    if (entry.attempt) sheet.diagrams.push_back(action_plot(file_.problem, entry, now.term, {0.01, 0.49, 0.53, 0.87}));
    sheet.blocks = {table(row), coefficients(entry)};
    const auto error = [](const MethodEntry& e) {
      return e.attempt ? e.attempt->errors.H1_seminorm : std::numeric_limits<Real>::infinity();
    };
    const MethodEntry& least = *std::ranges::min_element(row, {}, error);
    sheet.formula = "∫ wᵢ (L uₙ − f) = 0,   uₙ = Σ cᵢ uᵢ";
    sheet.proof_label = "least H₁ error, " + least.label.substr(3) + ":";
    sheet.proof = number("least.H1", "%.6f", static_cast<double>(error(least)));
  }

  std::vector<Grip> grips(const sim::State& state) const override {
    const Turn now = turn(state);
    const MethodEntry& entry = levels_[now.level][now.method];
    const std::vector<double> points(entry.points.begin(), entry.points.end());
    std::vector<Grip> all;
    for (std::size_t j = 0; entry.attempt && j < points.size(); ++j)
      all.push_back(number_grip(1, {points[j], 0}, points, j, [](const render::Spot& to) {
        constexpr double margin = 1e-3;
        return std::clamp(to[0], margin, 1 - margin);
      }));
    return all;
  }

 private:
  struct Turn {
    std::size_t level = 0, method = 0;
    Eigen::Index term = 0;  // function that a method is shown with
  };

  void choose(const std::string& method) {
    const Method* found = rs::find_method(method);
    if (found != nullptr) {
      only_ = found - rs::methods().data();
      return;
    }
    std::string known;
    for (const Method& each : rs::methods()) known.append(known.empty() ? "" : ", ").append(each.name);
    throw sim::InputError("method", "must be one of " + known);
  }

  void solve(const ResidualStudy& study) {
    file_ = study.file;
    for (const int n : file_.n) {
      std::vector<MethodEntry> row;
      for (const Method* method : file_.methods) {
        MethodEntry entry = entry_of(method->name);
        entry.points = points_of(method->name, n);
        for (const Attempt& attempt : study.attempts)
          if (attempt.method == entry.method && attempt.n() == n) entry.attempt = attempt;
        row.push_back(std::move(entry));
      }
      if (!values_.empty()) row[0] = at_own_points(study.asymmetry.power == 0);
      levels_.push_back(std::move(row));
    }
  }

  MethodEntry at_own_points(bool self_adjoint) const {
    const rs::Basis& basis = *file_.bases[0];
    MethodEntry entry{"collocation-own", "a  dragged", Ink::red, {}, rs::Vector(values_.size())};
    std::ranges::copy(values_, entry.points.begin());
    if (!basis.smooth) return entry;
    const rs::Answer answer = rs::collocate(file_.problem, basis, entry.points);
    if (!answer.refusal.empty()) return entry;
    const rs::Trial u(basis, answer.c);
    entry.attempt = Attempt{entry.method, u, measure(file_.problem, u, self_adjoint)};
    return entry;
  }

  // Every n for one method, then for the next, and the last stays; the points that are given alone.
  Turn turn(const sim::State& state) const {
    const double paces = std::max(0.0, system_.time(state.step) / pace_ + 1e-9);
    const std::size_t levels = levels_.size(), turns = levels * (only_ >= 0 ? 1 : levels_[0].size());
    const std::size_t whole = std::min(static_cast<std::size_t>(std::floor(paces)), turns - 1);
    Turn now{whole % levels, whole / levels, 0};
    if (only_ >= 0) now.method = static_cast<std::size_t>(only_);
    if (!values_.empty()) now.method = 0;
    now.term = static_cast<Eigen::Index>((paces - std::floor(paces)) * file_.n[now.level]);
    return now;
  }

  render::Block table(const std::vector<MethodEntry>& row) const {
    render::Table table{{""}, {}, {}};
    for (const ErrorColumn& column : error_columns) table.head.push_back(column.label);
    for (const MethodEntry& entry : row) {
      render::Table::Row line{entry.label, {}, entry.ink};
      for (const ErrorColumn& column : error_columns) {
        const auto error = entry.attempt ? column.of(entry.attempt->errors) : std::nullopt;
        const std::string name = entry.method + "." + column.name;
        if (error && is_least(row, column, *error))
          table.boxed.push_back({static_cast<int>(table.rows.size()), static_cast<int>(line.numbers.size())});
        line.numbers.push_back(error ? number(name, "%.3e", static_cast<double>(*error))
                                     : render::Number{name, entry.attempt ? "none" : "refused", ""});
      }
      table.rows.push_back(line);
    }
    const std::size_t level = static_cast<std::size_t>(&row - levels_.data());
    return {"errors, n = " + std::to_string(file_.n[level]) + " " + std::string(file_.bases[0]->name), {table}};
  }

  // What only differs by round-off is the least too.
  static bool is_least(const std::vector<MethodEntry>& row, const ErrorColumn& column, Real error) {
    return std::ranges::all_of(row, [&](const MethodEntry& other) {
      const auto its = other.attempt ? column.of(other.attempt->errors) : std::nullopt;
      return !its || error <= *its * (1 + Real(1e-9));
    });
  }

  render::Block coefficients(const MethodEntry& entry) const {
    constexpr Eigen::Index most_shown = 8;
    render::Block block{entry.label + (entry.attempt ? "" : ": refused"), {}};
    if (!entry.attempt) return block;
    const auto shown = [&](const rs::Vector& all) -> Eigen::VectorXd {
      return all.head(std::min(all.size(), most_shown)).cast<double>();
    };
    block.items.push_back(matrix("c", entry.method + ".c", "%.4f", shown(entry.attempt->u.coefficients())));
    if (file_.bases[0]->smooth)
      block.items.push_back(matrix("∫ uᵢ r", entry.method + ".weighted", "%.0e",
                                   shown(weighted_residuals(file_.problem, entry.attempt->u))));
    return block;
  }

  const sim::System& system_;
  double pace_;
  std::vector<double> values_;                    // points of collocation that are given
  std::ptrdiff_t only_ = -1;                      // number of the method that is shown; -1: one after the other
  ProblemFile file_;                              // with the basis and every n that is shown
  std::vector<std::vector<MethodEntry>> levels_;  // the methods, for every n
};

}  // namespace

std::unique_ptr<Exhibit> make_weighted_residuals(const ExhibitInput& input) {
  return std::make_unique<WeightedResiduals>(input);
}

}  // namespace app
