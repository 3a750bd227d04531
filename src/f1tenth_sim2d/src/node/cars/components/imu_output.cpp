#include "node/cars/components/imu_output.h"

#include <algorithm>
#include <array>

namespace f1tenth_sim2d
{
namespace
{
// Roll, pitch and height of a car in the plane are known.
constexpr double kKnown = 1e-9;

/// Sets the variances along the axes of the car of a quantity that a sensor measures along its own.
void setVariances(boost::array<double, 9> & covariance, const Eigen::Vector3d & variances, const Pose3 & sensor)
{
  const Eigen::Matrix3d to_sensor = sensor.rotation.conjugate().toRotationMatrix();
  const Eigen::Matrix3d turned = to_sensor * variances.asDiagonal() * to_sensor.transpose();
  std::copy_n(turned.data(), covariance.size(), covariance.begin());
}

void setVector(geometry_msgs::Vector3 & vector, const double * numbers)
{
  vector.x = numbers[0];
  vector.y = numbers[1];
  vector.z = numbers[2];
}
}  // namespace

ImuOutput::ImuOutput(const CarHandle & car, const Imu & imu) : SensorOutput(car, imu.mount()), imu_(imu)
{
  const Imu::Noise & noise = imu.noise();
  const double rate_variance = noise.yaw_rate_stddev * noise.yaw_rate_stddev;
  const double acceleration_variance = noise.acceleration_stddev * noise.acceleration_stddev;
  message_.orientation_covariance = {kKnown, 0, 0, 0, kKnown, 0, 0, 0, kKnown};
  setVariances(message_.angular_velocity_covariance, {kKnown, kKnown, rate_variance}, sensor_.pose);
  setVariances(
    message_.linear_acceleration_covariance, {acceleration_variance, acceleration_variance, kKnown}, sensor_.pose);
}

void ImuOutput::sample(sensor_msgs::Imu & message)
{
  std::array<double, Imu::kSize> numbers{};
  imu_.sample(car_.simulation, car_.id, numbers.data());
  message.orientation.x = numbers[Imu::kOrientation];
  message.orientation.y = numbers[Imu::kOrientation + 1];
  message.orientation.z = numbers[Imu::kOrientation + 2];
  message.orientation.w = numbers[Imu::kOrientation + 3];
  setVector(message.angular_velocity, &numbers[Imu::kAngularVelocity]);
  setVector(message.linear_acceleration, &numbers[Imu::kAcceleration]);
}
}  // namespace f1tenth_sim2d
