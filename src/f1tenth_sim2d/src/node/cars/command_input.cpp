#include "node/cars/command_input.h"

#include <ros/console.h>

#include <optional>
#include <utility>

#include "f1tenth_sim2d/errors.h"
#include "node/messages/conversions.h"

namespace f1tenth_sim2d
{
namespace
{
// Commands are handled between steps; more than one between two steps is rare, and the last one counts.
constexpr std::uint32_t kCommandQueueSize = 100;
}  // namespace

CommandInput::CommandInput(Simulation & simulation, CarId car, ros::NodeHandle node, Answered on_command)
: simulation_(simulation), car_(car), on_command_(std::move(on_command))
{
  const std::optional<std::string> twist_topic = simulation.car(car).twistTopic();
  if (!twist_topic) {
    return;  // its controllers drive it
  }
  const auto hints = ros::TransportHints().tcpNoDelay();
  twist_subscriber_ = node.subscribe<geometry_msgs::Twist>(
    *twist_topic, kCommandQueueSize, [this](const geometry_msgs::Twist::ConstPtr & message) { onTwist(*message); },
    ros::VoidConstPtr(), hints);
  drive_subscriber_ = node.subscribe<ackermann_msgs::AckermannDriveStamped>(
    "drive", kCommandQueueSize,
    [this](const ackermann_msgs::AckermannDriveStamped::ConstPtr & message) { onDrive(*message); }, ros::VoidConstPtr(),
    hints);
}

void CommandInput::noteTold(const std::string & objection)
{
  if (!objection.empty()) {
    refuse(objection);
  } else if (accepted_at_ != simulation_.time()) {
    accepted_at_ = simulation_.time();
    ++accepted_;
  }
  on_command_({});
}

void CommandInput::onTwist(const geometry_msgs::Twist & message)
{
  const std::optional<DriveDescription> & drive = simulation_.car(car_).drive;
  take({}, [&] {
    if (drive && drive->kind == DriveDescription::Kind::kAckermann) {
      simulation_.command(car_, toDriveCommand(message, *drive));
    } else {
      simulation_.commandTwist(car_, message.linear.x, message.angular.z, message.linear.y);
    }
  });
}

void CommandInput::onDrive(const ackermann_msgs::AckermannDriveStamped & message)
{
  take(message.header.stamp, [&] { simulation_.command(car_, {message.drive.speed, message.drive.steering_angle}); });
}

void CommandInput::take(const ros::Time & stamp, const std::function<void()> & command)
{
  try {
    command();
    ++accepted_;
  } catch (const Error & error) {
    refuse(error.what());
  }
  on_command_(stamp);
}

void CommandInput::refuse(const std::string & why)
{
  ++refused_;
  last_refusal_ = why;
  ROS_WARN_ONCE("Refused a command: %s", why.c_str());
}
}  // namespace f1tenth_sim2d
