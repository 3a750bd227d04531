#pragma once

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <string>

namespace f1tenth_sim2d::test
{
/// Two ends of a TCP connection within this process.
class TcpPair
{
public:
  TcpPair()
  {
    const int server = socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    bind(server, reinterpret_cast<sockaddr *>(&address), sizeof address);
    listen(server, 1);
    socklen_t length = sizeof address;
    getsockname(server, reinterpret_cast<sockaddr *>(&address), &length);
    theirs_ = socket(AF_INET, SOCK_STREAM, 0);
    connect(theirs_, reinterpret_cast<sockaddr *>(&address), sizeof address);
    ours_ = accept(server, reinterpret_cast<sockaddr *>(&address), &length);
    port_ = ntohs(address.sin_port);
    ::close(server);
  }
  ~TcpPair()
  {
    closeOurs();
    hangUp();
  }
  TcpPair(const TcpPair &) = delete;
  TcpPair & operator=(const TcpPair &) = delete;

  int ours() const { return ours_; }
  /// Of the other end, as our end sees it.
  std::string peer() const { return "127.0.0.1:" + std::to_string(port_); }

  /// Waits until the other end has got `size` bytes, or the connection has ended.
  std::string read(std::size_t size) const
  {
    std::string bytes(size, '\0');
    const ssize_t count = recv(theirs_, bytes.data(), size, MSG_WAITALL);
    bytes.resize(count < 0 ? 0 : static_cast<std::size_t>(count));
    return bytes;
  }
  /// Whether anything has arrived.
  bool isEmpty() const
  {
    char byte = 0;
    return recv(theirs_, &byte, 1, MSG_DONTWAIT | MSG_PEEK) < 0;
  }
  void closeOurs() { close(ours_); }
  void hangUp() { close(theirs_); }

private:
  static void close(int & end)
  {
    if (end >= 0) {
      ::close(end);
      end = -1;
    }
  }

  int ours_;
  int theirs_;
  int port_;
};
}  // namespace f1tenth_sim2d::test
