#pragma once

#include <cmath>
#include <limits>

/// Exponential and logarithm with the same bits on every machine; see trigonometry.h.
namespace workspace_support::maths
{
/// Within 1 ulp; 0 or infinity where the result is out of range.
inline double exp(double x)
{
  constexpr double kPerLog2 = 0x1.71547652b82fep+0;  // 1 / log(2)
  // log(2) to 32 bits, so that whole multiples are exact, and the rest.
  constexpr double kLog2High = 0x1.62e42fee00000p-1;
  constexpr double kLog2Low = 0x1.a39ef35793c76p-33;
  constexpr double kRounder = 0x1.8p+52;  // adding it rounds to a whole number
  if (!(std::abs(x) < 746.0)) {
    return x > 0.0 ? std::numeric_limits<double>::infinity() : x < 0.0 ? 0.0 : x;
  }
  const double doublings = (x * kPerLog2 + kRounder) - kRounder;
  const double r = (x - doublings * kLog2High) - doublings * kLog2Low;
  // Taylor series; within log(2) / 2 the first term left out is below 1e-17.
  double p = 1.6059043836821613e-10;  // 1/13!
  p = p * r + 2.08767569878681e-09;   // 1/12!
  p = p * r + 2.505210838544172e-08;  // 1/11!
  p = p * r + 2.755731922398589e-07;  // 1/10!
  p = p * r + 2.7557319223985893e-06;
  p = p * r + 2.48015873015873e-05;
  p = p * r + 1.984126984126984e-04;
  p = p * r + 1.388888888888889e-03;
  p = p * r + 8.333333333333333e-03;
  p = p * r + 4.1666666666666664e-02;
  p = p * r + 1.6666666666666666e-01;  // 1/3!
  p = p * r + 0.5;
  return std::ldexp(1.0 + (r + r * r * p), static_cast<int>(doublings));
}

/// Within 1 ulp; -infinity for 0, not a number below.
inline double log(double x)
{
  constexpr double kLog2High = 0x1.62e42fee00000p-1;
  constexpr double kLog2Low = 0x1.a39ef35793c76p-33;
  if (!(x > 0.0) || std::isinf(x)) {
    return x == 0.0 ? -std::numeric_limits<double>::infinity() : x < 0.0 ? std::numeric_limits<double>::quiet_NaN() : x;
  }
  int doublings = 0;
  double m = std::frexp(x, &doublings);
  if (m < M_SQRT1_2) {
    m *= 2.0;
    --doublings;
  }
  // log(1 + f) = 2 artanh(s); the first term left out is below 1e-18.
  const double f = m - 1.0;
  const double s = f / (2.0 + f);
  const double z = s * s;
  double series = 2.0 / 21.0;
  for (int odd = 19; odd >= 3; odd -= 2) {
    series = series * z + 2.0 / odd;
  }
  const double half_square = 0.5 * f * f;
  const double rest = half_square - (s * (half_square + z * series) + doublings * kLog2Low);
  return doublings * kLog2High - (rest - f);
}

/// x^y of a positive x; the relative error is below (2 + |y log(x)|) 2e-16. Whole powers are better multiplied.
inline double pow(double x, double y)
{
  return exp(y * log(x));
}

/// The root of x^3, within 2 ulp.
inline double cbrt(double x)
{
  if (x == 0.0 || !std::isfinite(x)) {
    return x;
  }
  const double rough = std::copysign(pow(std::abs(x), 1.0 / 3.0), x);
  return rough - (rough - x / (rough * rough)) / 3.0;
}
}  // namespace workspace_support::maths
