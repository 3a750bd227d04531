// Steers towards the side with more space, in C++ on Fast DDS; the argument says how it hears scans.
#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <memory>
#include <string>

#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <unistd.h>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>

#include "fastdds_messages.h"

using namespace eprosima::fastdds::dds;

namespace
{

// The mean range (m) of the beams between two angles (rad).
float space(const LaserScan & scan, float from, float to)
{
  float sum = 0;
  int count = 0;
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    const float angle = scan.angle_min + scan.angle_increment * static_cast<float>(i);
    if (angle > from && angle < to) sum += std::min(scan.ranges[i], 4.0F), ++count;
  }
  return sum / static_cast<float>(std::max(count, 1));
}

class Driver : public DataReaderListener
{
public:
  explicit Driver(DataWriter * commands) : commands_(commands) {}

  void on_data_available(DataReader * reader) override
  {
    LaserScan scan;
    SampleInfo info;
    while (reader->take_next_sample(&scan, &info) == ReturnCode_t::RETCODE_OK) {
      if (info.valid_data) answer(scan);
    }
  }

private:
  void answer(const LaserScan & scan)
  {
    AckermannDriveStamped command;
    command.header = scan.header;
    const float left = space(scan, 0.2F, 1.2F), right = space(scan, -1.2F, -0.2F);
    command.steering_angle = std::clamp(0.6F * (left - right), -0.4F, 0.4F);
    command.speed = 1.2F;
    commands_->write(&command);
  }

  DataWriter * commands_;
};

// As rmw_fastrtps_cpp makes one with ROS_LOCALHOST_ONLY, but for shared memory.
DomainParticipant * make_participant()
{
  DomainParticipantQos qos = PARTICIPANT_QOS_DEFAULT;
  qos.transport().use_builtin_transports = false;
  qos.transport().user_transports.push_back(std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>());
  const int domain = std::atoi(std::getenv("ROS_DOMAIN_ID"));
  return DomainParticipantFactory::get_instance()->create_participant(domain, qos);
}

}  // namespace

int main(int, char ** arguments)
{
  std::signal(SIGINT, SIG_DFL);
  auto * participant = make_participant();
  const TypeSupport scan_type(new TypeOf<LaserScan>), command_type(new TypeOf<AckermannDriveStamped>);
  scan_type.register_type(participant);
  command_type.register_type(participant);
  auto * scans = participant->create_topic("rt/scan", LaserScan::NAME, TOPIC_QOS_DEFAULT);
  auto * commands = participant->create_topic("rt/drive", AckermannDriveStamped::NAME, TOPIC_QOS_DEFAULT);

  auto * publisher = participant->create_publisher(PUBLISHER_QOS_DEFAULT);
  Driver driver(publisher->create_datawriter(commands, DATAWRITER_QOS_DEFAULT));  // reliable
  DataReaderQos reader_qos = DATAREADER_QOS_DEFAULT;                              // best effort
  if (std::string(arguments[1]) == "reliable") reader_qos.reliability().kind = RELIABLE_RELIABILITY_QOS;
  auto * subscriber = participant->create_subscriber(SUBSCRIBER_QOS_DEFAULT);
  subscriber->create_datareader(scans, reader_qos, &driver);
  pause();
}
