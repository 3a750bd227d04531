#include "node/transport/no_delay.h"

#include <gtest/gtest.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

namespace
{
class Socket
{
public:
  explicit Socket(int descriptor) : descriptor_(descriptor) {}
  ~Socket() { close(descriptor_); }
  Socket(const Socket &) = delete;
  Socket & operator=(const Socket &) = delete;
  int get() const { return descriptor_; }

private:
  const int descriptor_;
};
}  // namespace

TEST(NoDelay, IsHandedOnToAcceptedConnections)
{
  const Socket listening(socket(AF_INET, SOCK_STREAM, 0));
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t length = sizeof address;
  auto * const raw = reinterpret_cast<sockaddr *>(&address);
  ASSERT_EQ(bind(listening.get(), raw, length), 0);
  ASSERT_EQ(listen(listening.get(), 1), 0);
  ASSERT_EQ(getsockname(listening.get(), raw, &length), 0);

  f1tenth_sim2d::sendSmallMessagesAtOnce();
  const Socket subscriber(socket(AF_INET, SOCK_STREAM, 0));
  ASSERT_EQ(connect(subscriber.get(), raw, length), 0);
  const Socket accepted(accept(listening.get(), nullptr, nullptr));
  int is_on = 0;
  length = sizeof is_on;
  ASSERT_EQ(getsockopt(accepted.get(), IPPROTO_TCP, TCP_NODELAY, &is_on, &length), 0);
  EXPECT_NE(is_on, 0);
}
