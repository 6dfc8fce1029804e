// SPDX-License-Identifier: GPL-3.0-or-later
// Normal equations of polynomials in two variables and their factors, for the innermost loops: sizes are known to the compiler and
// loops are unrolled, since Eigen's decompositions take several times as long at ten unknowns. For the .cpp files of this folder.
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>

namespace loopmend {

/// Σ w uᵃ vᵇ of degree a + b from `least` to `most`. A number may stand for several samples side by side.
template <int least, int most, class Number = double>
class Moments {
 public:
  /// @param zero  which Eigen's arrays are not from the beginning
  explicit Moments(const Number& zero) {
    for (auto& row : sum_) row.fill(zero);
  }
  void add(const Number& weight, const Number& u, const Number& v) {
    std::array<Number, most + 1> power;  // w uᵃ vᵇ of one degree
    power[0] = weight;
    if (least == 0) sum_[0][0] += power[0];
      // Unrolled, the powers stay in registers.
#pragma GCC unroll 8
    for (int d = 1; d <= most; ++d) {
      power[d] = power[d - 1] * v;
#pragma GCC unroll 8
      for (int l = 0; l < d; ++l) power[l] *= u;
      if (d < least) continue;
#pragma GCC unroll 8
      for (int l = 0; l <= d; ++l) sum_[d][l] += power[l];
    }
  }
  void add(const Moments& other) {
#pragma GCC unroll 8
    for (int d = least; d <= most; ++d)
#pragma GCC unroll 8
      for (int l = 0; l <= d; ++l) sum_[d][l] += other.sum_[d][l];
  }
  const Number& operator()(int a, int b) const { return sum_[a + b][b]; }

 private:
  std::array<std::array<Number, most + 1>, most + 1> sum_;  ///< at [a + b][b]
};

inline double inverse_root(double x) { return 1 / std::sqrt(x); }
inline bool may_go_on(double pivot) { return pivot > 0; }
template <int count>
Eigen::Array<double, count, 1> inverse_root(const Eigen::Array<double, count, 1>& x) {
  return 1 / x.sqrt();
}
template <int count>
bool may_go_on(const Eigen::Array<double, count, 1>& pivots) {
  return (pivots > 0).any();
}

/// Of a symmetric positive definite matrix, of which the lower triangle is read. A number may stand for those of
/// several matrices side by side.
template <int size, class Number = double>
class SmallCholesky {
 public:
  using Matrix = Number[size][size];

  /// @returns false if the matrix is not positive definite; of several, if none may be.
  bool factorize(const Matrix& N) {
#pragma GCC unroll 10
    for (int j = 0; j < size; ++j) {
      Number pivot = N[j][j];
#pragma GCC unroll 10
      for (int k = 0; k < j; ++k) pivot -= L_[j][k] * L_[j][k];
      if (!may_go_on(pivot)) return false;
      inverse_[j] = inverse_root(pivot);
#pragma GCC unroll 10
      for (int i = j + 1; i < size; ++i) {
        Number sum = N[i][j];
#pragma GCC unroll 10
        for (int k = 0; k < j; ++k) sum -= L_[i][k] * L_[j][k];
        L_[i][j] = sum * inverse_[j];
      }
    }
    return true;
  }

  /// Whether this one of several matrices is positive definite.
  bool is_factored(int which) const {
    for (const Number& inverse : inverse_)
      if (!(inverse[which] > 0 && std::isfinite(inverse[which]))) return false;
    return true;
  }

  /// @param x  the right-hand side, then the solution; `size`
  void solve(Number* x) const {
#pragma GCC unroll 10
    for (int i = 0; i < size; ++i) {
#pragma GCC unroll 10
      for (int k = 0; k < i; ++k) x[i] -= L_[i][k] * x[k];
      x[i] *= inverse_[i];
    }
#pragma GCC unroll 10
    for (int i = size - 1; i >= 0; --i) {
#pragma GCC unroll 10
      for (int k = i + 1; k < size; ++k) x[i] -= L_[k][i] * x[k];
      x[i] *= inverse_[i];
    }
  }

  /// Of the inverse.
  std::array<Number, size> inverse_diagonal() const {
    std::array<Number, size> diagonal, column;  // of the inverse of L
#pragma GCC unroll 10
    for (int j = 0; j < size; ++j) {
      column[j] = inverse_[j];
      diagonal[j] = column[j] * column[j];
#pragma GCC unroll 10
      for (int i = j + 1; i < size; ++i) {
        Number sum = L_[i][j] * column[j];
#pragma GCC unroll 10
        for (int k = j + 1; k < i; ++k) sum += L_[i][k] * column[k];
        column[i] = -sum * inverse_[i];
        diagonal[j] += column[i] * column[i];
      }
    }
    return diagonal;
  }

  /// Its lower triangle.
  void invert(Matrix& inverse) const {
    Matrix L;  // inverted
#pragma GCC unroll 10
    for (int j = 0; j < size; ++j) {
      L[j][j] = inverse_[j];
#pragma GCC unroll 10
      for (int i = j + 1; i < size; ++i) {
        Number sum = 0;
#pragma GCC unroll 10
        for (int k = j; k < i; ++k) sum -= L_[i][k] * L[k][j];
        L[i][j] = sum * inverse_[i];
      }
    }
#pragma GCC unroll 10
    for (int i = 0; i < size; ++i)
#pragma GCC unroll 10
      for (int j = 0; j <= i; ++j) {
        inverse[i][j] = 0;
#pragma GCC unroll 10
        for (int k = i; k < size; ++k) inverse[i][j] += L[k][i] * L[k][j];
      }
  }

 private:
  Matrix L_;              ///< below the diagonal
  Number inverse_[size];  ///< of the diagonal
};

}  // namespace loopmend
