#include <nav_msgs/Odometry.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>
#include <sim2d_lockstep/participant.h>
#include <tf2_msgs/TFMessage.h>
#include <xmlrpcpp/XmlRpcException.h>
#include <xmlrpcpp/XmlRpcValue.h>

#include <iostream>
#include <map>
#include <memory>
#include <set>

#include "relay.h"

namespace
{
using f1tenth_scenarios::InputFault;
using f1tenth_scenarios::Relay;
using f1tenth_scenarios::TopicRelay;
using Relays = std::vector<std::unique_ptr<Relay>>;
using XmlRpc::XmlRpcException;
using XmlRpc::XmlRpcValue;

const char * const kUsage =
  "~faults must be a list of {input: odom, scan or tf, at: s, until: s, later, and, if wanted, delay: s}";
const std::set<std::string> kInputs{"odom", "scan", "tf"};
const ros::WallDuration kPatience{0.1};
const ros::WallDuration kPoll{0.002};

double seconds(XmlRpcValue & fault, const std::string & key)
{
  XmlRpcValue & value = fault[key];
  // A missing one would be read as 0.
  if (!value.valid()) {
    throw XmlRpcException(key);
  }
  return value.getType() == XmlRpcValue::TypeInt ? static_cast<int>(value) : static_cast<double>(value);
}

// The parameter `faults`, by input. Whatever is wrong with it is an XmlRpcException.
std::map<std::string, std::vector<InputFault>> readFaults()
{
  XmlRpcValue list;
  ros::param::get("~faults", list);
  // Because texts and maps have a size, too.
  if (list.getType() != XmlRpcValue::TypeArray) {
    throw XmlRpcException("faults");
  }
  std::map<std::string, std::vector<InputFault>> faults;
  for (int index = 0; index < list.size(); ++index) {
    XmlRpcValue & each = list[index];
    const InputFault fault{
      seconds(each, "at"), seconds(each, "until"),
      each.hasMember("delay") ? std::optional<double>(seconds(each, "delay")) : std::nullopt};
    const auto input = static_cast<std::string>(each["input"]);
    if (kInputs.count(input) == 0 || fault.until <= fault.at) {
      throw XmlRpcException(input);
    }
    faults[input].push_back(fault);
  }
  return faults;
}

std::unique_ptr<Relay> makeRelay(ros::NodeHandle & node, const std::string & input, std::vector<InputFault> faults)
{
  if (input == "scan") {
    return std::make_unique<TopicRelay<sensor_msgs::LaserScan>>(node, "scan", "scan_faulty", std::move(faults));
  }
  if (input == "odom") {
    return std::make_unique<TopicRelay<nav_msgs::Odometry>>(node, "odom", "odom_faulty", std::move(faults));
  }
  return std::make_unique<TopicRelay<tf2_msgs::TFMessage>>(node, "/tf", "tf_faulty", std::move(faults));
}

Relays makeRelays(ros::NodeHandle & node)
{
  Relays relays;
  for (auto & [input, faults] : readFaults()) {
    relays.push_back(makeRelay(node, input, std::move(faults)));
  }
  return relays;
}

void passOn(const Relays & relays, const ros::Time & now)
{
  ros::getGlobalCallbackQueue()->callAvailable();
  for (const auto & relay : relays) {
    relay->passOn(now);
  }
}

void spin(const Relays & relays)
{
  while (ros::ok()) {
    ros::getGlobalCallbackQueue()->callAvailable(kPoll);
    passOn(relays, ros::Time::now());
  }
}

// Until its first answer the planner needs its inputs at once, to become ready.
void spinInLockstep(const Relays & relays, const std::string & planner)
{
  sim2d_lockstep::Participant participant(ros::this_node::getName().substr(1), {planner});
  bool planner_ready = false;
  while (ros::ok()) {
    const auto stamp = participant.waitForPeriod(kPatience);
    if (stamp || !planner_ready) {
      passOn(relays, stamp.value_or(ros::Time::now()));
    }
    if (stamp) {
      planner_ready = true;
      participant.done(*stamp);
    }
  }
}
}  // namespace

int main(int argc, char ** argv)
{
  ros::init(argc, argv, "faulty_inputs");
  ros::NodeHandle node;
  Relays relays;
  try {
    relays = makeRelays(node);
  } catch (const XmlRpcException &) {
    std::cerr << "faulty_inputs: " << kUsage << std::endl;
    return 1;
  }
  if (ros::param::param("~lockstep", false)) {
    spinInLockstep(relays, ros::param::param<std::string>("~planner", "move_base"));
  } else {
    spin(relays);
  }
  return 0;
}
