#include "core/lidar/scan_space.h"

#include <gtest/gtest.h>

#include <functional>
#include <vector>

#include "sample_world.h"

namespace f1tenth_sim2d::test
{
TEST(ScanSpaces, LendTheSameSpaceAgainWhenItHasComeBack)
{
  ScanSpaces spaces(beamsOf(lidar()), 4);
  const ScanSpace * const first = spaces.borrow().get();
  EXPECT_EQ(spaces.borrow().get(), first);
}

TEST(ScanSpaces, LendEachSpaceToOneOnly)
{
  ScanSpaces spaces(beamsOf(lidar()), 4);
  const ScanSpaces::Loan first = spaces.borrow();
  const ScanSpaces::Loan second = spaces.borrow();
  EXPECT_NE(first.get(), second.get());
  EXPECT_EQ(second->raster.beamCount(), lidar().beam_count);
}

TEST(Beams, AreThoseOfWhoeverLooksTheSameWays)
{
  LidarDescription same = lidar();
  same.noise_stddev += 0.1;
  same.range_min += 0.1;
  same.range_max -= 0.1;
  same.pose.position.x() += 1.0;
  EXPECT_TRUE(beamsOf(lidar()) == beamsOf(same));
  const std::vector<std::function<void(LidarDescription &)>> changes{
    [](LidarDescription & other) { --other.beam_count; }, [](LidarDescription & other) { other.angle_min += 0.1; },
    [](LidarDescription & other) { other.angle_max -= 0.1; }};
  for (std::size_t i = 0; i < changes.size(); ++i) {
    LidarDescription other = lidar();
    changes[i](other);
    EXPECT_FALSE(beamsOf(lidar()) == beamsOf(other)) << "change " << i;
  }
}
}  // namespace f1tenth_sim2d::test
