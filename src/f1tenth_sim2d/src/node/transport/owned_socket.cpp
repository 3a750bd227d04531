#include "node/transport/owned_socket.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

namespace f1tenth_sim2d
{
namespace
{
constexpr int kPatienceMs = 1000;

std::string text(int family, const void * address, in_port_t port)
{
  char name[INET6_ADDRSTRLEN];
  inet_ntop(family, address, name, sizeof name);
  return std::string(name) + ":" + std::to_string(ntohs(port));
}

bool becomesWritable(int socket)
{
  pollfd each{socket, POLLOUT, 0};
  return poll(&each, 1, kPatienceMs) == 1 && each.revents == POLLOUT;
}
}  // namespace

OwnedSocket::OwnedSocket(int others) : socket_(fcntl(others, F_DUPFD_CLOEXEC, 0)) {}

OwnedSocket::OwnedSocket(OwnedSocket && other) noexcept : socket_(std::exchange(other.socket_, -1)) {}

OwnedSocket::~OwnedSocket()
{
  if (socket_ >= 0) {
    close(socket_);
  }
}

std::string OwnedSocket::peer() const
{
  sockaddr_storage address{};
  socklen_t length = sizeof address;
  if (getpeername(socket_, reinterpret_cast<sockaddr *>(&address), &length) != 0) {
    return "";
  }
  if (address.ss_family == AF_INET) {
    const auto & ip4 = reinterpret_cast<const sockaddr_in &>(address);
    return text(AF_INET, &ip4.sin_addr, ip4.sin_port);
  }
  if (address.ss_family == AF_INET6) {
    const auto & ip6 = reinterpret_cast<const sockaddr_in6 &>(address);
    return text(AF_INET6, &ip6.sin6_addr, ip6.sin6_port);
  }
  return "";
}

bool OwnedSocket::send(const std::uint8_t * bytes, std::size_t size) const
{
  std::size_t sent = 0;
  while (sent < size) {
    const ssize_t count = ::send(socket_, bytes + sent, size - sent, MSG_DONTWAIT | MSG_NOSIGNAL);
    if (count >= 0) {
      sent += static_cast<std::size_t>(count);
    } else if (errno == EINTR) {
      continue;
    } else if ((errno != EAGAIN && errno != EWOULDBLOCK) || !becomesWritable(socket_)) {
      // Half a message makes all that follows unreadable.
      shutdown(socket_, SHUT_RDWR);
      return false;
    }
  }
  return true;
}
}  // namespace f1tenth_sim2d
