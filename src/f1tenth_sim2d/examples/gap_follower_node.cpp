// Answers each scan of a car with one command on `drive`. Run it in the car's namespace:
//   ROS_NAMESPACE=robot1 rosrun f1tenth_sim2d gap_follower
#include <ackermann_msgs/AckermannDriveStamped.h>
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>

#include "gap_follower.h"

int main(int argc, char ** argv)
{
  ros::init(argc, argv, "gap_follower");
  ros::NodeHandle node;
  gap_follower::GapFollower driver;
  ackermann_msgs::AckermannDriveStamped command;
  const ros::Publisher publisher = node.advertise<ackermann_msgs::AckermannDriveStamped>("drive", 10);
  const auto onScan = [&](const sensor_msgs::LaserScan::ConstPtr & scan) {
    const auto [speed, steering_angle] = driver.drive({scan->angle_min, scan->angle_increment, scan->ranges});
    command.header.stamp = scan->header.stamp;
    command.drive.speed = static_cast<float>(speed);
    command.drive.steering_angle = static_cast<float>(steering_angle);
    publisher.publish(command);
  };
  const ros::Subscriber subscriber =
    node.subscribe<sensor_msgs::LaserScan>("scan", 10, onScan, ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay());
  ros::spin();
}
