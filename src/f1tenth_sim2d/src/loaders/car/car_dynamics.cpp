#include "loaders/car/car_readers.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "loaders/model/inertia.h"

namespace f1tenth_sim2d
{
namespace
{

constexpr double kGravity = 9.81;      // m/s^2, of the tyre model
constexpr double kFrictionMax = 2.0;   // no tyre has more, and the tyre model means nothing beyond it
constexpr double kSteeringMax = 1.5;   // rad, what loadVehicleParameters() allows
constexpr double kBackwardsMax = 5.0;  // m/s, the F1/10 car's

/// x of the front axle in the frame of the car, whose origin is below the rear one; none without an axle in front.
std::optional<double> wheelbaseOf(const std::vector<MechanismJoint> & mechanism)
{
  std::optional<double> front;
  for (const MechanismJoint & joint : mechanism) {
    if (joint.place.x() > 0.0) {
      front = std::max(front.value_or(0.0), joint.place.x());
    }
  }
  return front;
}

/// On a car without a front axle, the place of the centre of mass still matters to a drive that does not steer.
void placeOnOneAxle(double centre_of_mass, CarContext & context)
{
  if (context.car.drive && context.car.drive->kind != DriveDescription::Kind::kAckermann) {
    VehicleParameters & parameters = context.car.parameters;
    const double wheelbase = parameters.wheelbase();
    parameters.l_r = centre_of_mass;
    parameters.l_f = wheelbase - centre_of_mass;
  }
}

void requireMass(const LinkPart & link)
{
  const Inertia & inertia = link.inertia;
  link.element.requireNotNegative("the mass (kg)", inertia.mass);
  if (!inertia.moments.allFinite()) {
    link.element.fail("the moments of inertia are not finite");
  }
}

void readMass(const std::vector<MechanismJoint> & mechanism, CarContext & context)
{
  for (const LinkPart & link : context.model.links) {
    requireMass(link);
  }
  const Inertia whole = placed(inertiaOf(context.model), context.car_in_model.inverse());
  const Eigen::Vector3d & centre = whole.centre;
  VehicleParameters & parameters = context.car.parameters;
  if (whole.mass > 0.0 && whole.moments(2, 2) > 0.0) {
    parameters.m = whole.mass;
    parameters.I_z = whole.moments(2, 2);
    parameters.h = std::max(0.0, centre.z());
  }
  const std::optional<double> wheelbase = wheelbaseOf(mechanism);
  if (!wheelbase) {
    placeOnOneAxle(centre.x(), context);
    return;
  }
  const double default_share = parameters.l_r / parameters.wheelbase();
  const bool between_axles = centre.x() > 0.0 && centre.x() < *wheelbase;
  if (!between_axles) {
    context.warnings.add(
      "the centre of mass is not between the axles: taken where the F1/10 car has it",
      context.model.element.fileLine());
  }
  parameters.l_r = between_axles ? centre.x() : default_share * *wheelbase;
  parameters.l_f = *wheelbase - parameters.l_r;
}

/// Casters may have none: they only carry. A car whose wheels all have none would neither drive nor steer.
void readFriction(const std::vector<MechanismJoint> & mechanism, CarContext & context)
{
  double least = std::numeric_limits<double>::infinity();
  for (const MechanismJoint & joint : mechanism) {
    if (joint.mu.value_or(0.0) > 0.0) {
      least = std::min(least, *joint.mu);
    }
  }
  if (!std::isfinite(least)) {
    const auto is_said = [](const MechanismJoint & joint) { return joint.mu.has_value(); };
    if (std::any_of(mechanism.begin(), mechanism.end(), is_said)) {
      context.model.element.fail("the friction (mu1) of all wheels is 0, allowed are numbers greater than 0");
    }
    return;
  }
  if (least > kFrictionMax) {
    context.warnings.add(
      "friction of the wheels beyond 2 is taken as 2: no tyre has more", context.model.element.fileLine());
  }
  context.car.parameters.mu = std::min(least, kFrictionMax);
}

/// The least limit, value(joint), of all joints that have one.
template <typename Value>
std::optional<double> leastLimit(const std::vector<MechanismJoint> & mechanism, bool of_steering, Value value)
{
  double least = std::numeric_limits<double>::infinity();
  for (const MechanismJoint & joint : mechanism) {
    if (joint.steers() == of_steering && value(joint) > 0.0) {
      least = std::min(least, value(joint));
    }
  }
  return std::isfinite(least) ? std::optional<double>(least) : std::nullopt;
}

/// How far a joint turns to either side; one that does not reach both counts as if it turned as far to the other.
double steeringLimit(const MechanismJoint & joint)
{
  const double both = std::min(-joint.description.lower, joint.description.upper);
  return both > 0.0 ? both : std::max(std::abs(joint.description.lower), std::abs(joint.description.upper));
}

void warnOfOneSide(const std::vector<MechanismJoint> & mechanism, CarContext & context)
{
  for (const MechanismJoint & joint : mechanism) {
    if (joint.steers() && (joint.description.lower >= 0.0 || joint.description.upper <= 0.0)) {
      context.warnings.add(
        "steering joint '" + joint.description.name +
          "' turns to one side only: taken as one that turns as far to the other",
        context.model.element.fileLine());
    }
  }
}

void readLimits(const std::vector<MechanismJoint> & mechanism, VehicleParameters & parameters)
{
  const auto angle = leastLimit(mechanism, true, steeringLimit);
  const auto rate =
    leastLimit(mechanism, true, [](const MechanismJoint & joint) { return joint.description.velocity_max; });
  const auto speed = leastLimit(
    mechanism, false, [](const MechanismJoint & joint) { return joint.description.velocity_max * joint.radius; });
  parameters.steering_max = std::min(angle.value_or(parameters.steering_max), kSteeringMax);
  parameters.steering_rate_max = rate.value_or(parameters.steering_rate_max);
  parameters.v_max = speed.value_or(parameters.v_max);
  parameters.v_min = -std::min(parameters.v_max, kBackwardsMax);
}

/// The acceleration from the efforts of all wheels, at most that of the F1/10 car and what its tyres can hold.
void readAcceleration(const std::vector<MechanismJoint> & mechanism, VehicleParameters & parameters)
{
  double force = 0.0;
  for (const MechanismJoint & joint : mechanism) {
    force += joint.steers() ? 0.0 : joint.description.effort_max / joint.radius;
  }
  parameters.a_max = std::min(parameters.a_max, parameters.mu * kGravity);
  if (force > 0.0) {
    parameters.a_max = std::min(parameters.a_max, force / parameters.m);
  }
}
}  // namespace

void readDynamics(const std::vector<MechanismJoint> & mechanism, CarContext & context)
{
  readMass(mechanism, context);
  readFriction(mechanism, context);
  warnOfOneSide(mechanism, context);
  readLimits(mechanism, context.car.parameters);
  readAcceleration(mechanism, context.car.parameters);
}
}  // namespace f1tenth_sim2d
