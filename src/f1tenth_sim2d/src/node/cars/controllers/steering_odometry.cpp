#include "node/cars/controllers/steering_odometry.h"

#include <workspace_support/maths/trigonometry.h>
#include <cmath>

namespace f1tenth_sim2d
{
void SteeringOdometry::advance(double ahead, double turn, double dt)
{
  const double course = pose_.yaw + 0.5 * turn;
  pose_.x += ahead * maths::cos(course);
  pose_.y += ahead * maths::sin(course);
  pose_.yaw += turn;
  rates_.push_back({ahead / dt, turn / dt});
  if (rates_.size() > window_) {
    rates_.pop_front();
  }
}

SteeringOdometry::Rate SteeringOdometry::mean() const
{
  Rate mean;
  for (const Rate & rate : rates_) {
    mean.ahead += rate.ahead / static_cast<double>(rates_.size());
    mean.turn += rate.turn / static_cast<double>(rates_.size());
  }
  return mean;
}
}  // namespace f1tenth_sim2d
