#include "sim2d_lockstep/participant.h"

#include <ros/callback_queue.h>
#include <ros/message_event.h>
#include <ros/node_handle.h>
#include <ros/single_subscriber_publisher.h>
#include <rosgraph_msgs/Clock.h>
#include <std_msgs/Header.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "sim2d_lockstep/done_ledger.h"

namespace sim2d_lockstep
{
namespace
{
const ros::WallDuration kShutdownCheck{0.1};
const ros::WallDuration kClockCheck{20e-6};
const ros::WallDuration kFarewell{1.0};
const ros::WallDuration kNotReady{0.002};

void checkNames(const std::string & name, const std::vector<std::string> & after)
{
  if (name.empty() || name.front() == '/') {
    throw std::invalid_argument(
      "name of a lockstep participant: found \"" + name + "\", expected a node's name without the leading slash");
  }
  if (std::find(after.begin(), after.end(), name) != after.end()) {
    throw std::invalid_argument("lockstep participant \"" + name + "\" cannot act after itself");
  }
}
}  // namespace

class Participant::Impl
{
public:
  Impl(std::string name, const std::vector<std::string> & after) : name_(std::move(name)), ledger_(after)
  {
    node_.setCallbackQueue(&queue_);
    const auto hints = ros::TransportHints().tcpNoDelay();
    // Latched: whoever connects after the first answer still gets it.
    const auto on_connect = [this](const ros::SingleSubscriberPublisher & link) { noteListener(link, true); };
    const auto on_disconnect = [this](const ros::SingleSubscriberPublisher & link) { noteListener(link, false); };
    done_publisher_ = node_.advertise<std_msgs::Header>("/sim2d/done", 100, on_connect, on_disconnect, {}, true);
    // Unlimited, as a lost done would never come again; lockstep itself bounds them to a few per period.
    done_subscriber_ = node_.subscribe("/sim2d/done", 0, &Impl::onDone, this, hints);
    clock_subscriber_ = node_.subscribe("/clock", 0, &Impl::onClock, this, hints);
  }

  std::optional<ros::Time> waitForPeriod(ros::WallDuration timeout)
  {
    const ros::WallTime deadline = ros::WallTime::now() + timeout;
    queue_.callAvailable();
    while (!ready()) {
      const ros::WallDuration left = deadline - ros::WallTime::now();
      if (left <= ros::WallDuration(0.0) || !ros::ok() || left_) {
        return std::nullopt;
      }
      queue_.callAvailable(std::min(left, kShutdownCheck));
    }
    drain_.drain();
    return clockReached(deadline) ? period_ : std::nullopt;
  }

  void done(const ros::Time & stamp, const ros::Time & until)
  {
    drain_.drain();
    answered_ = stamp;
    not_before_ = until;
    publish(lastWord());
  }

  void leave()
  {
    drain_.drain();
    left_ = true;
    const int unanswered = period_ && answered_ != period_ ? 1 : 2;
    publish(kLeft);
    drain_.drain();
    waitForPeriodsWithout(unanswered);
  }

  bool hasLeft() const { return left_; }

private:
  bool ready() const
  {
    return !left_ && period_ && answered_ != period_ && *period_ >= not_before_ && ledger_.allDone(*period_);
  }

  ros::Time lastWord() const
  {
    const ros::Duration tick(0, 1);
    return not_before_ > *answered_ ? not_before_ - tick : *answered_;
  }

  // A subscriber that the master tells of a publisher's end closes the connection and loses what it has not read yet.
  // The simulator has read the farewell when it publishes a period after one that nobody answered for this participant.
  void waitForPeriodsWithout(int count)
  {
    const ros::WallTime deadline = ros::WallTime::now() + kFarewell;
    while (periods_since_left_ < count && !simulatorEnded() && ros::ok() && ros::WallTime::now() < deadline) {
      queue_.callAvailable(std::min(deadline - ros::WallTime::now(), kShutdownCheck));
    }
  }

  // A killed simulator counts as a publisher of /clock as long as the master says so, but no longer listens.
  bool simulatorEnded() const { return period_ && (clock_subscriber_.getNumPublishers() == 0 || !simulator_listens_); }

  void noteListener(const ros::SingleSubscriberPublisher & link, bool listens)
  {
    if (link.getSubscriberName() == simulator_) {
      simulator_listens_ = listens;
    }
  }

  // roscpp follows /clock on a thread of its own.
  bool clockReached(const ros::WallTime & deadline) const
  {
    while (ros::Time::isSimTime() && ros::Time::now() != *period_) {
      if (ros::WallTime::now() > deadline || !ros::ok()) {
        return false;
      }
      kClockCheck.sleep();
    }
    return true;
  }

  void onClock(const ros::MessageEvent<rosgraph_msgs::Clock const> & event)
  {
    const rosgraph_msgs::Clock::ConstPtr & message = event.getMessage();
    if (simulator_.empty()) {
      simulator_ = event.getPublisherName();
    }
    if (left_) {
      periods_since_left_ += period_ != message->clock;
      period_ = message->clock;
      return;
    }
    if (answered_ == message->clock) {
      publish(lastWord());
    } else if (period_ && message->clock < *period_) {
      ledger_.startAgain(message->clock);
      answered_.reset();
      not_before_ = ros::Time();
    }
    period_ = message->clock;
  }

  void onDone(const std_msgs::Header::ConstPtr & message) { ledger_.note(message->frame_id, message->stamp); }

  void publish(const ros::Time & stamp)
  {
    std_msgs::Header message;
    message.frame_id = name_;
    message.stamp = stamp;
    done_publisher_.publish(message);
  }

  const std::string name_;
  ros::CallbackQueue queue_;  // before what refers to it
  ros::NodeHandle node_;
  InboxDrain drain_;
  DoneLedger ledger_;
  ros::Publisher done_publisher_;
  ros::Subscriber done_subscriber_;
  ros::Subscriber clock_subscriber_;
  std::string simulator_;  // node that publishes /clock
  bool simulator_listens_{true};
  std::optional<ros::Time> period_;
  std::optional<ros::Time> answered_;
  ros::Time not_before_;  // when it is its turn again
  bool left_{false};
  int periods_since_left_{0};
};

Participant::Participant(std::string name, const std::vector<std::string> & after)
{
  checkNames(name, after);
  impl_ = std::make_unique<Impl>(std::move(name), after);
}
Participant::~Participant() = default;
std::optional<ros::Time> Participant::waitForPeriod(ros::WallDuration timeout)
{
  return impl_->waitForPeriod(timeout);
}
void Participant::done(const ros::Time & stamp, const ros::Time & until)
{
  impl_->done(stamp, until);
}
void Participant::actInPeriods(const std::function<bool(const ros::Time &)> & act)
{
  while (ros::ok() && !impl_->hasLeft()) {
    const auto stamp = waitForPeriod(kShutdownCheck);
    const bool acted = stamp && act(*stamp);
    if (acted && !impl_->hasLeft()) {
      done(*stamp);
    } else if (stamp && !acted) {
      kNotReady.sleep();
    }
  }
}
void Participant::leave()
{
  impl_->leave();
}
}  // namespace sim2d_lockstep
