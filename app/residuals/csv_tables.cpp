#include "app/base/number_text.h"
#include "app/base/text.h"
#include "app/residuals/orders.h"
#include "app/residuals/tables.h"

namespace app {
namespace {

using sim::residual::Real;

constexpr int most_monomials = 12;  // above, none of their digits would be right

// A comma and the number, or the comma alone.
void append_field(std::string& text, const std::optional<Real>& number) {
  text += ',';
  if (number) append_number(text, static_cast<double>(*number));
}

// A name with a comma in it stands in quotes.
std::string problem_field(const ResidualStudy& study) {
  const std::string& name = study.file.name;
  return name.find_first_of(",\"") == std::string::npos ? name : quoted_field(name);
}

void append_coefficients(std::string& text, const std::string& head, const sim::residual::Vector& c) {
  for (Eigen::Index i = 0; i < c.size(); ++i) {
    text += head + std::to_string(i + 1);
    append_field(text, c[i]);
    text += '\n';
  }
}

}  // namespace

std::string residuals_csv(std::span<const ResidualStudy> studies) {
  std::string text = "problem,basis,method,n,L2,H1_seminorm,energy_norm,residual_L2,max_1001,F\n";
  for (const ResidualStudy& study : studies) {
    for (const Attempt& attempt : study.attempts) {
      text.append(problem_field(study)).append(",").append(attempt.basis()).append("," + attempt.method + ",");
      text += std::to_string(attempt.n());
      const sim::residual::Errors& errors = attempt.errors;
      append_field(text, errors.L2);
      append_field(text, errors.H1_seminorm);
      append_field(text, errors.energy_norm);
      append_field(text, errors.residual_L2);
      append_field(text, errors.max_1001);
      append_field(text, errors.F);
      text += '\n';
    }
  }
  return text;
}

std::string coefficients_csv(std::span<const ResidualStudy> studies) {
  std::string text = "problem,basis,method,n,i,c\n";
  for (const ResidualStudy& study : studies) {
    for (const Attempt& attempt : study.attempts) {
      const std::string rest = "," + attempt.method + "," + std::to_string(attempt.n()) + ",",
                        basis = problem_field(study) + "," + std::string(attempt.basis());
      const sim::residual::Vector& c = attempt.u.coefficients();
      if (attempt.basis() != "polynomials") {
        append_coefficients(text, basis + rest, c);
        continue;
      }
      append_coefficients(text, basis + ":integrated-legendre" + rest, c);
      if (c.size() <= most_monomials)
        append_coefficients(text, basis + ":x^i(1-x)" + rest, sim::residual::to_monomials(c));
    }
  }
  return text;
}

std::string orders_csv(std::span<const ResidualStudy> studies) {
  std::string text = "problem,basis,method,n,order_L2,order_H1,order_residual,order_max\n";
  for (const ResidualStudy& study : studies) {
    for (const Orders& orders : orders_of(study)) {
      text.append(problem_field(study)).append(",").append(orders.from->basis());
      text +=
          "," + orders.from->method + "," + std::to_string(orders.from->n()) + " to " + std::to_string(orders.to->n());
      append_field(text, orders.L2);
      append_field(text, orders.H1);
      append_field(text, orders.residual);
      append_field(text, orders.max);
      text += '\n';
    }
  }
  return text;
}

}  // namespace app
