#pragma once

#include <cmath>
#include <cstdint>

#include "workspace_support/maths/exponential.h"

namespace workspace_support::maths
{
/// 64 well-mixed bits (the finalizer of SplitMix64).
inline std::uint64_t mixBits(std::uint64_t z)
{
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

/// Random numbers that are the same on every machine for a seed, which the distributions of <random> are not: the
/// standard leaves it open how they compute.
class Random
{
public:
  explicit Random(std::uint64_t seed) : state_(mixBits(seed)) {}

  /// In (0, 1).
  double uniform() { return (static_cast<double>(next() >> 12) + 0.5) * 0x1p-52; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// Of the standard normal distribution: Marsaglia's polar method.
  double gaussian()
  {
    for (;;) {
      const double x = uniform(-1.0, 1.0);
      const double y = uniform(-1.0, 1.0);
      const double square = x * x + y * y;
      if (square < 1.0) {
        return x * std::sqrt(-2.0 * log(square) / square);
      }
    }
  }

private:
  std::uint64_t next() { return mixBits(state_ += 0x9e3779b97f4a7c15ULL); }

  std::uint64_t state_;
};
}  // namespace workspace_support::maths
