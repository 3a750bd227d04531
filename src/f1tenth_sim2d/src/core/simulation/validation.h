#pragma once

#include "f1tenth_sim2d/car_model.h"
#include "f1tenth_sim2d/simulation.h"
#include "f1tenth_sim2d/world_model.h"

/// What the simulation refuses to be built from. Each throws Error with one line that says what is allowed.
namespace f1tenth_sim2d
{
void validate(const WorldDescription & world);
const SimulationOptions & validated(const SimulationOptions & options);
void validate(const CarDescription & car, const Pose2 & start);
/// @param car  name of the car
void validate(const VehicleParameters & parameters, const std::string & car);
/// @param where  text in front of the model's name
void validate(const ModelDescription & model, const std::string & where);
/// @param what  the model or car that is to be put there
void validate(const ModelState & state, const std::string & what);
/// @param car  name of the car
void validate(const RayFan & fan, const std::string & car);
/// @param limit  m, of a clearance that is asked for
/// @param car    name of the car
void validateClearanceLimit(double limit, const std::string & car);
/// @param car  name of the car
void validate(const DriveCommand & command, const std::string & car);
void validateTwist(const Vec2 & linear, double angular_z, const std::string & car);
}  // namespace f1tenth_sim2d
