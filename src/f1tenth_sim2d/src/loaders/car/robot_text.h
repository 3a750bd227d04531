#pragma once

#include <map>
#include <sdf/Model.hh>
#include <string>
#include <vector>

#include "f1tenth_sim2d/car_model.h"
#include "loaders/files/warning_collector.h"
#include "loaders/sdf/sdf_messages.h"

namespace f1tenth_sim2d
{
/// What a robot's text says and libsdformat does not hand on: fixed joints of a URDF vanish, and with them their child
/// links; what plugins say of those is replaced; transmissions are not SDF.
struct RobotFacts
{
  struct LinkWithCollisions
  {
    std::string name;
    std::size_t collisions;
    bool can_vanish;  ///< no mass and not fixed to its parent: Gazebo and libsdformat leave such a link out
  };

  std::vector<std::string> links;
  std::vector<LinkWithCollisions> links_with_collisions;
  std::map<std::string, Pose3> link_poses;  ///< in the frame of the model, joints at zero
  std::string base_frame;                   ///< base_footprint, or else base_link, or else the root
  std::vector<TransmissionDescription> transmissions;
  std::map<std::string, std::map<std::string, std::string>> plugin_tags;  ///< by the plugin's name, as written
};

/// Name of the root element, "robot" or "sdf".
/// @throws LoadError with the line for text that is not XML
std::string rootElement(const std::string & xml, const std::string & source);

/// @throws LoadError for what urdfdom refuses
RobotFacts readUrdf(
  const std::string & xml, const std::string & source, const SdfMessages & messages, WarningCollector & warnings);

/// The same of an SDF model.
/// @throws LoadError for a pose that cannot be resolved
RobotFacts factsOfModel(const sdf::Model & model, const std::string & source);

/// @throws LoadError if the conversion to SDF has dropped a collision element
void requireAllCollisions(const RobotFacts & facts, const std::vector<Solid> & solids, const std::string & source);
}  // namespace f1tenth_sim2d
