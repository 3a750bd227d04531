#include "wheel_odometry.h"

#include <cmath>

#include "noise.h"
#include "planar_pose.h"
#include "sim_time.h"

namespace f1tenth_sim2d
{
WheelOdometryIntegrator::WheelOdometryIntegrator(const VehicleParameters & parameters, std::uint64_t seed, CarIndex car)
: parameters_(parameters), seed_(seed), car_(car)
{
}

void WheelOdometryIntegrator::restart(const Pose2 & pose, double steering_angle, SimTime now)
{
  current_ = {pose, 0.0, 0.0};
  next_sample_ = static_cast<std::int64_t>(std::floor(toSeconds(now) * parameters_.odometry_rate_hz)) + 1;
  next_time_ = sampleTime(next_sample_);
  distance_ = 0.0;
  elapsed_ = 0.0;
  last_steering_angle_ = steering_angle;
}

void WheelOdometryIntegrator::advance(double distance, double steering_angle, double dt, SimTime now)
{
  distance_ += distance;
  elapsed_ += dt;
  if (now >= next_time_) {
    sample(steering_angle);
    ++next_sample_;
    next_time_ = sampleTime(next_sample_);
  }
}

SimTime WheelOdometryIntegrator::sampleTime(std::int64_t number) const
{
  return fromSeconds(static_cast<double>(number) / parameters_.odometry_rate_hz);
}

void WheelOdometryIntegrator::sample(double steering_angle)
{
  const VehicleParameters & p = parameters_;
  const auto number = static_cast<std::uint64_t>(next_sample_);
  const std::uint64_t key = noiseKey(seed_, car_, NoiseStream::kOdometry, 0, number);
  const double mean_steering_angle = 0.5 * (last_steering_angle_ + steering_angle);
  const double measured_angle =
    mean_steering_angle + p.odometry_steering_offset + p.odometry_steering_noise_stddev * gaussian(key, 0);
  // A wheel that stands counts nothing.
  const double noise = distance_ == 0.0 ? 0.0 : p.odometry_speed_noise_stddev * gaussian(key, 1);
  current_.speed = p.odometry_speed_scale * distance_ / elapsed_ + noise;
  const SineCosine steering = sineCosine(measured_angle);
  current_.yaw_rate = current_.speed * steering.sine / steering.cosine / p.wheelbase();

  const double turn = current_.yaw_rate * elapsed_;
  const SineCosine course = sineCosine(current_.pose.yaw + 0.5 * turn);
  current_.pose.x += current_.speed * elapsed_ * course.cosine;
  current_.pose.y += current_.speed * elapsed_ * course.sine;
  current_.pose.yaw = wrapAngle(current_.pose.yaw + turn);
  distance_ = 0.0;
  elapsed_ = 0.0;
  last_steering_angle_ = steering_angle;
}
}  // namespace f1tenth_sim2d
