#pragma once

#include <actionlib/server/simple_action_server.h>
#include <geometry_msgs/PoseStamped.h>
#include <move_base_msgs/MoveBaseAction.h>
#include <nav_msgs/Path.h>
#include <ros/callback_queue.h>
#include <ros/node_handle.h>

#include <memory>
#include <optional>
#include <vector>

#include "diagnostics.h"
#include "displays.h"
#include "move_base/control/navigator.h"
#include "parameters.h"
#include "perception.h"
#include "services.h"

namespace move_base
{
/// The ROS side of the Navigator: action server, topics, services. Everything happens on the thread that calls
/// handleCallbacks() and cycle().
class MoveBaseNode
{
public:
  /// @param queue  served by handleCallbacks() only
  MoveBaseNode(MoveBaseSetup setup, ros::CallbackQueue & queue);

  /// Handles everything that has arrived, and what follows from it.
  void handleCallbacks();
  /// Whether everything needed for driving is there.
  bool ready() const { return perception_.ready(); }
  std::string missing() const { return perception_.missing(); }
  /// Acts, if a control cycle is due at now.
  void cycle(const ros::Time & now);

private:
  using Server = actionlib::SimpleActionServer<move_base_msgs::MoveBaseAction>;

  void startServer();
  bool due(const ros::Time & now);
  void watchClock(const ros::Time & now);
  void renewServer();
  void updateGoal(const ros::Time & now);
  void accept(const geometry_msgs::PoseStamped & target, const ros::Time & now);
  void onGoalsAhead(const nav_msgs::Path::ConstPtr & goals);
  /// The goals that a client says to follow the target, in the map.
  std::vector<Pose2> nextGoals() const;
  void warnOfGoals(const std::vector<Pose2> & goals);
  void abort(const std::string & text);
  void drive(const ros::Time & now);
  void publish(const CycleOutput & output, const CycleInput & input, const ros::Time & now);
  void report(const CycleOutput & output, const CycleInput & input, const ros::Time & now);
  void diagnose(const CycleOutput & output, const ros::Time & now);
  void finish(const Outcome & outcome);
  void publishZero();
  void relayGoal(const geometry_msgs::PoseStamped::ConstPtr & target);

  MoveBaseParameters parameters_;
  ros::CallbackQueue & queue_;
  ros::NodeHandle node_;
  ros::NodeHandle private_node_;
  Perception perception_;
  Navigator navigator_;
  Displays displays_;
  Services services_;
  Diagnostics diagnostics_;
  ros::Publisher velocity_publisher_;
  ros::Publisher goal_publisher_;
  ros::Publisher recovery_publisher_;
  ros::Publisher action_goal_publisher_;
  ros::Subscriber simple_goal_subscriber_;
  ros::Subscriber goals_ahead_subscriber_;
  ros::Subscriber prompt_goals_;
  ros::Subscriber prompt_cancels_;
  std::unique_ptr<Server> server_;
  bool server_is_up_{false};
  bool time_jumped_back_{false};  // since there is this server
  // Those of the server. Held here, they keep their connections when another server takes its place; a client would need
  // seconds to connect again, and what is sent meanwhile would be lost.
  std::vector<ros::Publisher> held_topics_;
  std::string failure_;                   // of the last goal
  geometry_msgs::PoseStamped target_;     // as it was sent
  nav_msgs::Path::ConstPtr goals_ahead_;  // the latest
  bool warned_of_goals_{false};           // since the car last set off
  std::optional<ros::Time> now_;
  std::optional<ros::Time> last_cycle_;
};
}  // namespace move_base
