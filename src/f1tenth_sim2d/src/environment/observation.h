#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "environment/course.h"
#include "f1tenth_sim2d/simulation.h"

namespace f1tenth_sim2d
{
/// What a driver may be told of the car and what is around it.
enum class ObservationPart
{
  kScan,      ///< ranges of the first lidar, m; 0 below its least range, its greatest range beyond that
  kPose,      ///< x, y, m, and yaw, rad, in the world
  kVelocity,  ///< along the car and to its left, m/s, and yaw rate, rad/s
  kSteering,  ///< angle, rad
  kCourse,    ///< distance along the course and offset to its left, m, heading from it, rad
  kLaps,      ///< driven since the start
  kContact,   ///< 1 if the car touched something in the step before
  kOthers     ///< of each other car: x, y, m, yaw, rad, in the frame of the car, speed along itself, m/s
};

/// The part of a name. @throws Error that lists the names
ObservationPart observationPart(const std::string & name);

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
  Observation(
    std::vector<ObservationPart> parts, const LidarDescription & lidar, std::size_t cars, double course_length);

  std::size_t size() const { return bounds_.size(); }                ///< numbers per car
  const std::vector<std::size_t> & sizes() const { return sizes_; }  ///< of each part
  /// Least and greatest value of each number.
  const std::vector<std::pair<float, float>> & bounds() const { return bounds_; }

  /// Writes what car `own` observes. @param cars  results of all cars
  void write(
    const Simulation & simulation, const std::vector<CarId> & ids, const CarResult * cars, std::size_t own,
    float * row) const;

private:
  std::vector<std::pair<float, float>> boundsOf(ObservationPart part, double course_length) const;
  void writeScan(const Simulation & simulation, CarId car, float * row) const;

  std::vector<ObservationPart> parts_;
  std::size_t beam_count_;
  float range_max_;
  std::size_t car_count_;
  std::vector<std::size_t> sizes_;
  std::vector<std::pair<float, float>> bounds_;
};
}  // namespace f1tenth_sim2d
