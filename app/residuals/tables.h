// The numbers of a study, as CSV files and as the table that is printed.
#pragma once

#include <span>
#include <string>

#include "app/residuals/study.h"

namespace app {

// problem,basis,method,n,L2,H1_seminorm,energy_norm,residual_L2,max_1001,F; a field is empty where there is no such
// number.
std::string residuals_csv(std::span<const ResidualStudy> studies);

// problem,basis,method,n,i,c. Polynomials are there twice, "polynomials:integrated-legendre" as they are computed and,
// up to 12 terms, "polynomials:x^i(1-x)": one space, two bases.
std::string coefficients_csv(std::span<const ResidualStudy> studies);

// problem,basis,method,n,order_L2,order_H1,order_residual,order_max from each n to the next, "16 to 32".
std::string orders_csv(std::span<const ResidualStudy> studies);

// What is printed: the equation, every error with the least of each column marked, orders, refusals.
std::string study_text(const ResidualStudy& study);

}  // namespace app
