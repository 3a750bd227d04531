#include "bag_writer.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace f1tenth_scenarios
{
namespace
{
constexpr std::uint32_t kNoLimit = 0;   // of a subscriber's queue
constexpr double kPicturePeriod = 0.5;  // s, as the report shows them; whole, they would fill the bag at once
const std::array<const char *, 3> kPictures{
  "sensor_msgs/Image", "sensor_msgs/CompressedImage", "sensor_msgs/PointCloud2"};
}  // namespace

BagWriter::BagWriter(const std::string & file, const Limits & limits)
: bag_{file, rosbag::bagmode::Write}, limits_{limits}
{
  bag_.setCompression(rosbag::compression::LZ4);
}

void BagWriter::record(const std::string & topic)
{
  subscribe(topic, false);
}

void BagWriter::recordWithinLimits(const std::string & topic)
{
  subscribe(topic, true);
}

void BagWriter::close()
{
  topics_.clear();
  bag_.close();
}

void BagWriter::subscribe(const std::string & topic, bool is_limited)
{
  if (topics_.count(topic) > 0) {
    return;
  }
  const boost::function<void(const Event &)> take = [this, topic, is_limited](const Event & event) {
    this->take(topic, event, is_limited);
  };
  topics_[topic].subscriber = node_.subscribe<topic_tools::ShapeShifter>(topic, kNoLimit, take);
}

void BagWriter::take(const std::string & name, const Event & event, bool is_limited)
{
  Topic & topic = topics_.at(name);
  const topic_tools::ShapeShifter & message = *event.getMessage();
  // A bag has no stamp of 0, which it is before the simulation begins.
  const ros::Time now = std::max(ros::Time::now(), ros::TIME_MIN);
  if (is_limited && !(isInTime(topic, message, now) && hasRoom(name, topic, message.size(), now))) {
    return;
  }
  bag_.write(name, now, message, event.getConnectionHeaderPtr());
}

bool BagWriter::isInTime(Topic & topic, const topic_tools::ShapeShifter & message, const ros::Time & now) const
{
  if (std::find(kPictures.begin(), kPictures.end(), message.getDataType()) == kPictures.end()) {
    return true;
  }
  if (now < topic.next) {
    return false;
  }
  topic.next = now + ros::Duration(kPicturePeriod);
  return true;
}

bool BagWriter::hasRoom(const std::string & name, Topic & topic, std::uint64_t size, const ros::Time & now)
{
  topic.size += size;
  size_ += size;
  const bool is_too_much = topic.size > limits_.topic;
  if (!is_too_much && size_ <= limits_.all) {
    return true;
  }
  topic.subscriber.shutdown();
  std::array<char, 100> reason{};
  std::snprintf(
    reason.data(), reason.size(), ": left out from %.3f s on, as %s has more than %d MB", now.toSec(),
    is_too_much ? "it" : "all that the planner publishes",
    static_cast<int>((is_too_much ? limits_.topic : limits_.all) / kMegabyte));
  dropped_.push_back(name + reason.data());
  return false;
}
}  // namespace f1tenth_scenarios
