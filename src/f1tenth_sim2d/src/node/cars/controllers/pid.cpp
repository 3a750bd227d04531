#include "node/cars/controllers/pid.h"

#include <algorithm>

namespace f1tenth_sim2d
{
double Pid::effort(double error, double dt, double limit)
{
  integral_ += gains_.i * error * dt;
  if (gains_.i_clamp > 0.0) {
    integral_ = std::clamp(integral_, -gains_.i_clamp, gains_.i_clamp);
  }
  const double slope = has_last_ ? (error - last_error_) / dt : 0.0;
  last_error_ = error;
  has_last_ = true;
  return std::clamp(gains_.p * error + integral_ + gains_.d * slope, -limit, limit);
}
}  // namespace f1tenth_sim2d
