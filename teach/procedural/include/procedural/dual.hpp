// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>

namespace texel::procedural {

/// A number that carries its derivatives by u and v (a dual number, forward-mode differentiation): a formula
/// that is written once in Duals gives its value and its exact gradient, by the chain rule and not by
/// differences. Source: Griewank and Walther, Evaluating Derivatives (2008), chapter 3.
struct Dual {
  double value = 0;
  double du = 0;  ///< derivative by u
  double dv = 0;  ///< derivative by v

  Dual() = default;
  Dual(double constant) : value(constant) {}  // not explicit: constants mix with Duals in formulas
  Dual(double value_, double du_, double dv_) : value(value_), du(du_), dv(dv_) {}

  /// u and v themselves, where a formula begins.
  static Dual u(double at) { return {at, 1, 0}; }
  static Dual v(double at) { return {at, 0, 1}; }

  friend Dual operator+(Dual a, Dual b) { return {a.value + b.value, a.du + b.du, a.dv + b.dv}; }
  friend Dual operator-(Dual a, Dual b) { return {a.value - b.value, a.du - b.du, a.dv - b.dv}; }
  friend Dual operator-(Dual a) { return {-a.value, -a.du, -a.dv}; }
  friend Dual operator*(Dual a, Dual b) {
    return {a.value * b.value, a.du * b.value + a.value * b.du, a.dv * b.value + a.value * b.dv};
  }
  friend Dual operator/(Dual a, Dual b) {
    const double q = a.value / b.value;
    return {q, (a.du - q * b.du) / b.value, (a.dv - q * b.dv) / b.value};
  }
  friend bool operator<(Dual a, Dual b) { return a.value < b.value; }

  /// f(a) from f's value and its derivative at a.
  static Dual chain(Dual a, double f, double derivative) { return {f, derivative * a.du, derivative * a.dv}; }
};

inline Dual sin(Dual a) {
  return Dual::chain(a, std::sin(a.value), std::cos(a.value));
}
inline Dual cos(Dual a) {
  return Dual::chain(a, std::cos(a.value), -std::sin(a.value));
}
inline Dual exp(Dual a) {
  return Dual::chain(a, std::exp(a.value), std::exp(a.value));
}
/// The square root of a positive number.
inline Dual sqrt(Dual a) {
  return Dual::chain(a, std::sqrt(a.value), 0.5 / std::sqrt(a.value));
}
/// The absolute value; its derivative jumps at 0.
inline Dual abs(Dual a) {
  return a.value < 0 ? -a : a;
}

/// The plain value, for code that is written for double and Dual alike.
inline double value(double a) {
  return a;
}
inline double value(Dual a) {
  return a.value;
}

/// From a at t = 0 to b at t = 1.
template <class Real>
Real mix(Real a, Real b, Real t) {
  return a + (b - a) * t;
}

/// 0 up to `from`, 1 beyond `to`, between them Perlin's fifth-degree step, whose first and second derivative
/// vanish at both ends (Perlin, Improving Noise, 2002). `from` may lie above `to`: then it falls.
template <class Real>
Real smooth_step(double from, double to, Real x) {
  const Real t = (x - from) / (to - from);
  if (value(t) <= 0) return 0.0;
  if (value(t) >= 1) return 1.0;
  return t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
}

}  // namespace texel::procedural
