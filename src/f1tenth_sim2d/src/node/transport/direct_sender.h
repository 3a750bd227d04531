#pragma once

#include <poll.h>
#include <ros/publication.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "node/transport/owned_socket.h"

namespace f1tenth_sim2d
{
/// Sends to the subscribers of one topic on the calling thread. roscpp leaves sending to its poll thread, which for every
/// message is woken through a pipe, adds the socket to what epoll waits for and takes it out again: together more work
/// for the kernel than the message itself.
///
/// roscpp still accepts the connections, writes their headers and notices their end. Two writers would mix their bytes
/// on a socket, so send() may be called only while roscpp has nothing left to write of this topic. A subscriber for
/// whom that cannot be known (it has come since lookAt()) or who is not connected over TCP leaves the topic to roscpp.
class DirectSender
{
public:
  /// Whether subscribers have come or gone since lookAt().
  bool isOutdated(ros::Publication & publication) const;
  /// Remembers who subscribes now. What roscpp is given next is the last that it writes to them: once it has, it has
  /// also written their headers, and send() may be called.
  void lookAt(ros::Publication & publication);
  /// Whether all who subscribed at lookAt() read a stream of bytes. A subscriber within this process does not: of what
  /// roscpp is given at once, it takes the first message.
  bool allReadStreams() const { return sockets_.size() == subscribers_; }
  /// Sends to every subscriber, or to none.
  /// @return false: to none, because somebody has no room for it, has gone, or cannot be sent to
  bool send(const std::uint8_t * bytes, std::size_t size);

private:
  bool haveRoom();

  std::uint32_t subscribers_{0};
  std::vector<OwnedSocket> sockets_;  // none if one of the subscribers has none
  std::vector<pollfd> polls_;         // one a socket
  bool somebody_has_gone_{true};
};
}  // namespace f1tenth_sim2d
