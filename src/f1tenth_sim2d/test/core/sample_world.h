#pragma once

#include <limits>
#include <string>

#include "f1tenth_sim2d/simulation.h"

/// Small worlds and a small car for the tests of the core.
namespace f1tenth_sim2d::test
{
/// The first two cars that are added to a simulation.
constexpr CarId kRobot1{0};
constexpr CarId kRobot2{1};

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

inline Solid box(const std::string & name, double length, double width, double height, double x, double y, double z)
{
  return {name, Box{{length, width, height}}, Pose3(x, y, z, 0, 0, 0)};
}

inline ModelDescription staticModel(const std::string & name, const Solid & solid)
{
  ModelDescription model;
  model.name = name;
  model.is_static = true;
  model.solids = {solid};
  return model;
}

/// A movable box of 1 kg whose lower side stands on the ground.
inline ModelDescription movableBox(const std::string & name, double size, double x, double y)
{
  ModelDescription model;
  model.name = name;
  model.pose = Pose3(x, y, 0, 0, 0, 0);
  model.mass = 1.0;
  model.inertia_zz = size * size / 6.0;
  model.solids = {box(name + "::link::collision", size, size, size, 0, 0, size / 2)};
  model.solids[0].mu = 0.5;
  return model;
}

/// A wall of 0.15 m x 80 m across the x axis, its near face at x.
inline ModelDescription wallAcross(double x)
{
  return staticModel("walls", box("walls::Wall_0::Wall_0_Collision", 0.15, 80, 2.5, x + 0.075, 0, 1.25));
}

/// A square room of inner half width `half`, as the Building Editor writes it: one model, one link per wall.
inline ModelDescription room(double half)
{
  ModelDescription model = staticModel("walls", box("walls::Wall_0::c", 0.15, 2 * half, 2.5, half + 0.075, 0, 1.25));
  model.solids.push_back(box("walls::Wall_1::c", 0.15, 2 * half, 2.5, -half - 0.075, 0, 1.25));
  model.solids.push_back(box("walls::Wall_2::c", 2 * half + 0.3, 0.15, 2.5, 0, half + 0.075, 1.25));
  model.solids.push_back(box("walls::Wall_3::c", 2 * half + 0.3, 0.15, 2.5, 0, -half - 0.075, 1.25));
  return model;
}

inline WorldDescription world(const std::vector<ModelDescription> & models = {})
{
  WorldDescription description;
  description.file = "test.world";
  description.name = "test";
  description.models = models;
  return description;
}

inline LidarDescription lidar()
{
  LidarDescription description;
  description.name = "lidar";
  description.pose = Pose3(0.27, 0, 0.11, 0, 0, 0);
  description.angle_min = -2.35619449;
  description.angle_max = 2.35619449;
  return description;
}

/// 0.5 m x 0.25 m, from 0.1 m behind the rear axle to 0.4 m before it; bumpers stand out by 5 mm all around.
inline CarDescription car(const std::string & name)
{
  CarDescription description;
  description.name = name;
  description.solids = {
    box("car::chassis::collision", 0.49, 0.24, 0.1, 0.15, 0, 0.07),
    box("car::bumper_front::collision", 0.02, 0.25, 0.05, 0.39, 0, 0.07),
    box("car::bumper_rear::collision", 0.02, 0.25, 0.05, -0.09, 0, 0.07),
    box("car::bumper_left::collision", 0.46, 0.02, 0.05, 0.15, 0.115, 0.07),
    box("car::bumper_right::collision", 0.46, 0.02, 0.05, 0.15, -0.115, 0.07)};
  description.lidars = {lidar()};
  return description;
}

inline void drive(Simulation & simulation, CarId car, const DriveCommand & command, double seconds)
{
  const SimTime end = simulation.time() + static_cast<SimTime>(seconds * 1e9);
  while (simulation.time() < end) {
    simulation.command(car, command);
    simulation.step();
  }
}
}  // namespace f1tenth_sim2d::test
