#pragma once

#include <cmath>

#include "core/math/rough_angle.h"

/// Our own sine, cosine and arc tangent. Those of the C library differ in the last bit from one version to the next and
/// between processors with and without fused multiply-add; these consist of additions, multiplications and divisions,
/// whose results IEEE 754 fixes, so that a trajectory is the same everywhere. They are also several times as fast,
/// because they can be inlined.
namespace f1tenth_sim2d
{
struct SineCosine
{
  double sine;
  double cosine;
};

/// Within 2 ulp of 1 for |angle| < 1e5 rad; larger angles are brought down by whole turns first; not a number
/// for what is not finite.
inline SineCosine sineCosine(double angle)
{
  // Quarter turns are taken off in three parts (Cody and Waite): pi / 2 to 33, 66 and 119 bits.
  constexpr double kQuarter1 = 0x1.921fb544p+0;
  constexpr double kQuarter2 = 0x1.0b4611a6p-34;
  constexpr double kQuarter3 = 0x1.3198a2e037073p-69;
  constexpr double kRounder = 0x1.8p+52;  // adding it rounds to a whole number
  constexpr double kLargest = 1e5;        // rad
  if (!(std::abs(angle) < kLargest)) {
    angle = std::remainder(angle, 2.0 * M_PI);
    if (std::isnan(angle)) {
      return {angle, angle};
    }
  }
  const double quarters = (angle * (2.0 / M_PI) + kRounder) - kRounder;
  const double x = ((angle - quarters * kQuarter1) - quarters * kQuarter2) - quarters * kQuarter3;
  const double u = x * x;
  // Taylor series; within pi / 4 the first term left out is below 5e-17.
  double s = -7.647163731819816e-13;   // -1/15!
  s = s * u + 1.6059043836821613e-10;  // 1/13!
  s = s * u - 2.505210838544172e-08;   // -1/11!
  s = s * u + 2.7557319223985893e-06;  // 1/9!
  s = s * u - 1.984126984126984e-04;   // -1/7!
  s = s * u + 8.333333333333333e-03;   // 1/5!
  s = s * u - 1.6666666666666666e-01;  // -1/3!
  double c = 4.779477332387385e-14;    // 1/16!
  c = c * u - 1.1470745597729725e-11;  // -1/14!
  c = c * u + 2.08767569878681e-09;    // 1/12!
  c = c * u - 2.755731922398589e-07;   // -1/10!
  c = c * u + 2.48015873015873e-05;    // 1/8!
  c = c * u - 1.388888888888889e-03;   // -1/6!
  c = c * u + 4.1666666666666664e-02;  // 1/4!
  const double sine = x + x * (u * s);
  const double cosine = 1.0 - (0.5 * u - u * (u * c));
  const int quadrant = static_cast<int>(quarters) & 3;
  const bool is_odd = (quadrant & 1) != 0;
  const double first = is_odd ? cosine : sine;
  const double second = is_odd ? sine : cosine;
  return {(quadrant & 2) != 0 ? -first : first, ((quadrant + 1) & 2) != 0 ? -second : second};
}

/// atan2(y, x) to within 1e-15 rad, 0 for the origin.
inline double direction(double y, double x)
{
  if (x == 0.0 && y == 0.0) {
    return 0.0;
  }
  // One step of Newton's method: from 1e-7 the error falls to its cube.
  const double rough = roughAngle(y, x);
  const SineCosine at = sineCosine(rough);
  return rough + (y * at.cosine - x * at.sine) / (x * at.cosine + y * at.sine);
}
}  // namespace f1tenth_sim2d
