#include "validation.h"

#include <cmath>
#include <sstream>

#include "f1tenth_sim2d/errors.h"

namespace f1tenth_sim2d
{
namespace
{
constexpr double kStepMin = 1e-5;         // s
constexpr double kStepMax = 0.02;         // s
constexpr double kLevelTolerance = 1e-6;  // rad

void require(bool condition, const std::string & where, const std::string & what, double found, const char * allowed)
{
  if (!condition) {
    std::ostringstream message;
    message << where << ": " << what << " is " << found << ", allowed is " << allowed;
    throw Error(message.str());
  }
}

void requireFinite(double value, const std::string & where, const std::string & what)
{
  require(std::isfinite(value), where, what, value, "a finite number");
}

void validateLidar(const LidarDescription & lidar, const std::string & car)
{
  const std::string where = car + ": lidar " + lidar.name;
  const double tilt = std::hypot(lidar.pose.Rot().Roll(), lidar.pose.Rot().Pitch());
  require(tilt < kLevelTolerance, where, "tilt (rad)", tilt, "0: the scan plane must be level");
  require(lidar.beam_count >= 1, where, "number of beams", lidar.beam_count, "1 or more");
  const double field_of_view = lidar.angle_max - lidar.angle_min;
  require(lidar.beam_count == 1 || field_of_view > 0.0, where, "field of view (rad)", field_of_view, "more than 0");
  requireFinite(field_of_view, where, "field of view (rad)");
  require(lidar.range_min >= 0.0, where, "least range (m)", lidar.range_min, "0 or more");
  require(
    lidar.range_max > lidar.range_min && std::isfinite(lidar.range_max), where, "largest range (m)", lidar.range_max,
    "a finite number above the least range");
  require(
    lidar.noise_stddev >= 0.0 && std::isfinite(lidar.noise_stddev), where, "noise (m)", lidar.noise_stddev,
    "a finite number, 0 or more");
}
}  // namespace

const WorldDescription & validated(const WorldDescription & world)
{
  for (const ModelDescription & model : world.models) {
    if (!model.is_static) {
      const std::string where = world.file + ": model " + model.name;
      require(model.mass > 0.0 && std::isfinite(model.mass), where, "mass (kg)", model.mass, "more than 0");
      require(
        model.inertia_zz > 0.0 && std::isfinite(model.inertia_zz), where, "inertia izz (kg m^2)", model.inertia_zz,
        "more than 0");
    }
  }
  return world;
}

const SimulationOptions & validated(const SimulationOptions & options)
{
  const double step = options.physics_step;
  require(step >= kStepMin && step <= kStepMax, "simulation", "physics_step (s)", step, "0.00001 to 0.02");
  return options;
}

void validate(const CarDescription & car, const Pose2 & start)
{
  requireFinite(start.x, car.name, "x (m) of the pose");
  requireFinite(start.y, car.name, "y (m) of the pose");
  requireFinite(start.yaw, car.name, "yaw (rad) of the pose");
  require(car.wheel_radius > 0.0, car.name, "wheel radius (m)", car.wheel_radius, "more than 0");
  for (const LidarDescription & lidar : car.lidars) {
    validateLidar(lidar, car.name);
  }
}

void validate(const DriveCommand & command, const std::string & car)
{
  requireFinite(command.speed, car, "commanded speed (m/s)");
  requireFinite(command.steering_angle, car, "commanded steering angle (rad)");
}
}  // namespace f1tenth_sim2d
