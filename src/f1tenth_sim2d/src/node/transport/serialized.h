#pragma once

#include <ros/message_traits.h>
#include <ros/serialization.h>

namespace f1tenth_sim2d
{
/// A message that is serialised already, for ros::Publisher::publish(): roscpp then shares its buffer with us.
struct Serialized
{
  ros::SerializedMessage message;
};
}  // namespace f1tenth_sim2d

namespace ros
{
namespace message_traits
{
template <>
struct MD5Sum<f1tenth_sim2d::Serialized>
{
  static const char * value(const f1tenth_sim2d::Serialized & /*message*/) { return "*"; }
};

template <>
struct DataType<f1tenth_sim2d::Serialized>
{
  static const char * value(const f1tenth_sim2d::Serialized & /*message*/) { return "*"; }
};
}  // namespace message_traits

namespace serialization
{
template <>
inline SerializedMessage serializeMessage(const f1tenth_sim2d::Serialized & serialized)
{
  return serialized.message;
}
}  // namespace serialization
}  // namespace ros
