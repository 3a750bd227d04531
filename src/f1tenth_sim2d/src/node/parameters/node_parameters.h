#pragma once

#include <xmlrpcpp/XmlRpc.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "f1tenth_sim2d/geometry.h"
#include "f1tenth_sim2d/simulation.h"

namespace f1tenth_sim2d
{
/// Who publishes odom -> base_footprint.
enum class OdometryOwner
{
  kPerfect,
  kWheel,
};

struct CarParameters
{
  std::string name;
  std::string ros_namespace;      ///< "/robot1"; "/" for none
  std::optional<Pose2> pose;      ///< start; by default that of the world
  bool relative_to_start{false};  ///< pose is in the frame of the world's start, not of the world
  std::string vehicle_file;       ///< empty: the dynamics that the description gives
  std::string frame_prefix;       ///< "robot1/" or ""
};

/// Where a car starts in a world with this start.
Pose2 startPose(const CarParameters & car, const Pose2 & world_start);

struct LockstepOptions
{
  std::vector<std::string> participants;  ///< in the order in which they act
  double timeout_sec{5.0};                ///< wall time, per period
  double startup_timeout_sec{60.0};       ///< wall time, until everybody has answered once
};

/// All parameters of the node, read once.
struct NodeParameters
{
  std::string world_file;
  std::vector<CarParameters> cars;
  bool is_lockstep{false};       ///< one control period, then wait for all participants
  double real_time_factor{1.0};  ///< simulated seconds per wall second; 0, and in lockstep: as fast as possible
  LockstepOptions lockstep;
  double control_period_sec{0.025};
  SimulationOptions simulation;
  bool paused{false};           ///< at the start
  double clock_rate_hz{200.0};  ///< of simulated time
  OdometryOwner odometry{OdometryOwner::kPerfect};
  std::string record_file;         ///< empty: none
  std::string interventions_file;  ///< empty: none
};

/// @param name  of the node, "/sim2d"
/// @param all   its private parameters
/// @throws workspace_support::OptionError naming the parameter, what was found and what is allowed
NodeParameters parseNodeParameters(const std::string & name, const XmlRpc::XmlRpcValue & all);

/// Apart from the others, because it also serves to report that they are wrong. Empty: none.
/// @throws workspace_support::OptionError
std::string parseResultFile(const std::string & name, const XmlRpc::XmlRpcValue & all);
}  // namespace f1tenth_sim2d
