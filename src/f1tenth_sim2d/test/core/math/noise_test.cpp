#include "core/math/noise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace f1tenth_sim2d::test
{
std::vector<double> samples(std::uint64_t key, std::size_t count)
{
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i) {
    values[i] = gaussian(key, i);
  }
  return values;
}

double moment(const std::vector<double> & values, int order)
{
  double sum = 0.0;
  for (const double value : values) {
    sum += std::pow(value, order);
  }
  return sum / static_cast<double>(values.size());
}

TEST(Noise, HasTheMomentsOfTheNormalDistribution)
{
  const std::vector<double> values = samples(noiseKey(1, 0, NoiseStream::kLidar, 0, 0), 2'000'000);
  EXPECT_NEAR(moment(values, 1), 0.0, 4.0 / std::sqrt(2e6));
  EXPECT_NEAR(moment(values, 2), 1.0, 4.0 * std::sqrt(2.0 / 2e6));
  EXPECT_NEAR(moment(values, 3), 0.0, 4.0 * std::sqrt(15.0 / 2e6));
  EXPECT_NEAR(moment(values, 4), 3.0, 4.0 * std::sqrt(96.0 / 2e6));
}

TEST(Noise, FollowsTheNormalDistributionUpToTheTails)
{
  std::vector<double> values = samples(noiseKey(2, 0, NoiseStream::kLidar, 0, 0), 2'000'000);
  std::sort(values.begin(), values.end());
  double largest_difference = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double expected = 0.5 * std::erfc(-values[i] / std::sqrt(2.0));
    largest_difference = std::max(largest_difference, std::abs(expected - (i + 0.5) / values.size()));
  }
  EXPECT_LT(largest_difference, 1.95 / std::sqrt(2e6));  // Kolmogorov-Smirnov at 0.1 %
  const auto beyond = std::count_if(values.begin(), values.end(), [](double v) { return std::abs(v) > 3.7; });
  EXPECT_NEAR(beyond, 2e6 * std::erfc(3.7 / std::sqrt(2.0)), 4.0 * std::sqrt(431.0));
}

TEST(Noise, IsWhiteAcrossBeams)
{
  const std::vector<double> values = samples(noiseKey(3, 0, NoiseStream::kLidar, 0, 0), 500'000);
  for (std::size_t lag : {1, 2, 3, 7, 256, 1081}) {
    double sum = 0.0;
    for (std::size_t i = lag; i < values.size(); ++i) {
      sum += values[i] * values[i - lag];
    }
    EXPECT_NEAR(sum / static_cast<double>(values.size() - lag), 0.0, 4.0 / std::sqrt(5e5)) << "lag " << lag;
  }
}

TEST(Noise, IsWhiteAcrossScans)
{
  double sum = 0.0;
  double last = 0.0;
  for (std::uint64_t scan = 0; scan < 500'000; ++scan) {
    const double value = gaussian(noiseKey(4, 0, NoiseStream::kLidar, 0, 25'000'000 * scan), 17);
    sum += value * last;
    last = value;
  }
  EXPECT_NEAR(sum / 5e5, 0.0, 4.0 / std::sqrt(5e5));
}

TEST(Noise, EveryPartOfTheKeyMatters)
{
  std::set<std::uint64_t> keys;
  for (std::uint64_t i = 0; i < 16; ++i) {
    keys.insert(noiseKey(i, 1, NoiseStream::kLidar, 2, 3));
    keys.insert(noiseKey(100, 100 + i, NoiseStream::kLidar, 2, 3));
    keys.insert(noiseKey(100, 1, NoiseStream::kLidar, 100 + i, 3));
    keys.insert(noiseKey(100, 1, NoiseStream::kLidar, 2, 100 + i));
  }
  keys.insert(noiseKey(100, 1, NoiseStream::kNamedSensor, 2, 3));
  keys.insert(noiseKey(100, 1, NoiseStream::kOdometry, 2, 3));
  EXPECT_EQ(keys.size(), 66u);
}

TEST(Noise, IsAFunctionOfKeyAndIndexOnly)
{
  const std::uint64_t key = noiseKey(5, 6, NoiseStream::kNamedSensor, 7, 8);
  const double first = gaussian(key, 3);
  gaussian(key, 4);
  EXPECT_EQ(gaussian(key, 3), first);
}
}  // namespace f1tenth_sim2d::test
