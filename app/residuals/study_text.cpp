#include <algorithm>
#include <cmath>

#include "app/base/text.h"
#include "app/residuals/orders.h"
#include "app/residuals/tables.h"

namespace app {
namespace {

using sim::residual::Errors;
using sim::residual::Real;

// A column of errors.
struct Column {
  const char* name;
  std::optional<Real> (*of)(const Errors& errors);
};
constexpr Column columns[] = {
    {"L2", [](const Errors& e) { return std::optional(e.L2); }},
    {"H1", [](const Errors& e) { return std::optional(e.H1_seminorm); }},
    {"energy", [](const Errors& e) { return e.energy_norm; }},
    {"residual", [](const Errors& e) { return e.residual_L2; }},
    {"max", [](const Errors& e) { return std::optional(e.max_1001); }},
};

std::string equation_text(const ResidualStudy& study) {
  std::string text = study.file.name + ": -(k u')' + a u' + q u = f, u(0) = u(1) = 0\n";
  for (const char* const key : {"k", "a", "q", "f", "exact"})
    if (const auto found = study.file.written.find(key); found != study.file.written.end())
      text += "  " + found->first + " = " + found->second + "\n";
  const auto& reference = study.file.reference;
  const std::string computed = formatted(
      "collocation of u' = s/k, s' = a u' + q u - f on %d panels of %d points; halving them moves it by %.1Le",
      reference.panels, reference.points, reference.change);
  text += study.file.exact_is_computed()
              ? "  no exact u is given: errors are against a computed one, by " + computed + "\n"
              : "  the exact u agrees with a computed one, by " + computed + "\n";
  return text;
}

// The attempts with the same basis and number of terms.
std::vector<const Attempt*> row_of(const ResidualStudy& study, std::string_view basis, int n) {
  std::vector<const Attempt*> row;
  for (const Attempt& attempt : study.attempts)
    if (attempt.basis() == basis && attempt.n() == n) row.push_back(&attempt);
  return row;
}

// Equal but for round-off counts as least too: Galerkin and Ritz are.
bool is_least(const Column& column, const Attempt& attempt, const std::vector<const Attempt*>& row) {
  constexpr Real round_off = 1e-9L;
  const auto least = std::ranges::min(row, {}, [&](const Attempt* a) { return column.of(a->errors).value_or(0); });
  return row.size() > 1 && *column.of(attempt.errors) <= *column.of(least->errors) * (1 + round_off);
}

std::string attempt_line(const Attempt& attempt, const std::vector<const Attempt*>& row) {
  std::string line =
      formatted("  %-12s %4d  %-18s", std::string(attempt.basis()).c_str(), attempt.n(), attempt.method.c_str());
  for (const Column& column : columns) {
    const auto error = column.of(attempt.errors);
    line +=
        error ? formatted(" %12.5Le%c", *error, is_least(column, attempt, row) ? '*' : ' ') : formatted(" %13s", "- ");
  }
  return line + "\n";
}

std::string errors_text(const ResidualStudy& study) {
  std::string text = formatted("  %-12s %4s  %-18s", "basis", "n", "method");
  for (const Column& column : columns) text += formatted(" %12s ", column.name);
  text += "\n";
  for (const auto* const basis : study.file.bases)
    for (const int n : study.file.n) {
      const auto row = row_of(study, basis->name, n);
      for (const Attempt* const attempt : row) text += attempt_line(*attempt, row);
    }
  return text + "  * the least of its basis and n\n";
}

std::string order_text(const std::optional<Real>& order) {
  return order ? formatted(" %9.2Lf", *order) : formatted(" %9s", "-");
}

// From the last but one number of terms to the last.
std::string orders_text(const ResidualStudy& study) {
  std::string text;
  const std::vector<Orders> all = orders_of(study);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Orders& orders = all[i];
    if (i + 1 < all.size() && all[i + 1].from == orders.to) continue;
    text += formatted("  %-12s %3d to %-3d %-18s", std::string(orders.from->basis()).c_str(), orders.from->n(),
                      orders.to->n(), orders.from->method.c_str()) +
            order_text(orders.L2) + order_text(orders.H1) + order_text(orders.residual) + order_text(orders.max) + "\n";
  }
  if (text.empty()) return text;
  return formatted("  %-12s %-10s %-18s %9s %9s %9s %9s", "orders", "n", "method", "L2", "H1", "residual", "max") +
         "\n" + text;
}

// How far Galerkin's coefficients are from Ritz's, over all bases and n: two assemblies that share no integral.
std::string agreement_text(const ResidualStudy& study) {
  Real apart = -1, size = 0;
  for (const Attempt& a : study.attempts)
    for (const Attempt& b : study.attempts) {
      if (a.method != "galerkin" || b.method != "ritz" || a.basis() != b.basis() || a.n() != b.n()) continue;
      apart = std::max(apart, (a.u.coefficients() - b.u.coefficients()).cwiseAbs().maxCoeff());
      size = std::max(size, a.u.coefficients().cwiseAbs().maxCoeff());
    }
  if (apart < 0) return {};
  return formatted("  Galerkin and Ritz, assembled apart: coefficients up to %.3Lg differ by at most %.1Le\n", size,
                   apart);
}

}  // namespace

std::string study_text(const ResidualStudy& study) {
  std::string text = equation_text(study) + errors_text(study) + orders_text(study) + agreement_text(study);
  for (const std::string& refusal : study.refusals) text += "  refused: " + refusal + "\n";
  return text;
}

}  // namespace app
