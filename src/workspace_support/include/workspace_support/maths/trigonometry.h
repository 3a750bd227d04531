#pragma once

#include <cmath>

/// Functions whose results are the same on every machine. Those of the C library differ in the last bit from one version
/// to the next and between processors with and without fused multiply-add; these consist of additions, multiplications,
/// divisions and square roots, whose results IEEE 754 fixes. (Compile with -ffp-contract=off, as workspace_target does.)
/// What the C library computes exactly (sqrt, floor, remainder, fmod, ldexp, …) needs no twin here.
namespace workspace_support::maths
{
constexpr double kRoughAngleError = 1e-7;  // rad

/// atan2(y, x) to within kRoughAngleError, without a branch: Abramowitz and Stegun, 4.4.49, error below 2e-8.
/// Not a number for the origin.
inline double roughAngle(double y, double x)
{
  const double across = std::abs(x);
  const double up = std::abs(y);
  const bool is_steep = up > across;
  const double t = (is_steep ? across : up) / (is_steep ? up : across);
  const double u = t * t;
  double series = 0.0028662257;
  series = series * u - 0.0161657367;
  series = series * u + 0.0429096138;
  series = series * u - 0.0752896400;
  series = series * u + 0.1065626393;
  series = series * u - 0.1420889944;
  series = series * u + 0.1999355085;
  series = series * u - 0.3333314528;
  const double octant = t * (series * u + 1.0);
  const double quadrant = is_steep ? 0.5 * M_PI - octant : octant;
  return std::copysign(x < 0.0 ? M_PI - quadrant : quadrant, y);
}

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

/// Within 1e-15 rad; 0 for the origin; not a number for what is not finite.
inline double atan2(double y, double x)
{
  if (x == 0.0 && y == 0.0) {
    return 0.0;
  }
  // One step of Newton's method: from 1e-7 the error falls to its cube.
  const double rough = roughAngle(y, x);
  const SineCosine at = sineCosine(rough);
  return rough + (y * at.cosine - x * at.sine) / (x * at.cosine + y * at.sine);
}
inline double sin(double angle)
{
  return sineCosine(angle).sine;
}
inline double cos(double angle)
{
  return sineCosine(angle).cosine;
}
/// Within 4 ulp.
inline double tan(double angle)
{
  const SineCosine at = sineCosine(angle);
  return at.sine / at.cosine;
}
inline double atan(double slope)
{
  return atan2(slope, 1.0);
}
/// Not a number outside of [-1, 1].
inline double asin(double sine)
{
  return atan2(sine, std::sqrt((1.0 - sine) * (1.0 + sine)));
}
/// Not a number outside of [-1, 1].
inline double acos(double cosine)
{
  return atan2(std::sqrt((1.0 - cosine) * (1.0 + cosine)), cosine);
}
/// Within 1.5 ulp; the squares must not overflow.
inline double hypot(double x, double y)
{
  return std::sqrt(x * x + y * y);
}
}  // namespace workspace_support::maths
