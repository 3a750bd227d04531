#pragma once

#include <workspace_support/maths/random.h>

#include <cstddef>
#include <cstdint>
#include <string>

/// Counter-based noise: a sample is a function of its key and its index only. Nothing is remembered between
/// samples, so which sensors are read, and how often, changes nothing.
namespace f1tenth_sim2d
{
/// What draws noise; keeps the streams of one car apart.
enum class NoiseStream : std::uint64_t
{
  kLidar,
  kOdometry = 2,
  kNamedSensor
};

using workspace_support::maths::mixBits;

/// @param sensor   which one of that kind
/// @param instant  time or number of the sample
std::uint64_t noiseKey(
  std::uint64_t seed, std::uint64_t car, NoiseStream stream, std::uint64_t sensor, std::uint64_t instant);

/// 64 bits that tell names apart: FNV-1a.
std::uint64_t hashOf(const std::string & name);

/// Samples 0 to count - 1 of the standard normal distribution under a key.
void gaussians(std::uint64_t key, std::size_t count, double * samples);

/// Sample `index` of the standard normal distribution under a key.
double gaussian(std::uint64_t key, std::uint64_t index);
}  // namespace f1tenth_sim2d
