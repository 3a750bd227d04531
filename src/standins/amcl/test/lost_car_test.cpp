#include "lost_car.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "amcl/localizer.h"
#include "engine_types.h"
#include "road.h"
#include "rooms.h"

namespace amcl
{
namespace
{
// Without its pillar, the room looks the same turned around; with its corner at the origin, as MRPT's maps have.
OccupancyGrid emptyRoom()
{
  OccupancyGrid grid = room({});
  for (int y = 60; y < 80; ++y) {
    std::fill_n(grid.cells.begin() + y * 160 + 120, 10, 0);
  }
  return grid;
}

std::vector<Place> lookFrom(LostCar & car, const OccupancyGrid & grid, const Pose2 & pose)
{
  return car.look(*toObservation(scanOn(grid, pose), {}, LaserOptions{}), pose);
}

LostCar lostIn(const OccupancyGrid & grid)
{
  const auto map = toGridMap(grid, LaserOptions{});
  return {*map, roadAbout(*map, {1.0, 1.0, 0.0})};
}

double shareAbout(const std::vector<Place> & places, const Pose2 & pose)
{
  double share = 0.0;
  for (const Place & place : places) {
    share += distance(place.pose, pose) < 1.0 && std::abs(place.pose.yaw - pose.yaw) < 0.1 ? place.fit : 0.0;
  }
  return share;
}

TEST(LostCar, IsFoundWhereItCanBeOnlyAtOnePlace)
{
  LostCar car = lostIn(room({}));
  const auto places = lookFrom(car, room({}), {2.03, 1.52, 0.7});
  ASSERT_FALSE(places.empty());
  EXPECT_NEAR(places.front().pose.x, 2.03, 0.05);
  EXPECT_NEAR(places.front().pose.y, 1.52, 0.05);
  EXPECT_NEAR(places.front().pose.yaw, 0.7, 0.02);
  EXPECT_GT(shareAbout(places, {2.03, 1.52, 0.7}), 0.99);
}

TEST(LostCar, IsLookedForUntilThereHasBeenOnePlaceForSomeMetres)
{
  LostCar car = lostIn(room({}));
  for (int i = 0; i < 5; ++i) {
    EXPECT_FALSE(car.isOver()) << i;
    lookFrom(car, room({}), {1.5 + 1.1 * i, 1.5, 0.0});
  }
  EXPECT_TRUE(car.isOver());
}

TEST(LostCar, IsAtBothOfTwoPlacesThatLookAlike)
{
  LostCar car = lostIn(emptyRoom());
  double here = 0.0;
  double there = 0.0;
  for (const Place & place : lookFrom(car, emptyRoom(), {2.03, 1.52, 0.7})) {
    here += std::hypot(place.pose.x - 2.03, place.pose.y - 1.52) < 0.2 ? place.fit : 0.0;
    there += std::hypot(place.pose.x - 5.97, place.pose.y - 3.48) < 0.2 ? place.fit : 0.0;
  }
  EXPECT_GT(here, 0.1);
  EXPECT_GT(there, 0.1);
  EXPECT_FALSE(car.isOver());
}

TEST(LostCar, IsNotSaidToBeAtOneOfTheseForCertain)
{
  const OccupancyGrid grid = emptyRoom();
  Estimate start;
  start.pose = {1.0, 1.0, 0.0};
  const auto localizer = Localizer::make(grid, LocalizerOptions(), start);
  localizer->spreadOut();
  localizer->process(scanOn(grid, {2.03, 1.52, 0.7}), {}, {});
  const auto covariance = localizer->estimate().covariance;
  EXPECT_GT(std::sqrt(covariance[0] + covariance[4]), 1.0);
  EXPECT_GT(std::sqrt(covariance[8]), 1.0);
}

TEST(LostCar, IsLookedForAgainAfterAMetre)
{
  LostCar car = lostIn(emptyRoom());
  EXPECT_FALSE(lookFrom(car, emptyRoom(), {2.0, 1.5, 0.0}).empty());
  EXPECT_TRUE(lookFrom(car, emptyRoom(), {2.9, 1.5, 0.0}).empty());
  EXPECT_FALSE(lookFrom(car, emptyRoom(), {3.1, 1.5, 0.0}).empty());
}

TEST(LostCar, IsNotLookedForAnyLongerWhereNothingTellsPlacesApart)
{
  LostCar car = lostIn(emptyRoom());
  for (int i = 0; i < 40; ++i) {
    EXPECT_FALSE(car.isOver()) << i;
    lookFrom(car, emptyRoom(), {i % 2 == 0 ? 2.0 : 3.1, 1.5, 0.0});
  }
  EXPECT_TRUE(car.isOver());
}

TEST(LostCar, IsLookedForAboutThereIfItIsKnownAboutWhere)
{
  const auto map = toGridMap(emptyRoom(), LaserOptions{});
  LostCar car(*map, std::vector<Pose2>{{2.1, 1.4, 0.65}, {4.0, 2.0, 0.0}});
  const auto places = lookFrom(car, emptyRoom(), {2.03, 1.52, 0.7});
  ASSERT_FALSE(places.empty());
  EXPECT_NEAR(places.front().pose.x, 2.03, 0.05);
  EXPECT_NEAR(places.front().pose.y, 1.52, 0.05);
  EXPECT_GT(shareAbout(places, {2.03, 1.52, 0.7}), 0.99);
}

TEST(LostCar, RemembersOnAStraightWhatItHasSeenBefore)
{
  const OccupancyGrid grid = room(800, 40, {100, 110, 25, 30}, {});  // 40 m by 2 m, with the pillar at its beginning
  LostCar car = lostIn(grid);
  for (double x = 2.0; x < 22.0; x += 1.1) {
    const auto places = lookFrom(car, grid, {x, 0.8, 0.0});
    EXPECT_GT(shareAbout(places, {x, 0.8, 0.0}), 0.9) << x;
  }
  LostCar other = lostIn(grid);
  EXPECT_LT(shareAbout(lookFrom(other, grid, {19.0, 0.8, 0.0}), {19.0, 0.8, 0.0}), 0.5);
}

TEST(LostCar, SeesNothingWithoutAnEcho)
{
  LostCar car = lostIn(emptyRoom());
  Scan scan = scanOn(emptyRoom(), {2.0, 1.5, 0.0});
  std::fill(scan.ranges.begin(), scan.ranges.end(), 10.0F);
  EXPECT_TRUE(car.look(*toObservation(scan, {}, LaserOptions{}), {}).empty());
  EXPECT_FALSE(car.isOver());
}
}  // namespace
}  // namespace amcl
