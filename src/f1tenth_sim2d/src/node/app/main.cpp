#include <ros/console.h>
#include <ros/init.h>
#include <ros/master.h>
#include <ros/node_handle.h>
#include <ros/param.h>
#include <ros/this_node.h>

#include <cstdio>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "node/app/sim2d_node.h"
#include "node/time/stop_signal.h"

namespace f1tenth_sim2d
{
namespace
{
enum ExitCode
{
  kEndedByRequest = 0,
  kInternalError = 1,  // our own mistake
  kBadInput = 2,
  kParticipantSilent = 3,
};

// roscpp would silently wait for one.
void requireMaster()
{
  if (!ros::master::check()) {
    throw Error("no ROS master at " + ros::master::getURI() + ": start roscore, or set ROS_MASTER_URI");
  }
}

XmlRpc::XmlRpcValue readParameters(const std::string & name)
{
  XmlRpc::XmlRpcValue parameters;
  ros::param::get(name, parameters);
  return parameters;
}

/// The whole life of the node after ros::init: reads its parameters, runs, writes the result file. Whatever goes wrong
/// is one line on stderr.
class Run
{
public:
  /// @param parameters  name of the parameter tree; empty: the node's private parameters
  explicit Run(std::string parameters) : parameters_(std::move(parameters)) {}

  /// @return the exit code
  int operator()()
  {
    const int code = guarded([this] { simulate(); });
    if (result_file_.empty()) {
      return code;
    }
    const int write_code = guarded([this] { writeResult(result_file_, result_); });
    return code == kEndedByRequest ? write_code : code;
  }

private:
  void simulate()
  {
    handleStopSignals();
    requireMaster();
    keeps_ros_running_.emplace();
    const auto & name = parameters_.empty() ? ros::this_node::getName() : parameters_;
    const auto all = readParameters(name);
    result_file_ = parseResultFile(name, all);
    Sim2dNode node(parseNodeParameters(name, all));
    try {
      node.run();
    } catch (const Error &) {
      result_ = node.result();
      throw;
    }
    result_ = node.result();
    result_.reason = "requested";
    std::printf(
      "trajectory hash %s, %lld periods, %.3f s\n", result_.trajectory_hash.c_str(),
      static_cast<long long>(result_.periods), result_.sim_time_sec);
    std::fflush(stdout);
  }

  template <class Action>
  int guarded(const Action & action)
  {
    try {
      action();
      return kEndedByRequest;
    } catch (const ParticipantSilent & error) {
      result_.participant = error.participant();
      return failed(error, "participant_silent", kParticipantSilent);
    } catch (const Error & error) {
      return failed(error, "bad_input", kBadInput);
    } catch (const std::exception & error) {
      return failed(error, "internal_error", kInternalError);
    }
  }

  int failed(const std::exception & error, const char * reason, ExitCode code)
  {
    ROS_FATAL("%s", error.what());
    result_.reason = reason;
    result_.error = error.what();
    return code;
  }

  const std::string parameters_;
  std::optional<ros::NodeHandle> keeps_ros_running_;  // without one, nothing is logged
  std::string result_file_;
  RunResult result_;
};
}  // namespace
}  // namespace f1tenth_sim2d

// sim2d [PARAMETERS]: the name of the parameter tree to read; by default that of the node.
int main(int argc, char ** argv)
{
  // The simulator sets its own ROS time at every step; it must not listen to the /clock that it publishes.
  std::string no_sim_time = "/use_sim_time:=/sim2d/follows_clock";
  std::vector<char *> arguments(argv, argv + argc);
  arguments.push_back(no_sim_time.data());
  int count = static_cast<int>(arguments.size());
  ros::init(count, arguments.data(), "sim2d", ros::init_options::NoSigintHandler);
  return f1tenth_sim2d::Run(count > 1 ? arguments[1] : "")();
}
