#pragma once

#include <controller_manager_msgs/ListControllerTypes.h>
#include <controller_manager_msgs/ListControllers.h>
#include <controller_manager_msgs/SwitchController.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "node/cars/car_outputs.h"
#include "node/cars/command_input.h"
#include "node/cars/joint_controller.h"
#include "node/messages/output.h"
#include "node/world/schedule.h"

namespace f1tenth_sim2d
{
/// What libgazebo_ros_control.so is in Gazebo: the services of a controller manager, and controllers for the wheels and
/// steering joints of a car. While a joint controller runs, the car does what the controllers say.
class RosControl : public Output
{
public:
  /// @param car       its node in the namespace of the controller manager
  /// @param commands  of the car; takes what the controllers want, and counts what was refused
  /// @param simulates_pid  whether wheels obey the pid gains of their controllers, or else follow as fast as the car can
  RosControl(CarHandle car, CommandInput & commands, bool simulates_pid);

  double rate() const override { return rate_hz_; }
  void update(SimTime now, bool anyway) override;
  void repeat() override {}

private:
  struct Controller
  {
    std::string type;
    std::string state{"initialized"};
    std::unique_ptr<JointController> joint;           ///< or
    std::unique_ptr<JointStatesOutput> joint_states;  ///< one of the two

    bool runs() const { return state == "running"; }
  };

  using Names = std::vector<std::string>;
  void list(controller_manager_msgs::ListControllers::Response & response) const;
  void load(const std::string & name);
  void unload(const std::string & name);
  void switchOver(const controller_manager_msgs::SwitchController::Request & request);
  void reload(bool force);

  Controller make(const std::string & name);
  Controller makeJointController(const std::string & name, const JointControllerType & type);
  const JointDescription & joint(const std::string & controller) const;
  void useGains(const std::string & name, JointController & controller) const;
  std::vector<JointCommand> wanted(double dt);
  double speedOf(const JointDescription & joint) const;
  void checkSwitch(const Names & start, const Names & stop) const;
  void start(Controller & controller);

  CarHandle car_;
  CommandInput & commands_;
  const bool simulates_pid_;
  const double rate_hz_;
  Schedule schedule_;  // of what controllers publish
  SimTime last_{0};
  std::map<std::string, Controller> controllers_;
  std::vector<ros::ServiceServer> servers_;
};
}  // namespace f1tenth_sim2d
