#include <ros/init.h>

#include <string>
#include <vector>

#include "node/app/run.h"

// sim2d [PARAMETERS]: the name of the parameter tree to read; by default that of the node.
int main(int argc, char ** argv)
{
  // The simulator tells its own ROS time what it is, at every step; it must not listen to the /clock that it publishes.
  std::string no_sim_time = "/use_sim_time:=/sim2d/follows_clock";
  std::vector<char *> arguments(argv, argv + argc);
  arguments.push_back(no_sim_time.data());
  int count = static_cast<int>(arguments.size());
  ros::init(count, arguments.data(), "sim2d", ros::init_options::NoSigintHandler);
  return f1tenth_sim2d::runNode(count > 1 ? arguments[1] : "");
}
