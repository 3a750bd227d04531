#include "node/transport/no_delay.h"

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include <filesystem>
#include <string>

namespace f1tenth_sim2d
{
namespace
{
bool isListening(int descriptor)
{
  int listens = 0;
  socklen_t length = sizeof listens;
  return getsockopt(descriptor, SOL_SOCKET, SO_ACCEPTCONN, &listens, &length) == 0 && listens != 0;
}
}  // namespace

void sendSmallMessagesAtOnce()
{
  const int on = 1;
  for (const auto & entry : std::filesystem::directory_iterator("/proc/self/fd")) {
    const int descriptor = std::stoi(entry.path().filename());
    if (isListening(descriptor)) {
      setsockopt(descriptor, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
    }
  }
}
}  // namespace f1tenth_sim2d
