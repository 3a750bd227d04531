#include "f1tenth_navigation_mgr/goal.h"

#include <workspace_support/maths/trigonometry.h>
#include <cmath>
#include <tuple>

namespace f1tenth_navigation_mgr
{
namespace maths = workspace_support::maths;

namespace
{
auto tied(const Goal & g)
{
  return std::tie(g.frame_id, g.x, g.y, g.z, g.qx, g.qy, g.qz, g.qw);
}
}  // namespace

double Goal::Yaw() const
{
  return maths::atan2(2.0 * (qw * qz + qx * qy), 1.0 - 2.0 * (qy * qy + qz * qz));
}

bool operator==(const Goal & a, const Goal & b)
{
  return tied(a) == tied(b);
}

Goal PlanarGoal(double x, double y, double yaw, const std::string & frame_id)
{
  return Goal{frame_id, x, y, 0.0, 0.0, 0.0, maths::sin(yaw / 2.0), maths::cos(yaw / 2.0)};
}
}  // namespace f1tenth_navigation_mgr
