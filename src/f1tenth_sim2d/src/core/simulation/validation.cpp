#include "core/simulation/validation.h"

#include <workspace_support/maths/trigonometry.h>
#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

#include "f1tenth_sim2d/errors.h"
#include "f1tenth_sim2d/vehicle_keys.h"

namespace f1tenth_sim2d
{
namespace
{
constexpr double kStepMin = 1e-5;         // s
constexpr double kStepMax = 0.02;         // s
constexpr double kLevelTolerance = 1e-6;  // rad
// What a driver may ask for: far beyond any car of this size, but still a meaningful number.
constexpr double kSpeedMax = 100.0;           // m/s
constexpr double kSteeringMax = 6.2832;       // rad
constexpr double kYawRateMax = 1000.0;        // rad/s
constexpr double kBeamAngleMax = 4.0 * M_PI;  // rad: beams beyond a full turn look where others look
// Of bodies: Box2D computes in single precision, in which less becomes 0 and more becomes infinite.
constexpr double kMassMin = 1e-6;          // kg
constexpr double kMassMax = 1e9;           // kg
constexpr double kInertiaMin = 1e-9;       // kg m^2
constexpr double kInertiaMax = 1e12;       // kg m^2
constexpr double kModelSpeedMax = 1000.0;  // m/s
constexpr double kWheelbaseMin = 1e-3;     // m
constexpr double kWheelbaseMax = 100.0;    // m
constexpr double kLengthMax = 1e5;         // m
constexpr double kGreatest = 1e9;          // of what has no bound of its own
constexpr double kRadiusMin = 1e-3;        // m
constexpr double kFrictionMin = 1e-3;
constexpr double kFrictionMax = 10.0;
constexpr double kShapeMin = 0.1;  // beyond these the magic formula does not describe a tyre
constexpr double kShapeMax = 2.5;
constexpr double kStiffnessMax = 1e4;

[[noreturn]] void refuse(
  const std::string & where, const std::string & what, double found, const std::string & is_allowed)
{
  throw Error(where + ": " + what + " is " + toText(found) + ", allowed " + is_allowed);
}

void require(bool condition, const std::string & where, const char * what, double found, const char * allowed)
{
  if (!condition) {
    refuse(where, what, found, std::string("is ") + allowed);
  }
}

void requireFinite(double value, const std::string & where, const char * what)
{
  require(std::isfinite(value), where, what, value, "a finite number");
}

/// Refuses NaN, too.
void requireBetween(double value, double least, double greatest, const std::string & where, const char * what)
{
  if (!(value >= least && value <= greatest)) {
    refuse(where, what, value, "is " + toText(least) + " to " + toText(greatest));
  }
}

void requireWithin(double value, double limit, const std::string & where, const char * what)
{
  requireBetween(value, -limit, limit, where, what);
}

/// Names appear in records, which are CSV files with lists of names in a column.
void requireName(std::string name, const std::string & where)
{
  const auto isControl = [](unsigned char c) { return std::iscntrl(c) != 0; };
  const bool has_control = std::any_of(name.begin(), name.end(), isControl);
  if (has_control || name.find_first_of(",;\"") != std::string::npos) {
    std::replace_if(name.begin(), name.end(), isControl, '?');
    throw Error(where + ": found the name '" + name + "', allowed is one without , ; \" and control characters");
  }
}

void requireBody(double mass, double inertia, const std::string & where)
{
  requireBetween(mass, kMassMin, kMassMax, where, "mass (kg)");
  requireBetween(inertia, kInertiaMin, kInertiaMax, where, "inertia about z (kg m^2)");
}

void validateLidar(const LidarDescription & lidar, const std::string & car)
{
  const std::string where = car + ": lidar " + lidar.name;
  const Eigen::Vector3d up = lidar.pose.up();
  const double tilt = maths::atan2(maths::hypot(up.x(), up.y()), std::abs(up.z()));
  require(tilt < kLevelTolerance, where, "tilt (rad)", tilt, "0: the scan plane must be level");
  require(lidar.beam_count >= 1, where, "number of beams", lidar.beam_count, "1 or more");
  const double field_of_view = lidar.angle_max - lidar.angle_min;
  require(lidar.beam_count == 1 || field_of_view > 0.0, where, "field of view (rad)", field_of_view, "more than 0");
  requireWithin(lidar.angle_min, kBeamAngleMax, where, "least angle (rad)");
  requireWithin(lidar.angle_max, kBeamAngleMax, where, "largest angle (rad)");
  require(lidar.range_min >= 0.0, where, "least range (m)", lidar.range_min, "0 or more");
  require(
    lidar.range_max > lidar.range_min && lidar.range_max <= kLengthMax, where, "largest range (m)", lidar.range_max,
    "a number above the least range, up to 100000");
  require(
    lidar.noise_stddev >= 0.0 && std::isfinite(lidar.noise_stddev), where, "noise (m)", lidar.noise_stddev,
    "a finite number, 0 or more");
  requireWithin(lidar.noise_mean, lidar.range_max, where, "bias (m)");
}

/// Checks what a YAML file of the car may set, with bounds within which numbers keep their meaning.
template <typename Parameters>
void requireInRange(
  const vehicle_keys::Key<Parameters> & key, const Parameters & parameters, const std::string & where,
  const std::string & group = "")
{
  const double value = parameters.*key.member;
  const vehicle_keys::Range & range = key.range;
  const std::string name = group + key.name;
  if (!range.contains(value)) {
    refuse(where, name, value, std::string("are ") + range.text);
  }
  const double least = std::max(range.least, -kGreatest);
  requireBetween(value, least, std::min(range.greatest, kGreatest), where, name.c_str());
}

/// What the formula of the tyres divides by, and what makes their forces resist.
void validateWheels(const VehicleParameters & p, const std::string & car)
{
  requireBetween(p.mu, kFrictionMin, kFrictionMax, car, "mu");
  requireBetween(p.R_w, kRadiusMin, kWheelbaseMax, car, "R_w (m)");
  requireBetween(p.I_y_w, kInertiaMin, kInertiaMax, car, "I_y_w (kg m^2)");
  for (const auto & [name, value] : {std::pair("tire p_cx1", p.tire.p_cx1), std::pair("tire p_cy1", p.tire.p_cy1)}) {
    requireBetween(value, kShapeMin, kShapeMax, car, name);
  }
  for (const auto & [name, value] : {std::pair("tire p_dx1", p.tire.p_dx1), std::pair("tire p_dy1", p.tire.p_dy1)}) {
    requireBetween(value, kFrictionMin, kFrictionMax, car, name);
  }
  requireBetween(p.tire.p_kx1, 0.0, kStiffnessMax, car, "tire p_kx1");
  requireBetween(p.tire.p_ky1, -kStiffnessMax, 0.0, car, "tire p_ky1");
}
}  // namespace

void validate(const WorldDescription & world)
{
  for (const ModelDescription & model : world.models) {
    validate(model, world.file);
  }
}

void validate(const ModelDescription & model, const std::string & where)
{
  requireName(model.name, where + ": model");
  const std::string name = where + ": model " + model.name;
  requireWithin(model.pose.position.x(), kLengthMax, name, "x (m)");
  requireWithin(model.pose.position.y(), kLengthMax, name, "y (m)");
  requireWithin(model.pose.position.z(), kLengthMax, name, "z (m)");
  requireFinite(model.pose.rotation.norm(), name, "rotation");
  if (!model.is_static) {
    requireBody(model.mass, model.inertia_zz, name);
  }
}

void validate(const ModelState & state, const std::string & what)
{
  requireWithin(state.pose.x, kLengthMax, what, "x (m)");
  requireWithin(state.pose.y, kLengthMax, what, "y (m)");
  requireFinite(state.pose.yaw, what, "yaw (rad)");
  requireWithin(state.velocity.x, kModelSpeedMax, what, "velocity in x (m/s)");
  requireWithin(state.velocity.y, kModelSpeedMax, what, "velocity in y (m/s)");
  requireWithin(state.yaw_rate, kYawRateMax, what, "yaw rate (rad/s)");
}

const SimulationOptions & validated(const SimulationOptions & options)
{
  const double step = options.physics_step;
  require(step >= kStepMin && step <= kStepMax, "simulation", "physics_step (s)", step, "0.00001 to 0.02");
  return options;
}

void validate(const CarDescription & car, const Pose2 & start)
{
  requireName(car.name, "car");
  requireWithin(start.x, kLengthMax, car.name, "x (m) of the pose");
  requireWithin(start.y, kLengthMax, car.name, "y (m) of the pose");
  requireFinite(start.yaw, car.name, "yaw (rad) of the pose");
  require(car.wheel_radius > 0.0, car.name, "wheel radius (m)", car.wheel_radius, "more than 0");
  for (const LidarDescription & lidar : car.lidars) {
    validateLidar(lidar, car.name);
  }
}

void validate(const VehicleParameters & p, const std::string & car)
{
  requireBody(p.m, p.I_z, car);
  requireBetween(p.wheelbase(), kWheelbaseMin, kWheelbaseMax, car, "wheelbase (m)");
  requireWithin(p.l_r, kLengthMax, car, "l_r (m)");
  if (p.model == VehicleModel::kSingleTrackDrift) {
    validateWheels(p, car);
  }
  for (const auto & key : vehicle_keys::kVehicle) {
    // A car that does not steer may have its centre of mass beyond an axle.
    if (key.member != &VehicleParameters::l_f && key.member != &VehicleParameters::l_r) {
      requireInRange(key, p, car);
    }
  }
  for (const auto & key : vehicle_keys::kTire) {
    requireInRange(key, p.tire, car, "tire ");
  }
}

void validate(const DriveCommand & command, const std::string & car)
{
  requireWithin(command.speed, kSpeedMax, car, "commanded speed (m/s)");
  requireWithin(command.steering_angle, kSteeringMax, car, "commanded steering angle (rad)");
}

void validate(const RayFan & fan, const std::string & car)
{
  requireFinite(fan.origin.x, car, "x (m) of the rays");
  requireFinite(fan.origin.y, car, "y (m) of the rays");
  requireFinite(fan.origin.yaw, car, "yaw (rad) of the rays");
  requireFinite(fan.height, car, "height (m) of the rays");
  for (const double direction : fan.directions) {
    requireFinite(direction, car, "direction (rad) of a ray");
  }
  require(fan.range_max >= 0.0, car, "largest range (m) of the rays", fan.range_max, "0 or more");
}

void validateClearanceLimit(double limit, const std::string & car)
{
  require(limit >= 0.0, car, "limit (m) of the clearance", limit, "0 or more");
}

void validateTwist(const Vec2 & linear, double angular_z, const std::string & car)
{
  requireWithin(linear.x, kSpeedMax, car, "commanded speed (m/s)");
  requireWithin(linear.y, kSpeedMax, car, "commanded speed to the side (m/s)");
  requireWithin(angular_z, kYawRateMax, car, "commanded yaw rate (rad/s)");
}
}  // namespace f1tenth_sim2d
