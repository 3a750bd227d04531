#include "environment/environment.h"

#include <workspace_support/maths/trigonometry.h>
#include <algorithm>
#include <cmath>

#include "core/components/camera/camera.h"
#include "f1tenth_sim2d/errors.h"

namespace f1tenth_sim2d
{
namespace
{
constexpr double kReach = 5.0;  // m along the course, farther than any car gets in a period

CarResult resultOf(const CarState & state)
{
  CarResult result;
  result.x = state.pose.x;
  result.y = state.pose.y;
  result.yaw = state.pose.yaw;
  result.v_x = state.velocity.x;
  result.v_y = state.velocity.y;
  result.yaw_rate = state.yaw_rate;
  result.steering_angle = state.steering_angle;
  return result;
}

void setPosition(CarResult & car, const CoursePosition & position)
{
  car.course_distance = position.distance;
  car.course_offset = position.offset;
  car.course_heading = position.heading;
}
}  // namespace

Pedals::Pedals(const VehicleParameters & parameters, double speed) : parameters_(parameters), speed_(speed) {}

DriveCommand Pedals::press(const CarState & state, double steering_rate, double acceleration, double dt)
{
  const double rate = std::clamp(steering_rate, -parameters_.steering_rate_max, parameters_.steering_rate_max);
  const double limit = parameters_.steering_max;
  steering_angle_ = std::clamp(steering_angle_ + rate * dt, -limit, limit);

  const double a = std::clamp(acceleration, -parameters_.a_max, parameters_.a_max);
  // The target must not run ahead of a car that cannot follow, at a wall or above v_switch: it would catch up later.
  const double lag = parameters_.a_max * (parameters_.actuation_latency + 1.0 / parameters_.speed_gain);
  speed_ = std::clamp(speed_ + a * dt, state.velocity.x - lag, state.velocity.x + lag);
  speed_ = std::clamp(speed_, parameters_.v_min, parameters_.v_max);
  // The car accelerates by its speed error times the gain: with this lead it follows a ramp without falling behind.
  return {speed_ + a / parameters_.speed_gain, steering_angle_};
}

void Environment::reset(std::uint64_t seed, const std::vector<CarStart> & starts)
{
  if (starts.size() != options_.cars.size()) {
    throw Error(
      std::to_string(starts.size()) + " starts, allowed are " + std::to_string(options_.cars.size()) + ": one per car");
  }
  auto simulation = std::make_unique<Simulation>(world_, SimulationOptions{options_.physics_step, seed});
  std::vector<CarId> ids;
  std::vector<Pedals> pedals;
  std::vector<CarResult> results;
  for (std::size_t i = 0; i < starts.size(); ++i) {
    const CarStart & start = starts[i];
    CarDescription car = options_.cars[i];
    car.lidars.front().noise_stddev = start.lidar_noise;
    ids.push_back(simulation->addCar(car, start.parameters, start.pose));
    if (start.speed != 0.0) {
      simulation->placeCar(ids.back(), start.pose, {start.speed, 0.0});
    }
    pedals.emplace_back(start.parameters, start.speed);
    results.push_back(resultOf(simulation->state(ids.back())));
    if (options_.course) {
      setPosition(results.back(), options_.course->locate(start.pose));
    }
  }
  // Nothing fails from here on, so that an episode begins completely or not at all.
  log_.reset();
  simulation_.swap(simulation);
  ids_.swap(ids);
  pedals_.swap(pedals);
  results_.swap(results);
  steps_ = 0;
}

void Environment::command(const Action * actions, const std::uint8_t * driven)
{
  const double dt = options_.physics_step;
  for (std::size_t i = 0; i < ids_.size(); ++i) {
    const auto [steering, speed] = actions[i];
    if (driven[i] == 0) {
      simulation_->command(ids_[i], {0.0, 0.0});
    } else if (options_.rates) {
      simulation_->command(ids_[i], pedals_[i].press(simulation_->state(ids_[i]), steering, speed, dt));
    } else {
      simulation_->command(ids_[i], {speed, steering});
    }
  }
}

void Environment::step(const Action * actions, const std::uint8_t * driven)
{
  if (!simulation_) {
    throw Error("step before the first reset");
  }
  for (const CarId id : ids_) {
    simulation_->clearContacts(id);
  }
  command(actions, driven);
  ++steps_;  // not before: a step that is refused does not count
  const SimTime end = fromSeconds(static_cast<double>(steps_) * options_.period);
  while (options_.rates && simulation_->time() + simulation_->stepLength() < end) {
    simulation_->step();
    command(actions, driven);
  }
  simulation_->advanceTo(end);
  look();
  log();
}

void Environment::record(const std::string & file)
{
  if (!simulation_) {
    throw Error("record before the first reset");
  }
  log_.reset();
  if (!file.empty()) {
    log_ = std::make_unique<TrajectoryLog>(*simulation_, file);
  }
}

Episode Environment::snapshot() const
{
  refuseRecording();
  Episode episode{{}, ids_, pedals_, results_, steps_};
  if (simulation_) {
    episode.simulation = simulation_->snapshot();
  }
  return episode;
}

void Environment::restore(const Episode & episode)
{
  refuseRecording();
  if (episode.simulation && episode.ids.size() != options_.cars.size()) {
    throw Error(
      "an episode of " + std::to_string(episode.ids.size()) + " cars, allowed are " +
      std::to_string(options_.cars.size()));
  }
  auto simulation = episode.simulation ? std::make_unique<Simulation>(*episode.simulation) : nullptr;
  ids_ = episode.ids;
  pedals_ = episode.pedals;
  results_ = episode.results;
  steps_ = episode.steps;
  simulation_ = std::move(simulation);
}

void Environment::refuseRecording() const
{
  if (log_) {
    throw Error("an episode that is recorded cannot be copied or replaced");
  }
}

void Environment::log()
{
  if (!log_) {
    return;
  }
  for (const CarId id : ids_) {
    for (const Contact & contact : simulation_->contacts(id)) {
      log_->note(id, contact);
    }
  }
  log_->endPeriod();
}

void Environment::look()
{
  for (std::size_t i = 0; i < ids_.size(); ++i) {
    measure(results_[i], simulation_->state(ids_[i]));
    results_[i].contact = simulation_->contacts(ids_[i]).empty() ? 0.0 : 1.0;
  }
}

void Environment::measure(CarResult & car, const CarState & state) const
{
  CarResult now = resultOf(state);
  if (options_.course) {
    const CoursePosition position = options_.course->locate(state.pose, car.course_distance, kReach);
    setPosition(now, position);
    now.progress = std::remainder(position.distance - car.course_distance, options_.course->length());
    now.distance = car.distance + now.progress;
    now.laps = std::max(0.0, std::floor(now.distance / options_.course->length()));
  } else {
    now.progress = std::copysign(maths::hypot(now.x - car.x, now.y - car.y), now.v_x);
    now.distance = car.distance + now.progress;
  }
  car = now;
}

void Environment::look(std::size_t car, Picture & picture) const
{
  if (!simulation_) {
    throw Error("an environment shows nothing before its first reset");
  }
  const CarId id = ids_.at(car);
  for (const auto & component : simulation_->components(id)) {
    if (const auto * const camera = dynamic_cast<const Camera *>(component.get())) {
      camera->look(*simulation_, id, {&camera->eyes().front()}, {&picture});
      return;
    }
  }
  throw Error(simulation_->car(id).name + " has no camera");
}

void Environment::observe(float * rows) const
{
  for (std::size_t i = 0; i < ids_.size(); ++i) {
    observation_.write(*simulation_, ids_, results_.data(), i, rows + i * observation_.size());
  }
}
}  // namespace f1tenth_sim2d
