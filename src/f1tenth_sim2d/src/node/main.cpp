#include <ros/init.h>

#include "run.h"

int main(int argc, char ** argv)
{
  ros::init(argc, argv, "sim2d", ros::init_options::NoSigintHandler);
  return f1tenth_sim2d::runNode();
}
