#pragma once

#include <ackermann_msgs/AckermannDriveStamped.h>
#include <geometry_msgs/Twist.h>
#include <ros/node_handle.h>

#include <functional>
#include <optional>
#include <string>

#include "f1tenth_sim2d/simulation.h"

namespace f1tenth_sim2d
{
/// The driver's side of a car: the topics `cmd_vel` and `drive`, unless controllers drive it. A command that is not
/// finite, or absurd, is refused and counted; it never reaches the physics.
class CommandInput
{
public:
  /// Gets the stamp of a command; 0 for one without.
  using Answered = std::function<void(const ros::Time &)>;

  /// @param node        in the car's namespace; its callback queue must be served by the simulation's thread
  /// @param on_command  called for every message, also for a refused one: the driver has answered
  CommandInput(Simulation & simulation, CarId car, ros::NodeHandle node, Answered on_command);

  /// The driver has sent a command to a controller, which accepted it if there is no objection. Commands to several
  /// joints at the same time count once.
  void noteTold(const std::string & objection);

  std::size_t accepted() const { return accepted_; }
  std::size_t refused() const { return refused_; }
  /// Why the last one was refused; empty if none was.
  const std::string & lastRefusal() const { return last_refusal_; }

private:
  void onTwist(const geometry_msgs::Twist & message);
  void onDrive(const ackermann_msgs::AckermannDriveStamped & message);
  void take(const ros::Time & stamp, const std::function<void()> & command);
  void refuse(const std::string & why);

  Simulation & simulation_;
  const CarId car_;
  const Answered on_command_;
  std::size_t accepted_{0};
  std::optional<SimTime> accepted_at_;  ///< by controllers
  std::size_t refused_{0};
  std::string last_refusal_;
  ros::Subscriber twist_subscriber_;
  ros::Subscriber drive_subscriber_;
};
}  // namespace f1tenth_sim2d
