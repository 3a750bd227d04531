#pragma once

#include <string>
#include <utility>

#include "f1tenth_sim2d/publishing.h"
#include "node/messages/output.h"

namespace f1tenth_sim2d
{
inline std::string withoutPrefix(const std::string & name, const std::string & prefix)
{
  return name.rfind(prefix, 0) == 0 ? name.substr(prefix.size()) : name;
}

/// A car, how and where it publishes, and the prefix of its frames.
struct CarHandle
{
  const Simulation & simulation;
  CarId id;
  Advertiser & advertiser;
  TransformSender & transforms;
  ros::NodeHandle node;  ///< in the car's namespace
  std::string frame_prefix;

  const CarDescription & description() const { return simulation.car(id); }
  /// A frame id of the description with the car's prefix, which a description for several cars may already contain.
  std::string frame(const std::string & given) const { return frame_prefix + withoutPrefix(given, frame_prefix); }
  template <class Message>
  ros::Publisher advertise(const std::string & topic) const
  {
    return advertiser.advertise<Message>(node, topic);
  }
};

/// A sensor of a car on its topic: its mount or description says where it is and how often it measures, sample() what.
template <class Description, class Message>
class SensorOutput : public MessageOutput<Message>
{
protected:
  SensorOutput(CarHandle car, const Description & sensor)
  : MessageOutput<Message>(car.advertise<Message>(sensor.topic), sensor.rate_hz), car_(std::move(car)), sensor_(sensor)
  {
    this->message_.header.frame_id = car_.frame(sensor_.frame);
  }

  /// Puts what is measured now into the message, which has its stamp and frame already.
  virtual void sample(Message & message) = 0;

  const CarHandle car_;
  const Description sensor_;

private:
  void fill(Message & message, SimTime now) override
  {
    message.header.stamp = toRosTime(now);
    sample(message);
  }
};
}  // namespace f1tenth_sim2d
