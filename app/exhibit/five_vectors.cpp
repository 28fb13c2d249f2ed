// A large system in a few vectors: x = U c for a chain of 200 springs, by some of its rows, by least squares, Galerkin
// and least energy, and as near to the answer as the vectors allow. Each is the best in the norm that it looks at.
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <span>

#include "app/exhibit/draw.h"
#include "app/exhibit/exhibit.h"
#include "app/exhibit/print.h"
#include "sim/mesh/input_error.h"
#include "sim/residual/low_dimensional.h"

namespace app {
namespace {

using render::Ink;
namespace rs = sim::residual;

constexpr int masses = 200;
constexpr int most_vectors = 12;  // powers of s become the same to round-off

struct LargeSystem {
  rs::Chain chain;
  Eigen::VectorXd x;  // A x = b
  Eigen::MatrixXd U;
  std::vector<int> rows;

  Eigen::MatrixXd AU() const { return rs::matrix(chain) * U; }
};

// A way to choose c, and the small matrix that it solves with.
struct Way {
  const char *name, *letter, *label, *equation;
  Ink ink;
  Eigen::VectorXd (*solve)(const LargeSystem&);
  Eigen::MatrixXd (*small)(const LargeSystem&);
};

constexpr Way ways[] = {
    {"rows", "a", "a  rows", "rows of A U", Ink::red,
     [](const LargeSystem& l) { return rs::solve_rows(l.chain, l.U, l.rows); },
     [](const LargeSystem& l) -> Eigen::MatrixXd { return l.AU()(l.rows, Eigen::indexing::all); }},
    {"least-squares", "b", "b  squares", "(A U)ᵀ A U", Ink::purple,
     [](const LargeSystem& l) { return rs::solve_least_squares(l.chain, l.U); },
     [](const LargeSystem& l) -> Eigen::MatrixXd { return l.AU().transpose() * l.AU(); }},
    {"galerkin", "c", "c  Galerkin", "Uᵀ A U", Ink::blue,
     [](const LargeSystem& l) { return rs::solve_galerkin(l.chain, l.U); },
     [](const LargeSystem& l) -> Eigen::MatrixXd { return l.U.transpose() * l.AU(); }},
    {"energy", "d", "d  energy", "Uᵀ A U", Ink::blue,
     [](const LargeSystem& l) { return rs::solve_energy(l.chain, l.U); },
     [](const LargeSystem& l) -> Eigen::MatrixXd { return l.U.transpose() * l.AU(); }},
    {"projection", "x", "x  known", "Uᵀ U", Ink::black, [](const LargeSystem& l) { return rs::project(l.x, l.U); },
     [](const LargeSystem& l) -> Eigen::MatrixXd { return l.U.transpose() * l.U; }},
};
constexpr std::size_t galerkin_way = 2, energy_way = 3;

// What the three columns measure.
struct Norm {
  const char *name, *label, *format;
  double rs::ChainErrors::*of;
};
constexpr Norm norms[] = {{"residual", "|r|", "%.2f", &rs::ChainErrors::residual},
                          {"energy", "energy", "%.4f", &rs::ChainErrors::energy},
                          {"distance", "|e|", "%.5f", &rs::ChainErrors::distance}};

LargeSystem make_system(const ExhibitSpec& spec) {
  const int n = spec.count;
  if (n > most_vectors) throw sim::InputError("count", "must be at most " + std::to_string(most_vectors));
  LargeSystem l{rs::make_chain(
                    masses, [](double s) { return 1 + 10 * s * s; },
                    [](double s) { return s >= 0.6 && s <= 0.7 ? 21.0 : 1.0; }, spec.wind),
                {},
                {},
                {}};
  l.x = rs::solve(l.chain);
  if (!spec.basis.empty() && spec.basis != "powers" && spec.basis != "sines")
    throw sim::InputError("basis", "must be powers or sines");
  l.U = spec.basis == "sines" ? rs::sine_vectors(l.chain, n) : rs::power_vectors(l.chain, n);
  return l;
}

// Rows that are given count from 1.
std::vector<int> given_rows(const std::vector<double>& values, int n) {
  std::vector<int> rows;
  for (const double value : values) {
    const int row = static_cast<int>(std::clamp(value, 0.0, masses + 1.0)) - 1;
    if (row + 1 != value || row < 0 || row >= masses || std::ranges::find(rows, row) != rows.end())
      throw sim::InputError("values", "must be different whole numbers from 1 to " + std::to_string(masses));
    rows.push_back(row);
  }
  if (static_cast<int>(rows.size()) != n)
    throw sim::InputError("values", "must be as many rows as vectors, " + std::to_string(n));
  return rows;
}

std::vector<int> rows_of(const ExhibitSpec& spec, const LargeSystem& l) {
  if (!spec.values.empty()) return given_rows(spec.values, spec.count);
  if (spec.rows.empty() || spec.rows == "equal") return rs::equal_rows(masses, spec.count);
  if (spec.rows == "first") return rs::first_rows(spec.count);
  if (spec.rows == "pivoted") return rs::pivoted_rows(l.AU());
  throw sim::InputError("rows", "must be equal, first or pivoted");
}

class FiveVectors : public Exhibit {
 public:
  explicit FiveVectors(const ExhibitInput& input)
      : system_(input.system), pace_(input.spec.pace), large_(make_system(input.spec)) {
    large_.rows = rows_of(input.spec, large_);
    for (const Way& way : ways) {
      Choice choice{way.solve(large_), way.small(large_), {}};
      choice.errors = rs::measure(large_.chain, large_.x, large_.U * choice.c);
      choices_.push_back(std::move(choice));
    }
    if (!input.spec.values.empty()) only_ = 0;
    if (input.spec.method.empty()) return;
    const auto found = std::ranges::find(ways, input.spec.method, &Way::name);
    if (found == std::end(ways))
      throw sim::InputError("method", "must be rows, least-squares, galerkin, energy or projection");
    only_ = static_cast<int>(found - ways);
  }

