#include <ros/ros.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <tf2_msgs/TFMessage.h>
#include <workspace_support/errors.h>

#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>

#include "slam_node.h"

namespace
{
const char * const kUsage =
  "usage: slam_gmapping_replay --bag_filename FILE [--scan_topic TOPIC] [--seed N] [--on_done COMMAND]";

struct Options
{
  std::string bag_filename;
  std::string scan_topic{"/scan"};
  std::string on_done;
};

// Every seed gives the same map, but an invalid one is a mistake.
void checkSeed(const std::string & text)
{
  const bool digits = !text.empty() && text.size() < 10 && text.find_first_not_of("0123456789") == std::string::npos;
  if (!digits) {
    throw gmapping::OptionError("--seed: found \"" + text + "\", must be a whole number of at most 9 digits");
  }
}

Options readOptions(int argc, char ** argv)
{
  Options options;
  for (int i = 1; i < argc; i += 2) {
    const std::string name = argv[i];
    if (i + 1 == argc) {
      throw gmapping::OptionError(name + ": found nothing behind it; " + kUsage);
    }
    const std::string value = argv[i + 1];
    if (name == "--bag_filename") {
      options.bag_filename = value;
    } else if (name == "--scan_topic") {
      options.scan_topic = value;
    } else if (name == "--seed") {
      checkSeed(value);
    } else if (name == "--on_done") {
      options.on_done = value;
    } else {
      throw gmapping::OptionError(name + ": there is no such option; " + kUsage);
    }
  }
  if (options.bag_filename.empty()) {
    throw gmapping::OptionError(std::string("--bag_filename: found nothing; ") + kUsage);
  }
  return options;
}

void take(const tf2_msgs::TFMessage & message, bool is_static, gmapping::SlamNode & slam)
{
  for (const auto & transform : message.transforms) {
    slam.transforms().setTransform(transform, "bag", is_static);
  }
}

struct Scans
{
  int count{0};
  ros::Time last;
};

Scans play(const Options & options, gmapping::SlamNode & slam)
{
  rosbag::Bag bag(options.bag_filename, rosbag::bagmode::Read);
  rosbag::View view(bag, rosbag::TopicQuery({options.scan_topic, "/tf", "/tf_static"}));
  Scans scans;
  for (const rosbag::MessageInstance & instance : view) {
    if (!ros::ok()) {
      break;
    }
    if (const auto scan = instance.instantiate<sensor_msgs::LaserScan>()) {
      ++scans.count;
      scans.last = scan->header.stamp;
      slam.add(scan);
    } else if (const auto transforms = instance.instantiate<tf2_msgs::TFMessage>()) {
      take(*transforms, instance.getTopic() == "/tf_static", slam);
    }
    slam.handleScans();
    slam.broadcast(instance.getTime());
  }
  slam.giveUpWaiting();
  return scans;
}

// @return the time of the last scan
ros::Time replay(const Options & options, gmapping::SlamNode & slam)
{
  Scans scans;
  try {
    scans = play(options, slam);
  } catch (const std::exception & error) {  // a damaged bag can be anything
    throw gmapping::Error(options.bag_filename + ": " + error.what());
  }
  if (scans.count == 0) {
    throw gmapping::Error(options.bag_filename + ": there is no scan on " + options.scan_topic);
  }
  if (!slam.hasTaken()) {
    throw gmapping::Error(
      options.bag_filename + ": none of " + std::to_string(scans.count) + " scans on " + options.scan_topic +
      " is of use: " + slam.lastReason());
  }
  return scans.last;
}

int run(const Options & options)
{
  const gmapping::NodeParameters parameters = gmapping::readParameters(ros::NodeHandle("~"));
  gmapping::SlamNode slam(parameters, *ros::getGlobalCallbackQueue());
  slam.publishMap(replay(options, slam));
  ros::AsyncSpinner spinner(1);
  spinner.start();
  if (!options.on_done.empty() && std::system(options.on_done.c_str()) != 0) {
    throw gmapping::Error("--on_done: this command has failed: " + options.on_done);
  }
  return 0;
}
}  // namespace

int main(int argc, char ** argv)
{
  ros::init(argc, argv, "slam_gmapping");
  try {
    const Options options = readOptions(argc, argv);
    const ros::NodeHandle node;  // Keeps ROS up.
    return run(options);
  } catch (const std::exception & error) {
    std::cerr << "slam_gmapping_replay: " << error.what() << std::endl;
  }
  return 1;
}
