// Numbers of the weighted residual methods, and functions of x in [0,1].
#pragma once

#include <Eigen/Core>
#include <functional>

namespace sim::residual {

// Methods with smooth bases reach errors of 1e-10 with eight terms. To tell them to eight digits, arithmetic must carry
// more than the 16 digits of double; systems are small here, so it may be slow.
using Real = long double;
using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;

// A value with its derivative in x.
struct Jet {
  Real value = 0, slope = 0;
};
using Function = std::function<Jet(Real)>;

}  // namespace sim::residual
