#include "node/transport/direct_sender.h"

#include <algorithm>

#include "node/transport/subscriber_connections.h"

namespace f1tenth_sim2d
{
namespace
{
// A socket has room if a third of its buffer is free, which for usual sockets is more than this.
constexpr std::size_t kAlwaysFits = 16384;
}  // namespace

bool DirectSender::isOutdated(ros::Publication & publication) const
{
  return somebody_has_gone_ || publication.getNumSubscribers() != subscribers_;
}

void DirectSender::lookAt(ros::Publication & publication)
{
  somebody_has_gone_ = false;
  sockets_.clear();
  polls_.clear();
  // First, so that one who comes in between is noticed next time.
  subscribers_ = publication.getNumSubscribers();
  for (const auto & connection : connectionsOf(publication)) {
    OwnedSocket socket(connection.socket);
    if (socket.peer() == connection.peer) {
      polls_.push_back({socket.get(), POLLOUT, 0});
      sockets_.push_back(std::move(socket));
    }
  }
  if (sockets_.size() != subscribers_) {
    sockets_.clear();
    polls_.clear();
  }
}

bool DirectSender::send(const std::uint8_t * bytes, std::size_t size)
{
  if (sockets_.empty() || size > kAlwaysFits || !haveRoom()) {
    return false;
  }
  for (const auto & socket : sockets_) {
    somebody_has_gone_ = !socket.send(bytes, size) || somebody_has_gone_;
  }
  return true;
}

bool DirectSender::haveRoom()
{
  const int ready = poll(polls_.data(), polls_.size(), 0);
  if (ready > 0) {
    somebody_has_gone_ = std::any_of(polls_.begin(), polls_.end(), [](const pollfd & each) {
      return (each.revents & (POLLHUP | POLLERR | POLLNVAL)) != 0;
    });
  }
  return ready == static_cast<int>(polls_.size()) && !somebody_has_gone_;
}
}  // namespace f1tenth_sim2d
