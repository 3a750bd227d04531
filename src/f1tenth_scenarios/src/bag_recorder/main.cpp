#include <ros/callback_queue.h>
#include <ros/master.h>
#include <ros/ros.h>
#include <xmlrpcpp/XmlRpcValue.h>

#include <atomic>
#include <csignal>
#include <fstream>
#include <iostream>

#include "bag_writer.h"
#include "topics_of_cars.h"

namespace
{
using f1tenth_scenarios::BagWriter;
using f1tenth_scenarios::kMegabyte;
using f1tenth_scenarios::NodesByTopic;
using XmlRpc::XmlRpcValue;

constexpr BagWriter::Limits kLimits{64 * kMegabyte, 256 * kMegabyte};
const ros::WallDuration kPoll{0.02};
const ros::WallDuration kLookPeriod{0.1};  // between two looks at who publishes what

struct Parameters
{
  std::string bag;                  // the file
  std::string dropped;              // the file that names the topics which reached a limit
  std::vector<std::string> topics;  // heard from the start
  std::vector<std::string> cars;    // whose nodes' topics are heard as soon as they are there
};

std::atomic<bool> stopped{false};  // by a signal

Parameters readParameters()
{
  Parameters read;
  if (!(ros::param::get("~bag", read.bag) && ros::param::get("~dropped", read.dropped) &&
        ros::param::get("~topics", read.topics) && ros::param::get("~cars", read.cars))) {
    throw std::runtime_error("needs the parameters ~bag and ~dropped, files, and ~topics and ~cars, lists of names");
  }
  return read;
}

NodesByTopic nodesByTopic(XmlRpcValue & end)
{
  NodesByTopic nodes;
  for (int index = 0; index < end.size(); ++index) {
    XmlRpcValue & names = end[index][1];
    for (int number = 0; number < names.size(); ++number) {
      nodes[end[index][0]].insert(names[number]);
    }
  }
  return nodes;
}

void hearCars(BagWriter & writer, const std::vector<std::string> & cars)
{
  XmlRpcValue request;
  XmlRpcValue response;
  XmlRpcValue ends;
  request[0] = ros::this_node::getName();
  if (!ros::master::execute("getSystemState", request, response, ends, false)) {
    return;  // it ends before its nodes
  }
  for (const std::string & topic :
       f1tenth_scenarios::topicsOfCars(nodesByTopic(ends[0]), nodesByTopic(ends[1]), cars)) {
    writer.recordWithinLimits(topic);
  }
}

void record(const Parameters & parameters)
{
  BagWriter writer(parameters.bag, kLimits);
  for (const std::string & topic : parameters.topics) {
    writer.record(topic);
  }
  ros::WallTime look;
  while (!stopped && ros::ok()) {
    if (ros::WallTime::now() >= look) {
      hearCars(writer, parameters.cars);
      look = ros::WallTime::now() + kLookPeriod;
    }
    ros::getGlobalCallbackQueue()->callAvailable(kPoll);
  }
  // What has arrived by now belongs to the run.
  ros::getGlobalCallbackQueue()->callAvailable();
  writer.close();
  std::ofstream names(parameters.dropped);
  for (const std::string & line : writer.dropped()) {
    names << line << '\n';
  }
}
}  // namespace

int main(int argc, char ** argv)
{
  ros::init(argc, argv, "bag_recorder", ros::init_options::NoSigintHandler);
  for (const int signal : {SIGINT, SIGTERM}) {
    std::signal(signal, [](int) { stopped = true; });
  }
  // Keeps the node up until the bag is complete.
  const ros::NodeHandle node;
  try {
    record(readParameters());
  } catch (const std::exception & error) {
    std::cerr << "bag_recorder: " << error.what() << std::endl;
    return 1;
  }
  return 0;
}