  void show(const sim::State& state, render::Sheet& sheet) const override {
    const std::size_t now = turn(state);
    sheet.bodies = false;
    sheet.column = 0.56;
    sheet.diagrams.push_back(curves(now));
    sheet.diagrams.push_back(shrinking(now, phase(state)));
    sheet.diagrams.push_back(bars());
    sheet.blocks.push_back(table());
    sheet.blocks.push_back(
        {ways[now].label, {matrix("c", std::string(ways[now].name) + ".c", "%.4f", choices_[now].c)}});
    sheet.formula = "A U c ≈ b,    Uᵀ A U c = Uᵀ b";
    sheet.proof_label = "largest c Galerkin − c energy:";
    sheet.proof =
        number("difference", "%.0e", (choices_[galerkin_way].c - choices_[energy_way].c).cwiseAbs().maxCoeff());
  }

  std::vector<Grip> grips(const sim::State& state) const override {
    if (turn(state) != 0) return {};
    std::vector<Grip> all;
    std::vector<double> numbers;
    for (const int row : large_.rows) numbers.push_back(row + 1.0);
    for (std::size_t k = 0; k < numbers.size(); ++k)
      all.push_back(number_grip(0, {place(large_.rows[k]), 0}, numbers, k, [](const render::Spot& to) {
        return std::clamp(std::round(to[0] * (masses + 1)), 1.0, double(masses));
      }));
    return all;
  }

 private:
  struct Choice {
    Eigen::VectorXd c;
    Eigen::MatrixXd small;
    rs::ChainErrors errors;
  };

  double paces(const sim::State& state) const { return std::max(0.0, system_.time(state.step) / pace_ + 1e-9); }
  // One way after the other; the last one stays.
  std::size_t turn(const sim::State& state) const {
    if (only_ >= 0) return static_cast<std::size_t>(only_);
    return std::min(static_cast<std::size_t>(std::floor(paces(state))), std::size(ways) - 1);
  }
  // From 0 to 1 while a way is shown; at the end all is seen of it.
  double phase(const sim::State& state) const {
    const double now = paces(state);
    const bool ended = only_ < 0 && now >= static_cast<double>(std::size(ways));
    return ended ? 1 : now - std::floor(now);
  }
  static double place(int row) { return (row + 1.0) / (masses + 1.0); }

  // The least of a norm; what only differs by round-off is the least too.
  bool is_least(std::size_t choice, const Norm& norm) const {
    return std::ranges::all_of(choices_, [&](const Choice& other) {
      return choices_[choice].errors.*norm.of <= other.errors.*norm.of * (1 + 1e-9);
    });
  }

  render::Block table() const {
    render::Table table{{""}, {}, {}};
    for (const Norm& norm : norms) table.head.push_back(norm.label);
    for (std::size_t k = 0; k < choices_.size(); ++k) {
      render::Table::Row row{ways[k].label, {}, ways[k].ink};
      for (std::size_t column = 0; column < std::size(norms); ++column) {
        const Norm& norm = norms[column];
        row.numbers.push_back(
            number(std::string(ways[k].name) + "." + norm.name, norm.format, choices_[k].errors.*norm.of));
        if (is_least(k, norm)) table.boxed.push_back({static_cast<int>(k), static_cast<int>(column)});
      }
      table.rows.push_back(row);
    }
    return {"r = A U c − b,  e = U c − x", {table}};
  }

