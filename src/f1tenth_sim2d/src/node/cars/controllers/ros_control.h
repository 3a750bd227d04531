#pragma once

#include <controller_manager_msgs/ListControllerTypes.h>
#include <controller_manager_msgs/ListControllers.h>
#include <controller_manager_msgs/SwitchController.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "node/cars/command_input.h"
#include "node/cars/controllers/controller.h"
#include "node/cars/sensor_output.h"

namespace f1tenth_sim2d
{
/// What libgazebo_ros_control.so is in Gazebo: a controller manager with its services, and controllers for the wheels
/// and steering joints of a car. While a controller of joints runs, the car does what it says.
class RosControl : public Component
{
public:
  /// @param car       its node in the namespace of the controller manager
  /// @param commands  of the car; is told of the commands to the controllers
  RosControl(CarHandle car, CommandInput & commands);

  bool acts() const override { return true; }
  /// Commands what the controllers want, at each control period.
  void beforeStep(Simulation & simulation, CarId car) override;

  double rate() const { return 1.0 / toSeconds(period_); }  ///< Hz, of the control periods
  /// Publishes what the controllers publish.
  void publish(SimTime now);

private:
  struct Loaded
  {
    std::string type;
    std::unique_ptr<Controller> controller;
    std::string state{"initialized"};

    bool runs() const { return state == "running"; }
  };

  using Names = std::vector<std::string>;
  void list(controller_manager_msgs::ListControllers::Response & response) const;
  void load(const std::string & name);
  void unload(const std::string & name);
  void switchOver(const controller_manager_msgs::SwitchController::Request & request);
  void reload(bool force);

  void start(Loaded & loaded);
  /// Checks that all are loaded, and running or stopped as they should be.
  void checkSwitch(const Names & start, const Names & stop) const;
  /// Checks that no joint would have two controllers.
  void checkJoints(const Names & start, const Names & stop) const;
  void startAnew(SimTime now);
  std::vector<JointCommand> wanted() const;

  CarHandle car_;
  CommandInput & commands_;
  const SimTime period_;
  SimTime last_{0};
  std::map<std::string, Loaded> controllers_;
  std::vector<ros::ServiceServer> servers_;
};
}  // namespace f1tenth_sim2d
