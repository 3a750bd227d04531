#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "f1tenth_sim2d/geometry.h"

/// Inputs and outputs of a Simulation.
namespace f1tenth_sim2d
{
/// Simulated time, ns since the start.
using SimTime = std::int64_t;

constexpr double kNanosecondsPerSecond = 1e9;

inline SimTime fromSeconds(double seconds)
{
  return std::llround(seconds * kNanosecondsPerSecond);
}
inline double toSeconds(SimTime time)
{
  return static_cast<double>(time) / kNanosecondsPerSecond;
}

/// A car of one Simulation, from addCar() to removeCar(). Cars are numbered from 0 in the order in which they are
/// added; the number of a removed car is never reused.
enum class CarId : std::uint32_t
{
};

/// What a driver asks a car for.
struct DriveCommand
{
  double speed{0.0};           ///< m/s
  double steering_angle{0.0};  ///< rad
};

struct TwistCommand
{
  Vec2 velocity;         ///< m/s, in the frame of the car; y is for planar drives only
  double yaw_rate{0.0};  ///< rad/s
};

/// True state of a car. Pose and velocity are those of its own frame, on the ground below the middle of the rear axle.
/// base_footprint need not be there: CarDescription::base_frame_pose is its pose in that frame.
struct CarState
{
  Pose2 pose;                            ///< in the world
  Vec2 velocity;                         ///< m/s, in the frame of the car
  double yaw_rate{0.0};                  ///< rad/s
  Vec2 acceleration;                     ///< m/s^2, of the centre of mass, in the frame of the car
  double steering_angle{0.0};            ///< rad, of the single-track front wheel
  std::array<double, 4> wheel_angles{};  ///< rad: front left, front right, rear left, rear right
  std::array<double, 4> wheel_speeds{};  ///< rad/s, same order
};

/// Where a model of the world is and how it moves; pose and velocity are those of the model's frame, in the world.
struct ModelState
{
  Pose2 pose;
  Vec2 velocity;         ///< m/s
  double yaw_rate{0.0};  ///< rad/s
};

/// Wheel odometry: dead reckoning from noisy speed and steering, from the spawn pose.
struct WheelOdometry
{
  Pose2 pose;
  double speed{0.0};          ///< m/s, along the car
  double yaw_rate{0.0};       ///< rad/s
  double lateral_speed{0.0};  ///< m/s, to the left; of a planar drive only
};

/// One contact of a car's collision element with another body, accumulated since the previous control period.
struct Contact
{
  std::string own_collision;    ///< scoped name
  std::string other_collision;  ///< scoped name
  std::string other_model;      ///< name of the model or car
  std::vector<Vec2> positions;  ///< m, world
  std::vector<Vec2> normals;    ///< unit, world, from the other body towards the car
  std::vector<double> depths;   ///< m
  Vec2 force;                   ///< N, world, on the car, mean over the time step
  double torque{0.0};           ///< N m, about the car's centre of mass
  /// m/s, greatest relative speed of the touching points before the impact, whichever of the two bodies moved.
  double speed{0.0};
};

/// Level rays from a point of a car, in any directions.
struct RayFan
{
  Pose2 origin;                    ///< in the frame of the car
  double height{0.0};              ///< m, above the ground
  std::vector<double> directions;  ///< rad, from the heading of origin
  double range_max{0.0};           ///< m
};
}  // namespace f1tenth_sim2d
