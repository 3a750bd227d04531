// The two messages that a reactive planner needs, as ROS 2 puts them on DDS, for Fast DDS.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <fastcdr/Cdr.h>
#include <fastcdr/FastBuffer.h>
#include <fastdds/dds/topic/TopicDataType.hpp>

struct Header
{
  std::int32_t seconds = 0;
  std::uint32_t nanoseconds = 0;
  std::string frame;

  template <class Archive>
  void visit(Archive && each)
  {
    each(seconds), each(nanoseconds), each(frame);
  }
};

struct LaserScan
{
  static constexpr const char * NAME = "sensor_msgs::msg::dds_::LaserScan_";
  Header header;
  float angle_min = 0, angle_max = 0, angle_increment = 0;  // rad
  float time_increment = 0, scan_time = 0;                  // s
  float range_min = 0, range_max = 0;                       // m
  std::vector<float> ranges, intensities;

  template <class Archive>
  void visit(Archive && each)
  {
    header.visit(each);
    each(angle_min), each(angle_max), each(angle_increment), each(time_increment), each(scan_time);
    each(range_min), each(range_max), each(ranges), each(intensities);
  }
};

struct AckermannDriveStamped
{
  static constexpr const char * NAME = "ackermann_msgs::msg::dds_::AckermannDriveStamped_";
  Header header;
  float steering_angle = 0, steering_angle_velocity = 0;  // rad, rad/s
  float speed = 0, acceleration = 0, jerk = 0;            // m/s, m/s^2, m/s^3

  template <class Archive>
  void visit(Archive && each)
  {
    header.visit(each);
    each(steering_angle), each(steering_angle_velocity), each(speed), each(acceleration), each(jerk);
  }
};

// What fastddsgen would write: a message to and from bytes.
template <class Message>
class TypeOf : public eprosima::fastdds::dds::TopicDataType
{
  using Cdr = eprosima::fastcdr::Cdr;
  using Payload = eprosima::fastrtps::rtps::SerializedPayload_t;

public:
  TypeOf()
  {
    setName(Message::NAME);
    m_typeSize = 1 << 16;
  }

  bool serialize(void * data, Payload * payload) override
  {
    eprosima::fastcdr::FastBuffer buffer(reinterpret_cast<char *>(payload->data), payload->max_size);
    Cdr cdr(buffer, Cdr::DEFAULT_ENDIAN, Cdr::DDS_CDR);
    payload->encapsulation = CDR_LE;
    cdr.serialize_encapsulation();
    static_cast<Message *>(data)->visit([&cdr](auto & field) { cdr << field; });
    payload->length = static_cast<std::uint32_t>(cdr.getSerializedDataLength());
    return true;
  }

  bool deserialize(Payload * payload, void * data) override
  {
    eprosima::fastcdr::FastBuffer buffer(reinterpret_cast<char *>(payload->data), payload->length);
    Cdr cdr(buffer, Cdr::DEFAULT_ENDIAN, Cdr::DDS_CDR);
    cdr.read_encapsulation();
    static_cast<Message *>(data)->visit([&cdr](auto & field) { cdr >> field; });
    return true;
  }

  std::function<std::uint32_t()> getSerializedSizeProvider(void *) override
  {
    return [this] { return m_typeSize; };
  }

  void * createData() override { return new Message; }
  void deleteData(void * data) override { delete static_cast<Message *>(data); }
  bool getKey(void *, eprosima::fastrtps::rtps::InstanceHandle_t *, bool) override { return false; }
};
