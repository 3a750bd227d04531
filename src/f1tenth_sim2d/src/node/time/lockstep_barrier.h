#pragma once

#include <ros/callback_queue.h>
#include <ros/message_event.h>
#include <ros/node_handle.h>
#include <sim2d_lockstep/done_ledger.h>
#include <sim2d_lockstep/participant.h>
#include <std_msgs/Header.h>

#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "f1tenth_sim2d/errors.h"
#include "f1tenth_sim2d/simulation.h"
#include "node/parameters/node_parameters.h"

namespace f1tenth_sim2d
{
/// A participant of lockstep has not answered in time.
class ParticipantSilent : public Error
{
public:
  ParticipantSilent(std::string participant, const std::string & message);
  /// The first that is missing in the order of `participants`: the others may only be waiting for it.
  const std::string & participant() const { return participant_; }

private:
  std::string participant_;
};

/// An answer to another scan that was taken for the one that was missing, as nothing else came: what happens then
/// depends on wall time.
struct StrayAnswer
{
  std::string participant;
  std::int64_t period{0};
  double time_sec{0.0};  ///< end of the period, simulated
};

/// Where the simulation waits until every participant has answered a period; docs/lockstep.md.
class LockstepBarrier
{
public:
  struct Hooks
  {
    std::function<bool()> interrupted;  ///< true: stop waiting
    std::function<bool()> paused;       ///< true: the time does not count
    std::function<void()> look;         ///< called whenever something may have changed
    std::function<void()> repeat;       ///< publishes the period again, as long as it is a first one
  };

  /// Told of a node that answers for a participant that it is not.
  using Impostor = std::function<void(const std::string & node, const std::string & participant)>;

  /// @param queue  served while waiting; node delivers into it, and so must the command inputs
  LockstepBarrier(ros::NodeHandle & node, ros::CallbackQueue & queue, LockstepOptions options, Impostor on_impostor);

  /// Answers now count for the period that ends at `end`, the `number`-th. To be called before it is published.
  void open(SimTime end, std::int64_t number);
  /// What is to be called with its stamp, 0 if it has none, whenever the driver of this car has sent a command. Nobody
  /// waits for it if it is not among the participants.
  std::function<void(const ros::Time &)> driverOf(const std::string & car);
  /// A car was added. If its driver is to answer, the period is one like the first: it is repeated until the driver,
  /// which has to connect, has answered it.
  /// @return whether it is such a period, whoever is waited for
  bool welcome(const std::string & car);
  /// The driver of this car has nothing to answer in the period.
  void excuse(const std::string & car);
  bool hasAnswered(const std::string & participant) const;
  /// Blocks until everybody has answered and everything sent before has been handled, or interrupted() is true.
  /// @throws ParticipantSilent
  void wait(const Hooks & hooks);
  const std::vector<StrayAnswer> & strays() const { return strays_; }
  /// A new run from time 0.
  void restart();

private:
  /// @return whether the period was published again
  bool waitForAnswers(const Hooks & hooks);
  bool takesPart(const std::string & name) const;
  void noteDone(const ros::MessageEvent<const std_msgs::Header> & event);
  void noteCommand(const std::string & car, const ros::Time & stamp);
  void takeSurplus();
  void settle();
  double timeoutSec() const { return started_ ? options_.timeout_sec : options_.startup_timeout_sec; }
  [[noreturn]] void fail() const;

  const LockstepOptions options_;
  ros::CallbackQueue & queue_;
  sim2d_lockstep::InboxDrain drain_;
  sim2d_lockstep::DoneLedger ledger_;
  const Impostor on_impostor_;
  std::set<std::pair<std::string, std::string>> impostors_;  // and for whom they answered
  ros::Subscriber subscriber_;
  std::map<std::string, int> surplus_;  // commands without a stamp by car, beyond the one in each period
  std::vector<StrayAnswer> strays_;
  std::set<std::string> late_;  // cars with a command in this period that answers the first
  ros::Time first_;             // end of the first period, or of the last one that was repeated like it
  ros::Time stamp_;
  std::int64_t number_{0};
  bool started_{false};  // false: the period is repeated
};
}  // namespace f1tenth_sim2d
