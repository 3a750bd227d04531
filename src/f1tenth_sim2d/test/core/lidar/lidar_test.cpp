#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "f1tenth_sim2d/section.h"
#include "sample_world.h"

namespace f1tenth_sim2d::test
{
/// Range along a ray to a wall that is seen from its right side.
double castAtSegment(const Vec2 & from, double angle, const Vec2 & a, const Vec2 & b)
{
  const Vec2 d{std::cos(angle), std::sin(angle)};
  const Vec2 e{b.x - a.x, b.y - a.y};
  const Vec2 f{a.x - from.x, a.y - from.y};
  const double denominator = d.x * e.y - d.y * e.x;
  const double range = (f.x * e.y - f.y * e.x) / denominator;
  const double along = (f.x * d.y - f.y * d.x) / denominator;
  return denominator < 0.0 && range >= 0.0 && along >= 0.0 && along <= 1.0 ? range : kInfinity;
}

/// Range to a circle, which is not seen from inside.
double castAtCircle(const Vec2 & from, double angle, const Circle & circle)
{
  const Vec2 d{std::cos(angle), std::sin(angle)};
  const Vec2 f{circle.centre.x - from.x, circle.centre.y - from.y};
  const double along = f.x * d.x + f.y * d.y;
  const double aside = f.x * d.y - f.y * d.x;
  const double half_squared = circle.radius * circle.radius - aside * aside;
  const bool inside = std::hypot(f.x, f.y) < circle.radius;
  return half_squared >= 0.0 && along > 0.0 && !inside ? along - std::sqrt(half_squared) : kInfinity;
}

struct Scenery
{
  std::vector<Outline> outlines;
  std::vector<Circle> circles;

  double cast(const Vec2 & from, double angle) const
  {
    double range = kInfinity;
    for (const Outline & outline : outlines) {
      for (std::size_t i = 0; i < outline.size(); ++i) {
        range = std::min(range, castAtSegment(from, angle, outline[i], outline[(i + 1) % outline.size()]));
      }
    }
    for (const Circle & circle : circles) {
      range = std::min(range, castAtCircle(from, angle, circle));
    }
    return range;
  }
};

/// Random boxes and cylinders in a field of 30 m, as a world and as plain geometry.
class RandomWorld
{
public:
  explicit RandomWorld(unsigned seed) : random_(seed)
  {
    for (int i = 0; i < 120; ++i) {
      addBox(i);
    }
    for (int i = 0; i < 40; ++i) {
      addCylinder(i);
    }
  }

  WorldDescription description;
  Scenery scenery;

  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }

private:
  void addBox(int number)
  {
    const double length = uniform(0.1, 6.0);
    const double width = uniform(0.02, 0.5);
    const double yaw = uniform(-3.2, 3.2);
    const Vec2 at{uniform(-15, 15), uniform(-15, 15)};
    Solid solid = box("m::l::c", length, width, 1.0, 0, 0, 0);
    solid.pose = Pose3(at.x, at.y, 0.5, 0, 0, yaw);
    description.models.push_back(staticModel("box" + std::to_string(number), solid));
    Outline outline;
    for (const Vec2 & c : {Vec2{-1, -1}, Vec2{1, -1}, Vec2{1, 1}, Vec2{-1, 1}}) {
      const double x = c.x * length / 2;
      const double y = c.y * width / 2;
      outline.push_back({at.x + std::cos(yaw) * x - std::sin(yaw) * y, at.y + std::sin(yaw) * x + std::cos(yaw) * y});
    }
    scenery.outlines.push_back(outline);
  }

  void addCylinder(int number)
  {
    const Vec2 at{uniform(-15, 15), uniform(-15, 15)};
    const double radius = uniform(0.02, 0.8);
    Solid solid{"m::l::c", Cylinder{radius, 1.0}, Pose3(at.x, at.y, 0.5, 0, 0, 0)};
    description.models.push_back(staticModel("cylinder" + std::to_string(number), solid));
    scenery.circles.push_back({at, radius});
  }

  std::mt19937_64 random_;
};

/// A car without a body, so that it can stand anywhere.
CarDescription ghost(const LidarDescription & description)
{
  CarDescription car;
  car.name = "ghost";
  car.lidars = {description};
  return car;
}

/// Compares all beams; where a beam passes within a nanoradian of a corner both sides of the corner are right.
void expectExact(
  const Scenery & scenery, const LidarDescription & lidar, const Pose2 & pose, const std::vector<float> & ranges)
{
  for (int i = 0; i < lidar.beam_count; ++i) {
    const double angle =
      pose.yaw + lidar.angle_min + i * (lidar.angle_max - lidar.angle_min) / std::max(1, lidar.beam_count - 1);
    double expected = scenery.cast({pose.x, pose.y}, angle);
    expected = expected > lidar.range_max ? kInfinity : expected < lidar.range_min ? -kInfinity : expected;
    if (std::isinf(expected) || std::isinf(ranges[i])) {
      ASSERT_EQ(ranges[i], expected) << "beam " << i << " at " << pose.x << " " << pose.y << " " << pose.yaw;
    } else {
      ASSERT_NEAR(ranges[i], expected, 1e-5) << "beam " << i << " at " << pose.x << " " << pose.y << " " << pose.yaw;
    }
  }
}

class LidarOfFieldOfView : public ::testing::TestWithParam<double>
{
};

TEST_P(LidarOfFieldOfView, AgreesWithRayCastingFromRandomPoses)
{
  RandomWorld random(7);
  LidarDescription lidar = test::lidar();
  lidar.pose = Pose3(0, 0, 0.5, 0, 0, 0);
  lidar.angle_min = -0.4 * GetParam();
  lidar.angle_max = 0.6 * GetParam();
  for (int i = 0; i < 60; ++i) {
    const Pose2 pose{random.uniform(-16, 16), random.uniform(-16, 16), random.uniform(-7, 7)};
    Simulation simulation(random.description);
    simulation.addCar(ghost(lidar), {}, pose);
    std::vector<float> ranges(lidar.beam_count);
    simulation.exactScan(kRobot1, 0, ranges.data());
    expectExact(random.scenery, lidar, pose, ranges);
  }
}
INSTANTIATE_TEST_SUITE_P(Radians, LidarOfFieldOfView, ::testing::Values(0.5, 3.0, 4.7, 6.2831, 7.5));
}  // namespace f1tenth_sim2d::test
