// Values at a point for the eye: von Mises stress, largest stretch, energy density, J.
#pragma once

#include "sim/material/tangent.h"
#include "sim/math/volume.h"
#include "sim/report.h"

namespace sim {

// von Mises of the Cauchy stress sigma = P F^T/|J| [Pa]: sqrt(3/2 dev:dev). Plane strain has a stress across the
// plane that a plane energy does not know; it is taken as nu (sigma_xx + sigma_yy), exact at small strain.
template <class T, int D>
T von_mises(const Mat<T, D, D>& sigma, double poisson) {
  T across = T(0);
  if constexpr (D == 2) across = T(poisson) * trace(sigma);
  const T mean = (trace(sigma) + across) / T(3);
  T dev = D == 2 ? (across - mean) * (across - mean) : T(0);
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) {
      const T d = i == j ? sigma(i, j) - mean : T(0.5) * (sigma(i, j) + sigma(j, i));
      dev += d * d;
    }
  return square_root(T(1.5) * dev);
}

template <class Material, class T, int D, int M>
T value_at(Quantity quantity, const Material& material, const Mat<T, D, M>& F, double poisson) {
  switch (quantity) {
    case Quantity::J:
      return volume_ratio(F);
    case Quantity::energy:
      return material.psi(F);
    case Quantity::stretch:
      return absolute(svd(F).s[0]);
    case Quantity::pressure:  // not of an element
    case Quantity::stress:
      break;
  }
  const T J = maximum(absolute(volume_ratio(F)), T(1e-12));
  return von_mises((T(1) / J) * times_transpose(material.P(F), F), poisson);
}

}  // namespace sim
