#include "environment/observation.h"

#include <algorithm>
#include <array>
#include <boost/algorithm/string/join.hpp>
#include <cmath>

#include "f1tenth_sim2d/errors.h"

namespace f1tenth_sim2d
{
namespace
{
using Bounds = std::pair<float, float>;

constexpr std::array<const char *, 8> kNames{"scan",   "pose", "velocity", "steering",
                                             "course", "laps", "contact",  "others"};
constexpr Bounds kPlace{-1000.0F, 1000.0F};        // m
constexpr Bounds kAngle{-3.1415928F, 3.1415928F};  // rad; pi, rounded away from 0
constexpr Bounds kSpeed{-100.0F, 100.0F};          // m/s, rad/s
constexpr Bounds kLaps{0.0F, 1.0e6F};

std::array<double, 4> relative(const CarResult & own, const CarResult & other)
{
  const Pose2 pose =
    workspace_support::compose(workspace_support::inverse({own.x, own.y, own.yaw}), {other.x, other.y, other.yaw});
  return {pose.x, pose.y, pose.yaw, other.v_x};
}
}  // namespace

ObservationPart observationPart(const std::string & name)
{
  const auto found = std::find(kNames.begin(), kNames.end(), name);
  if (found != kNames.end()) {
    return static_cast<ObservationPart>(found - kNames.begin());
  }
  const std::string allowed = boost::algorithm::join(std::vector<std::string>(kNames.begin(), kNames.end()), ", ");
  throw Error("observation: found '" + name + "', allowed are " + allowed);
}

Observation::Observation(
  std::vector<ObservationPart> parts, const LidarDescription & lidar, std::size_t cars, double course_length)
: parts_(std::move(parts)),
  beam_count_(static_cast<std::size_t>(lidar.beam_count)),
  range_max_(static_cast<float>(lidar.range_max)),
  car_count_(cars)
{
  for (const ObservationPart part : parts_) {
    const std::vector<Bounds> more = boundsOf(part, course_length);
    sizes_.push_back(more.size());
    bounds_.insert(bounds_.end(), more.begin(), more.end());
  }
}

std::vector<Bounds> Observation::boundsOf(ObservationPart part, double course_length) const
{
  std::vector<Bounds> bounds;
  switch (part) {
    case ObservationPart::kScan:
      return std::vector<Bounds>(beam_count_, {0.0F, range_max_});
    case ObservationPart::kPose:
      return {kPlace, kPlace, kAngle};
    case ObservationPart::kVelocity:
      return {kSpeed, kSpeed, kSpeed};
    case ObservationPart::kSteering:
      return {kAngle};
    case ObservationPart::kCourse:
      return {{0.0F, static_cast<float>(course_length)}, kPlace, kAngle};
    case ObservationPart::kLaps:
      return {kLaps};
    case ObservationPart::kContact:
      return {{0.0F, 1.0F}};
    case ObservationPart::kOthers:
      for (std::size_t i = 1; i < car_count_; ++i) {
        bounds.insert(bounds.end(), {kPlace, kPlace, kAngle, kSpeed});
      }
  }
  return bounds;
}

void Observation::writeScan(const Simulation & simulation, CarId car, float * row) const
{
  simulation.scan(car, 0, row);
  for (std::size_t i = 0; i < beam_count_; ++i) {
    row[i] = std::clamp(row[i], 0.0F, range_max_);
  }
}

void Observation::write(
  const Simulation & simulation, const std::vector<CarId> & ids, const CarResult * cars, std::size_t own,
  float * row) const
{
  const CarResult & car = cars[own];
  std::size_t next = 0;
  const auto put = [&](double value) {
    const auto [low, high] = bounds_[next];
    row[next++] = std::clamp(static_cast<float>(value), low, high);
  };
  const auto putAll = [&](std::initializer_list<double> values) { std::for_each(values.begin(), values.end(), put); };
  for (const ObservationPart part : parts_) {
    switch (part) {
      case ObservationPart::kScan:
        writeScan(simulation, ids[own], row + next);
        next += beam_count_;
        break;
      case ObservationPart::kPose:
        putAll({car.x, car.y, workspace_support::normalizeAngle(car.yaw)});
        break;
      case ObservationPart::kVelocity:
        putAll({car.v_x, car.v_y, car.yaw_rate});
        break;
      case ObservationPart::kSteering:
        put(car.steering_angle);
        break;
      case ObservationPart::kCourse:
        putAll({car.course_distance, car.course_offset, car.course_heading});
        break;
      case ObservationPart::kLaps:
        put(car.laps);
        break;
      case ObservationPart::kContact:
        put(car.contact);
        break;
      case ObservationPart::kOthers:
        for (std::size_t i = 0; i < car_count_; ++i) {
          if (i != own) {
            const std::array<double, 4> seen = relative(car, cars[i]);
            std::for_each(seen.begin(), seen.end(), put);
          }
        }
    }
  }
}
}  // namespace f1tenth_sim2d
