#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace f1tenth_sim2d
{
/// A connected socket of somebody else, kept open under a number of its own, which nobody can give to another socket.
class OwnedSocket
{
public:
  explicit OwnedSocket(int others);
  ~OwnedSocket();
  OwnedSocket(OwnedSocket && other) noexcept;
  OwnedSocket(const OwnedSocket &) = delete;
  OwnedSocket & operator=(const OwnedSocket &) = delete;
  OwnedSocket & operator=(OwnedSocket &&) = delete;

  int get() const { return socket_; }
  /// Who is at the other end, "127.0.0.1:51234"; "" if nobody.
  std::string peer() const;
  /// Sends all of it, waiting for room if there is none.
  /// @return false: the connection has ended, or has been ended because the other end took nothing for a second
  bool send(const std::uint8_t * bytes, std::size_t size) const;

private:
  int socket_;  // -1: none
};
}  // namespace f1tenth_sim2d
