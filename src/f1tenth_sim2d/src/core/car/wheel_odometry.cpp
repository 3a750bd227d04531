#include "core/car/wheel_odometry.h"

#include <workspace_support/maths/trigonometry.h>
#include <cmath>

#include "core/math/noise.h"
#include "core/math/planar_pose.h"

namespace f1tenth_sim2d
{
WheelOdometryIntegrator::WheelOdometryIntegrator(
  const VehicleParameters & parameters, bool steers, double track_width, std::uint64_t seed, std::uint32_t noise_stream)
: parameters_(parameters), steers_(steers), track_width_(track_width), seed_(seed), noise_stream_(noise_stream)
{
}

void WheelOdometryIntegrator::restart(const Pose2 & pose, SimTime now)
{
  current_ = {};
  current_.pose = pose;
  last_steering_angle_ = 0.0;
  beginSample(static_cast<std::int64_t>(std::floor(toSeconds(now) * parameters_.odometry_rate_hz)) + 1);
}

void WheelOdometryIntegrator::advance(const BodyState & state, double distance, double turn, double dt, SimTime now)
{
  distance_ += distance;
  elapsed_ += dt;
  if (!steers_) {
    sideways_ += (bodyVelocity(state).y - parameters_.l_r * state.psi_dot) * dt;
    turn_ += turn;
  }
  if (now >= next_time_) {
    steers_ ? sampleSteered(state.delta) : sampleFree();
    integrate();
  }
}

void WheelOdometryIntegrator::beginSample(std::int64_t number)
{
  distance_ = 0.0;
  sideways_ = 0.0;
  turn_ = 0.0;
  elapsed_ = 0.0;
  next_sample_ = number;
  next_time_ = fromSeconds(static_cast<double>(number) / parameters_.odometry_rate_hz);
}

std::uint64_t WheelOdometryIntegrator::noiseKeyNow() const
{
  return noiseKey(seed_, noise_stream_, NoiseStream::kOdometry, 0, static_cast<std::uint64_t>(next_sample_));
}

// A stationary wheel produces no counts and no noise.
double WheelOdometryIntegrator::measuredSpeed(double distance, double noise) const
{
  const double error = distance == 0.0 ? 0.0 : parameters_.odometry_speed_noise_stddev * noise;
  return parameters_.odometry_speed_scale * distance / elapsed_ + error;
}

void WheelOdometryIntegrator::sampleSteered(double steering_angle)
{
  const VehicleParameters & p = parameters_;
  const std::uint64_t key = noiseKeyNow();
  const double mean_steering_angle = 0.5 * (last_steering_angle_ + steering_angle);
  const double measured_angle =
    mean_steering_angle + p.odometry_steering_offset + p.odometry_steering_noise_stddev * gaussian(key, 0);
  current_.speed = measuredSpeed(distance_, gaussian(key, 1));
  const maths::SineCosine steering = maths::sineCosine(measured_angle);
  current_.yaw_rate = current_.speed * steering.sine / steering.cosine / p.wheelbase();
  last_steering_angle_ = steering_angle;
}

void WheelOdometryIntegrator::sampleFree()
{
  const std::uint64_t key = noiseKeyNow();
  const double apart = 0.5 * track_width_ * turn_;
  const double left = measuredSpeed(distance_ - apart, gaussian(key, 0));
  const double right = measuredSpeed(distance_ + apart, gaussian(key, 1));
  current_.speed = 0.5 * (left + right);
  current_.lateral_speed = measuredSpeed(sideways_, gaussian(key, 2));
  current_.yaw_rate = (right - left) / track_width_;
}

/// Integrates from the last sample with the measured speeds.
void WheelOdometryIntegrator::integrate()
{
  const double turn = current_.yaw_rate * elapsed_;
  const double ahead = current_.speed * elapsed_;
  const double aside = current_.lateral_speed * elapsed_;
  const maths::SineCosine course = maths::sineCosine(current_.pose.yaw + 0.5 * turn);
  current_.pose.x += ahead * course.cosine - aside * course.sine;
  current_.pose.y += ahead * course.sine + aside * course.cosine;
  current_.pose.yaw = normalizeAngle(current_.pose.yaw + turn);
  beginSample(next_sample_ + 1);
}
}  // namespace f1tenth_sim2d
