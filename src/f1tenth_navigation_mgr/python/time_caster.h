#pragma once

#include <pybind11/pybind11.h>
#include <ros/time.h>

namespace pybind11::detail
{
/// rospy.Time <-> ros::Time.
template <>
struct type_caster<ros::Time>
{
  PYBIND11_TYPE_CASTER(ros::Time, const_name("rospy.Time"));

  bool load(handle source, bool)
  {
    if (!hasattr(source, "secs") || !hasattr(source, "nsecs")) return false;
    value = ros::Time{source.attr("secs").cast<std::uint32_t>(), source.attr("nsecs").cast<std::uint32_t>()};
    return true;
  }

  static handle cast(const ros::Time & time, return_value_policy, handle)
  {
    return module_::import("rospy").attr("Time")(time.sec, time.nsec).release();
  }
};
}  // namespace pybind11::detail
