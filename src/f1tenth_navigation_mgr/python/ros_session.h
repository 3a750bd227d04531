#pragma once

/// Makes this process a roscpp node, beside the rospy node that it may be as well.
///
/// The roscpp half is called like the rospy node with `_roscpp` behind (the master would end one of two nodes with the
/// same name), anonymous where there is none. It takes remappings and namespace from the command line, and leaves
/// signals to Python. Does nothing where another module
/// of this process has already done it. ros::shutdown() runs at interpreter exit.
/// @throws f1tenth_navigation_mgr::Error when the master cannot be reached
void ensureRos();
