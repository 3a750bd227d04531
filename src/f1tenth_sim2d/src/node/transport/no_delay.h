#pragma once

namespace f1tenth_sim2d
{
/// Lets small messages leave at once on every connection that this process accepts from now on, whatever the other end
/// asked for. Otherwise the kernel holds the second message of a period back until the first one has been read, and
/// /clock, which goes another way, may overtake it.
/// To be called when ROS has started: Linux hands the option of a listening socket on to the connections it accepts.
void sendSmallMessagesAtOnce();
}  // namespace f1tenth_sim2d
