#include <ros/connection_manager.h>
#include <ros/init.h>
#include <ros/poll_manager.h>

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>

#include "no_delay.h"
#include "sim2d_lockstep/participant.h"

namespace sim2d_lockstep
{
namespace
{
// A listener runs between two rounds. The first run after the call may come from the round under way, so the rounds
// that count lie between the first and the third.
constexpr std::uint64_t kListenerRuns = 3;
constexpr std::chrono::milliseconds kStartedCheck{100};
}  // namespace

class InboxDrain::Impl
{
public:
  Impl() : poll_manager_(ros::PollManager::instance())
  {
    connection_ = poll_manager_->addPollThreadListener([this] { onRound(); });
    sendSmallMessagesAtOnce(ros::ConnectionManager::instance()->getTCPPort());
  }

  ~Impl() { poll_manager_->removePollThreadListener(connection_); }

  void drain()
  {
    std::unique_lock<std::mutex> lock(mutex_);
    const std::uint64_t target = runs_ + kListenerRuns;
    wanted_ = target;
    poll_manager_->getPollSet().signal();
    while (runs_ < target && ros::isStarted() && !ros::isShuttingDown()) {
      round_done_.wait_for(lock, kStartedCheck);
    }
  }

private:
  void onRound()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ++runs_;
    if (runs_ < wanted_) {
      // Without a signal an idle poll thread sleeps for 100 ms.
      poll_manager_->getPollSet().signal();
    }
    round_done_.notify_all();
  }

  const ros::PollManagerPtr poll_manager_;
  boost::signals2::connection connection_;
  std::mutex mutex_;
  std::condition_variable round_done_;
  std::uint64_t runs_{0};
  std::uint64_t wanted_{0};
};

InboxDrain::InboxDrain() : impl_(std::make_unique<Impl>()) {}
InboxDrain::~InboxDrain() = default;
void InboxDrain::drain()
{
  impl_->drain();
}
}  // namespace sim2d_lockstep
