#include "beams.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace amcl
{
namespace
{
// Not symmetric about the lidar's axis.
Scan halfScan()
{
  Scan scan{0.0, 0.1, 0.1, 10.0, {}};
  for (int i = 0; i < 11; ++i) {
    scan.ranges.push_back(1.0F + 0.1F * static_cast<float>(i));
  }
  return scan;
}

double angleOf(const Beam & beam)
{
  return std::atan2(beam.direction.y, beam.direction.x);
}

TEST(UsedBeams, AreSpreadAndKeepTheirAngles)
{
  LaserOptions options;
  options.max_beams = 6;
  const Beams used = usedBeams(halfScan(), {0.2, 0.0, 0.3}, options);
  ASSERT_EQ(used.beams.size(), 6U);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_FLOAT_EQ(static_cast<float>(used.beams[i].range), 1.0F + 0.2F * static_cast<float>(i));
    EXPECT_NEAR(angleOf(used.beams[i]), 0.3 + 0.2 * static_cast<double>(i), 1e-12);
  }
  EXPECT_DOUBLE_EQ(used.lidar.x, 0.2);
}

TEST(UsedBeams, OfALidarUpsideDownGoTheOtherWay)
{
  Scan scan = halfScan();
  scan.angle_increment = -0.1;
  const Beams used = usedBeams(scan, {}, LaserOptions{});
  EXPECT_NEAR(angleOf(used.beams.front()), 0.0, 1e-12);
  EXPECT_NEAR(angleOf(used.beams.back()), -1.0, 1e-12);
}

TEST(UsedBeams, AreNeverMoreThanAskedFor)
{
  LaserOptions options;
  for (options.max_beams = 2; options.max_beams < 20; ++options.max_beams) {
    EXPECT_LE(usedBeams(halfScan(), {}, options).beams.size(), static_cast<std::size_t>(options.max_beams));
  }
}

TEST(UsedBeams, HaveAnEchoWithinRange)
{
  Scan scan = halfScan();
  scan.ranges = {std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN(), 0.05F, 10.0F, 3.0F};
  const Beams used = usedBeams(scan, {}, LaserOptions{});
  ASSERT_EQ(used.beams.size(), 1U);
  EXPECT_NEAR(angleOf(used.beams[0]), 0.4, 1e-12);
  LaserOptions short_sighted;
  short_sighted.max_range = 2.5;
  EXPECT_TRUE(usedBeams(scan, {}, short_sighted).beams.empty());
}
}  // namespace
}  // namespace amcl
