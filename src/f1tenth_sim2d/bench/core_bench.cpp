// Where the time of the core goes: one car laps a round track of 100 wall boxes.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include "f1tenth_sim2d/simulation.h"

namespace
{
using namespace f1tenth_sim2d;

constexpr double kPi = 3.14159265358979323846;
constexpr int kWallsPerSide = 50;
constexpr double kRadius = 6.0;     // m, of the centre line
constexpr double kHalfWidth = 0.9;  // m

/// Two rings of straight walls, as the Building Editor would write a round track.
WorldDescription ringTrack()
{
  WorldDescription world;
  world.file = "bench";
  ModelDescription model;
  model.name = "walls";
  model.is_static = true;
  for (const double radius : {kRadius - kHalfWidth, kRadius + kHalfWidth}) {
    for (int i = 0; i < kWallsPerSide; ++i) {
      const double angle = 2.0 * kPi * i / kWallsPerSide;
      const double length = 2.0 * radius * std::tan(kPi / kWallsPerSide) + 0.15;
      const ignition::math::Pose3d pose(
        radius * std::cos(angle), kRadius + radius * std::sin(angle), 1.25, 0, 0, angle + kPi / 2);
      model.solids.push_back(
        {"walls::Wall_" + std::to_string(model.solids.size()) + "::c", Box{{length, 0.15, 2.5}}, pose});
    }
  }
  world.models.push_back(model);
  return world;
}

CarDescription carWithLidar()
{
  CarDescription car;
  car.name = "robot1";
  car.solids = {{"car::chassis::c", Box{{0.49, 0.24, 0.1}}, ignition::math::Pose3d(0.15, 0, 0.07, 0, 0, 0)}};
  LidarDescription lidar;
  lidar.pose = ignition::math::Pose3d(0.27, 0, 0.11, 0, 0, 0);
  lidar.angle_min = -0.75 * kPi;
  lidar.angle_max = 0.75 * kPi;
  lidar.noise_stddev = 0.01;
  car.lidars.push_back(lidar);
  return car;
}

/// CPU time of this program, s: what a busy machine does besides does not count.
double now()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Keeps the car on the centre line.
DriveCommand follow(const CarState & state)
{
  const double x = state.pose.x;
  const double y = state.pose.y - kRadius;
  const double aside = std::hypot(x, y) - kRadius;
  const double course = std::atan2(y, x) + kPi / 2;
  const double heading_error = std::remainder(course - state.pose.yaw, 2.0 * kPi);
  return {3.0, std::atan(0.33 / kRadius) + 1.5 * heading_error + 0.8 * aside};
}

template <typename Work>
double microseconds(int count, Work work)
{
  const double start = now();
  for (int i = 0; i < count; ++i) {
    work();
  }
  return (now() - start) / count * 1e6;
}
}  // namespace

int main(int argc, char ** argv)
{
  const double seconds = argc > 1 ? std::atof(argv[1]) : 60.0;
  Simulation simulation(ringTrack());
  simulation.addCar(carWithLidar(), {}, {});
  std::vector<float> ranges(1081);

  const double start = now();
  const SimTime end = static_cast<SimTime>(seconds * 1e9);
  while (simulation.time() < end) {
    simulation.command(CarId{0}, follow(simulation.state(CarId{0})));
    simulation.advanceTo(simulation.time() + 25'000'000);
    simulation.scan(CarId{0}, 0, ranges.data());
  }
  std::printf("real-time factor      %8.0f\n", seconds / (now() - start));
  std::printf("contacts              %8zu\n", simulation.contacts(CarId{0}).size());
  std::printf("clearance             %8.3f m\n", simulation.clearance(CarId{0}, 5.0));
  std::printf(
    "exact scan            %8.2f us\n", microseconds(20000, [&] { simulation.exactScan(CarId{0}, 0, ranges.data()); }));
  std::printf(
    "scan with noise       %8.2f us\n", microseconds(20000, [&] { simulation.scan(CarId{0}, 0, ranges.data()); }));
  std::printf("clearance             %8.2f us\n", microseconds(20000, [&] { simulation.clearance(CarId{0}, 5.0); }));
  std::printf("step                  %8.3f us\n", microseconds(200000, [&] { simulation.step(); }));
  std::printf("reset                 %8.2f us\n", microseconds(1000, [&] { simulation.reset(); }));
  return 0;
}
