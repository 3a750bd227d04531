// The work of core_steps_100hz without Python, to be run under valgrind --tool=callgrind: one car on a track, a scan with
// noise and 10 ms of physics a step.
//   track_bench MAP.yaml [SECONDS]
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <vector>

#include "../examples/gap_follower.h"
#include "f1tenth_sim2d/errors.h"
#include "f1tenth_sim2d/loaders.h"
#include "f1tenth_sim2d/simulation.h"

namespace
{
using namespace f1tenth_sim2d;

constexpr SimTime kPeriod = 10'000'000;  // ns
constexpr int kBeams = 1080;
constexpr double kMaxAngle = 2.35;  // rad

CarDescription carWithLidar()
{
  CarDescription car;
  car.name = "robot1";
  car.solids = {{"car::chassis::c", Box{{0.49, 0.24, 0.1}}, ignition::math::Pose3d(0.15, 0, 0.07, 0, 0, 0)}};
  LidarDescription lidar;
  lidar.pose = ignition::math::Pose3d(0.27, 0, 0.11, 0, 0, 0);
  lidar.beam_count = kBeams;
  lidar.angle_min = -kMaxAngle;
  lidar.angle_max = kMaxAngle;
  lidar.range_max = 30.0;
  lidar.noise_stddev = 0.01;
  car.lidars.push_back(lidar);
  return car;
}

/// FNV-1a of the bits of all ranges so far.
std::uint64_t mixed(std::uint64_t hash, const std::vector<float> & ranges)
{
  for (const float range : ranges) {
    std::uint32_t bits = 0;
    std::memcpy(&bits, &range, sizeof bits);
    hash = (hash ^ bits) * 0x100000001b3ULL;
  }
  return hash;
}

void lap(const char * map, double seconds)
{
  const WorldDescription world = loadWorld(map);
  Simulation simulation(world);
  simulation.addCar(carWithLidar(), {}, world.start);
  gap_follower::GapFollower driver;
  std::vector<float> ranges(kBeams);
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  std::clock_t spent = 0;
  const auto steps = static_cast<int>(seconds * 1e9 / kPeriod);
  for (int step = 0; step < steps; ++step) {
    const gap_follower::Command command = driver.drive({-kMaxAngle, 2.0 * kMaxAngle / (kBeams - 1), ranges});
    const std::clock_t start = std::clock();
    simulation.command(CarId{0}, {command.speed, command.steering_angle});
    simulation.advanceTo(simulation.time() + kPeriod);
    simulation.scan(CarId{0}, 0, ranges.data());
    spent += std::clock() - start;
    hash = mixed(hash, ranges);
  }
  const CarState & state = simulation.state(CarId{0});
  std::printf("steps per second of processor time  %8.0f\n", steps * static_cast<double>(CLOCKS_PER_SEC) / spent);
  std::printf("hash of all ranges                  %016llx\n", static_cast<unsigned long long>(hash));
  std::printf("car at                              (%.3f, %.3f)\n", state.pose.x, state.pose.y);
}
}  // namespace

int main(int argc, char ** argv)
{
  if (argc < 2) {
    std::fprintf(stderr, "usage: track_bench MAP.yaml [SECONDS]\n");
    return 2;
  }
  try {
    lap(argv[1], argc > 2 ? std::atof(argv[2]) : 30.0);
  } catch (const Error & error) {
    std::fprintf(stderr, "track_bench: %s\n", error.what());
    return 2;
  }
  return 0;
}
