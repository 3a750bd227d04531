#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "environment/course.h"
#include "f1tenth_sim2d/simulation.h"

namespace f1tenth_sim2d
{
/// The state of a car after a step.
struct CarResult
{
  double x{0.0};               ///< m, base_footprint in the world
  double y{0.0};               ///< m
  double yaw{0.0};             ///< rad
  double v_x{0.0};             ///< m/s, along the car
  double v_y{0.0};             ///< m/s, to its left
  double yaw_rate{0.0};        ///< rad/s
  double steering_angle{0.0};  ///< rad
  double course_distance{0.0};
  double course_offset{0.0};
  double course_heading{0.0};  ///< see CoursePosition; 0 without a course
  double progress{0.0};        ///< m, along the course in the last step; without a course, along the car's own path
  double distance{0.0};        ///< m, progress since the start
  double laps{0.0};            ///< whole ones since the start
  double contact{0.0};         ///< 1 if the car touched something in the last step, else 0
};

/// Writes observations of cars as rows of numbers.
class Observation
{
public:
  /// @param parts  names, in order: those of the table in observation.cpp, and those of the components of the cars
  /// @param cars   all alike
  /// @throws Error for an unknown part, with the names that there are
  Observation(const std::vector<std::string> & parts, const std::vector<CarDescription> & cars, double course_length);

  std::size_t size() const { return bounds_.size(); }                ///< numbers per car
  const std::vector<std::size_t> & sizes() const { return sizes_; }  ///< of each part
  /// Least and greatest value of each number.
  const std::vector<std::pair<float, float>> & bounds() const { return bounds_; }

  /// Writes what car `own` observes. @param cars  results of all cars
  void write(
    const Simulation & simulation, const std::vector<CarId> & ids, const CarResult * cars, std::size_t own,
    float * row) const;

  /// What a car observes, and of whom.
  struct View
  {
    const Simulation & simulation;
    const std::vector<CarId> & ids;
    const CarResult * cars;
    std::size_t own;
  };
  using Bounds = std::pair<float, float>;
  struct Part
  {
    std::vector<Bounds> bounds;                            ///< of its numbers
    std::function<void(const View &, float * row)> write;  ///< numbers beyond their bounds are brought back
  };

private:
  std::vector<Part> parts_;
  std::vector<std::size_t> sizes_;
  std::vector<Bounds> bounds_;
};
}  // namespace f1tenth_sim2d