  // The answer and its approximation along the chain; where the rows are that were kept.
  render::Diagram curves(std::size_t now) const {
    render::Diagram d{.place = {0.01, 0.11, 0.55, 0.51},
                      .title = std::string(ways[now].label) + "; dashed: the answer",
                      .axes = true};
    const Eigen::VectorXd s = large_.chain.places(), approximation = large_.U * choices_[now].c;
    d.x = {0, 1};
    d.y = {-0.6 * large_.x.maxCoeff(), 1.4 * large_.x.maxCoeff()};
    render::Stroke answer{{{0, 0}}, Ink::black, false, true};
    for (Eigen::Index i = 0; i < s.size(); ++i) answer.points.push_back({s[i], large_.x[i]});
    d.strokes = {answer, {{{0, 0}}, ways[now].ink}};
    // What leaves the picture comes back as another stroke.
    for (Eigen::Index i = 0; i < s.size(); ++i) {
      const bool inside = d.y[0] <= approximation[i] && approximation[i] <= d.y[1];
      if (inside) d.strokes.back().points.push_back({s[i], approximation[i]});
      if (!inside && !d.strokes.back().points.empty()) d.strokes.push_back({{}, ways[now].ink});
    }
    if (now != 0) return d;
    for (const int row : large_.rows) d.dots.push_back({{place(row), 0}, Ink::red, true});
    return d;
  }

  // To scale: A, 200 x 200, loses its columns to U, then its rows to the method; the small matrix, enlarged, at last.
  render::Diagram shrinking(std::size_t now, double phase) const {
    render::Diagram d{.place = {0.01, 0.53, 0.27, 0.87}, .equal = true};
    const auto n = static_cast<double>(large_.U.cols());
    d.x = {-5, 460};
    d.y = {-35, 205};
    const auto shrunk = [&](double from, double until) {
      const double share = std::clamp((phase - from) / (until - from), 0.0, 1.0);
      return masses + share * (n - masses);
    };
    const double width = shrunk(0.1, 0.3), height = shrunk(0.35, 0.55);
    const std::vector<render::Spot> outline = {
        {0, masses - height}, {width, masses - height}, {width, masses}, {0, masses}};
    d.patches.push_back({outline});
    d.strokes.push_back({outline, Ink::black, true});
    if (width == masses) d.strokes.push_back({{{0, masses}, {masses, 0}}, Ink::blue});
    if (now == 0 && width < masses && height == masses)
      for (const int row : large_.rows)
        d.strokes.push_back({{{0, double(masses - row)}, {width, double(masses - row)}}, Ink::red});
    const bool small = height == n;
    const std::string name = width == masses ? "A" : height == masses && width == n ? "A U" : "";
    d.words.push_back({{width + 5, masses / 2.0}, name, Ink::black});
    if (!small) return d;
    d.darts.push_back({{20, masses - 10}, {225, masses / 2.0}, Ink::black});
    add_small(choices_[now].small, {240, 0}, d);
    d.words.push_back({{340, 0}, ways[now].equation, Ink::black, render::Side::below});
    return d;
  }

  // Entries by size: white for nothing.
  static void add_small(const Eigen::MatrixXd& A, const render::Spot& corner, render::Diagram& d) {
    const double cell = double(masses) / static_cast<double>(A.rows()), largest = A.cwiseAbs().maxCoeff();
    for (Eigen::Index i = 0; i < A.rows(); ++i)
      for (Eigen::Index j = 0; j < A.cols(); ++j) {
        const double x = corner[0] + cell * static_cast<double>(j),
                     y = corner[1] + masses - cell * static_cast<double>(i + 1);
        const std::vector<render::Spot> square = {{x, y}, {x + cell, y}, {x + cell, y + cell}, {x, y + cell}};
        d.patches.push_back({square, tint(std::sqrt(std::abs(A(i, j)) / largest))});
        d.strokes.push_back({square, Ink::black, true});
      }
  }

  // Every error on a logarithmic scale, a group for each norm.
  render::Diagram bars() const {
    render::Diagram d{.place = {0.29, 0.53, 0.55, 0.87}, .title = "errors, logarithmic"};
    double low = 1e300, high = 0;
    for (const Choice& choice : choices_)
      for (const Norm& norm : norms) {
        low = std::min(low, choice.errors.*norm.of);
        high = std::max(high, choice.errors.*norm.of);
      }
    const auto count = static_cast<double>(std::size(ways)), gap = 1.5;
    const double floor = std::log10(low) - 0.5;
    d.x = {-1, 3 * (count + gap) - gap};
    d.y = {floor - 3.2, std::log10(high)};
    for (std::size_t g = 0; g < std::size(norms); ++g) {
      const double first = static_cast<double>(g) * (count + gap);
      for (std::size_t k = 0; k < choices_.size(); ++k) {
        const double at = first + static_cast<double>(k), top = std::log10(choices_[k].errors.*norms[g].of);
        d.strokes.push_back({{{at, floor}, {at, top}}, ways[k].ink, false, false, 4});
        d.words.push_back({{at, floor}, ways[k].letter, ways[k].ink, render::Side::below});
      }
      d.words.push_back({{first + (count - 1) / 2, floor - 1.3}, norms[g].label, Ink::black, render::Side::below});
    }
    return d;
  }

  const sim::System& system_;
  double pace_;
  LargeSystem large_;
  std::vector<Choice> choices_;
  int only_ = -1;  // number of the way that is shown; -1: one after the other
};

}  // namespace

std::unique_ptr<Exhibit> make_five_vectors(const ExhibitInput& input) {
  return std::make_unique<FiveVectors>(input);
}

}  // namespace app
