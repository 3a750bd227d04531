#pragma once

#include <cstdint>

namespace sim2d_lockstep
{
/// Lets small messages leave at once on every connection that is accepted at a port of this process from now on,
/// whatever the other end asked for: Linux hands TCP_NODELAY of a listening socket on to what it accepts. Otherwise the
/// kernel holds a message back until the one before it is acknowledged, for up to 40 ms, and what is sent later over
/// another connection arrives before it.
void sendSmallMessagesAtOnce(std::uint32_t port);
}  // namespace sim2d_lockstep
