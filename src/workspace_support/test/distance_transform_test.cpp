#include "workspace_support/distance_transform.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace workspace_support
{
namespace
{
float nearestByTrial(const std::vector<std::uint8_t> & marked, int width, int height, int x, int y)
{
  double least = width + height;
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      if (marked[static_cast<std::size_t>(v) * width + u] != 0) {
        least = std::min(least, std::hypot(u - x, v - y));
      }
    }
  }
  return static_cast<float>(least);
}

TEST(DistanceTransform, equalsTheDistanceFoundByTrial)
{
  constexpr int kWidth = 37;
  constexpr int kHeight = 23;
  std::mt19937 random(7);
  for (int round = 0; round < 5; ++round) {
    std::vector<std::uint8_t> marked(kWidth * kHeight);
    for (auto & cell : marked) {
      cell = random() % 40 == 0 ? 1 : 0;
    }
    const std::vector<float> distances = distanceTransform(marked, kWidth, kHeight);
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        ASSERT_FLOAT_EQ(
          distances[static_cast<std::size_t>(y) * kWidth + x], nearestByTrial(marked, kWidth, kHeight, x, y));
      }
    }
  }
}

TEST(DistanceTransform, isWidthPlusHeightWithoutAMarkedCell)
{
  for (const float value : distanceTransform(std::vector<std::uint8_t>(12, 0), 4, 3)) {
    EXPECT_FLOAT_EQ(value, 7.0F);
  }
}
}  // namespace
}  // namespace workspace_support
