#pragma once

#include <ros/publisher.h>
#include <ros/time.h>
#include <rosgraph_msgs/Clock.h>

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "f1tenth_sim2d/simulation.h"

namespace f1tenth_sim2d
{
/// Something that is published at a fixed rate of simulated time.
class Output
{
public:
  virtual ~Output() = default;
  virtual double rate() const = 0;  ///< Hz; 0: at every physics step
  /// @param anyway  also if nobody subscribes: somebody may ask for it to be repeated
  virtual void update(SimTime now, bool anyway) = 0;
  /// Publishes the last message again, for subscribers that have come since.
  virtual void repeat() = 0;
  /// Whether it is what a driver answers in lockstep.
  virtual bool isAnswered() const { return false; }
  /// Contacts of the car whose output it is, since the previous call.
  virtual void note(const std::vector<Contact> & /*contacts*/) {}
  /// Cars have been put somewhere else: what was noted before is forgotten.
  virtual void restart() {}
};

using OutputList = std::vector<std::unique_ptr<Output>>;

inline ros::Time toRosTime(SimTime time)
{
  return ros::Time().fromNSec(static_cast<std::uint64_t>(time));
}

inline rosgraph_msgs::Clock toClock(SimTime time)
{
  rosgraph_msgs::Clock message;
  message.clock = toRosTime(time);
  return message;
}

/// An output of one topic with one message that is reused. Costs nothing while nobody subscribes.
template <class Message>
class MessageOutput : public Output
{
public:
  double rate() const override { return rate_hz_; }

  void update(SimTime now, bool anyway) override
  {
    if (!anyway && publisher_.getNumSubscribers() == 0) {
      skip();
      return;
    }
    fill(message_, now);
    filled_ = true;
    publisher_.publish(message_);
  }

  void repeat() override
  {
    if (filled_) {
      publisher_.publish(message_);
    }
  }

protected:
  MessageOutput(ros::Publisher publisher, double rate_hz) : rate_hz_(rate_hz), publisher_(std::move(publisher)) {}

  virtual void fill(Message & message, SimTime now) = 0;
  /// Instead of fill() when nobody subscribes.
  virtual void skip() {}

  Message message_;

private:
  const double rate_hz_;
  const ros::Publisher publisher_;
  bool filled_{false};
};
}  // namespace f1tenth_sim2d
