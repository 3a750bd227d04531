#include "environment/observation.h"

#include <algorithm>
#include <array>
#include <boost/algorithm/string/join.hpp>

#include "f1tenth_sim2d/errors.h"

namespace f1tenth_sim2d
{
namespace
{
using Bounds = Observation::Bounds;
using Part = Observation::Part;
using View = Observation::View;

constexpr Bounds kPlace{-1000.0F, 1000.0F};        // m
constexpr Bounds kAngle{-3.1415928F, 3.1415928F};  // rad; pi, rounded away from 0
constexpr Bounds kSpeed{-100.0F, 100.0F};          // m/s, rad/s
constexpr Bounds kLaps{0.0F, 1.0e6F};

/// What decides how large parts are.
struct Setting
{
  const std::vector<CarDescription> & cars;
  double course_length;
};

/// Numbers of the car's own result.
template <std::size_t count>
Part ofResult(const std::array<Bounds, count> & bounds, std::array<double, count> (*numbers)(const CarResult &))
{
  return {{bounds.begin(), bounds.end()}, [numbers](const View & view, float * row) {
            const auto all = numbers(view.cars[view.own]);
            std::copy(all.begin(), all.end(), row);
          }};
}

/// Ranges of the first lidar, m; 0 below its least range, its greatest range beyond that.
Part scan(const Setting & setting)
{
  const LidarDescription & lidar = setting.cars.front().lidars.front();
  const Bounds bounds{0.0F, static_cast<float>(lidar.range_max)};
  return {std::vector<Bounds>(static_cast<std::size_t>(lidar.beam_count), bounds), [](const View & view, float * row) {
            view.simulation.scan(view.ids[view.own], 0, row);
          }};
}

/// x, y, m, and yaw, rad, in the world.
Part pose(const Setting &)
{
  return ofResult<3>({kPlace, kPlace, kAngle}, [](const CarResult & car) {
    return std::array{car.x, car.y, workspace_support::normalizeAngle(car.yaw)};
  });
}

/// Along the car and to its left, m/s, and yaw rate, rad/s.
Part velocity(const Setting &)
{
  return ofResult<3>({kSpeed, kSpeed, kSpeed}, [](const CarResult & car) {
    return std::array{car.v_x, car.v_y, car.yaw_rate};
  });
}

/// Angle, rad.
Part steering(const Setting &)
{
  return ofResult<1>({kAngle}, [](const CarResult & car) { return std::array{car.steering_angle}; });
}

/// Distance along the course and offset to its left, m, heading from it, rad.
Part course(const Setting & setting)
{
  const Bounds along{0.0F, static_cast<float>(setting.course_length)};
  return ofResult<3>({along, kPlace, kAngle}, [](const CarResult & car) {
    return std::array{car.course_distance, car.course_offset, car.course_heading};
  });
}

/// Driven since the start.
Part laps(const Setting &)
{
  return ofResult<1>({kLaps}, [](const CarResult & car) { return std::array{car.laps}; });
}

/// 1 if the car touched something in the step before.
Part contact(const Setting &)
{
  return ofResult<1>({Bounds{0.0F, 1.0F}}, [](const CarResult & car) { return std::array{car.contact}; });
}

/// Of each other car: x, y, m, yaw, rad, in the frame of the car, speed along itself, m/s.
Part others(const Setting & setting)
{
  std::vector<Bounds> bounds;
  for (std::size_t i = 1; i < setting.cars.size(); ++i) {
    bounds.insert(bounds.end(), {kPlace, kPlace, kAngle, kSpeed});
  }
  return {bounds, [count = setting.cars.size()](const View & view, float * row) {
            const CarResult & own = view.cars[view.own];
            const Pose2 from = workspace_support::inverse({own.x, own.y, own.yaw});
            for (std::size_t i = 0; i < count; ++i) {
              if (i != view.own) {
                const CarResult & other = view.cars[i];
                const Pose2 seen = workspace_support::compose(from, {other.x, other.y, other.yaw});
                const std::array numbers{seen.x, seen.y, seen.yaw, other.v_x};
                row = std::copy(numbers.begin(), numbers.end(), row);
              }
            }
          }};
}

/// What a component of the car measures.
/// @param index  among the components that the simulation gives the car
Part ofComponent(const Component & component, std::size_t index)
{
  Part part;
  for (const Channel & channel : component.channels()) {
    const Bounds bounds{static_cast<float>(channel.least), static_cast<float>(channel.greatest)};
    part.bounds.insert(part.bounds.end(), channel.size, bounds);
  }
  part.write = [index, size = part.bounds.size()](const View & view, float * row) {
    const CarId car = view.ids[view.own];
    std::vector<double> numbers(size);
    view.simulation.components(car)[index]->sample(view.simulation, car, numbers.data());
    std::copy(numbers.begin(), numbers.end(), row);
  };
  return part;
}

const std::vector<std::pair<std::string, Part (*)(const Setting &)>> kParts{
  {"scan", scan},     {"pose", pose}, {"velocity", velocity}, {"steering", steering},
  {"course", course}, {"laps", laps}, {"contact", contact},   {"others", others}};

Part partOf(const std::string & name, const Setting & setting)
{
  std::vector<std::string> allowed;
  for (const auto & [known, make] : kParts) {
    if (known == name) {
      return make(setting);
    }
    allowed.push_back(known);
  }
  const CarDescription & car = setting.cars.front();
  for (std::size_t i = 0; i < car.components.size(); ++i) {
    const Component & component = *car.components[i];
    if (component.mount().name == name) {
      return ofComponent(component, car.lidars.size() + i);
    }
    allowed.push_back(component.mount().name);
  }
  throw Error("observation: found '" + name + "', allowed are " + boost::algorithm::join(allowed, ", "));
}
}  // namespace

Observation::Observation(
  const std::vector<std::string> & parts, const std::vector<CarDescription> & cars, double course_length)
{
  for (const std::string & name : parts) {
    const Part & part = parts_.emplace_back(partOf(name, {cars, course_length}));
    sizes_.push_back(part.bounds.size());
    bounds_.insert(bounds_.end(), part.bounds.begin(), part.bounds.end());
  }
}

void Observation::write(
  const Simulation & simulation, const std::vector<CarId> & ids, const CarResult * cars, std::size_t own,
  float * row) const
{
  float * next = row;
  for (const Part & part : parts_) {
    part.write({simulation, ids, cars, own}, next);
    next += part.bounds.size();
  }
  for (std::size_t i = 0; i < bounds_.size(); ++i) {
    row[i] = std::clamp(row[i], bounds_[i].first, bounds_[i].second);
  }
}
}  // namespace f1tenth_sim2d
