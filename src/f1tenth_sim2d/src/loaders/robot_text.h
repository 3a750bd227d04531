#pragma once

#include <ignition/math/Pose3.hh>
#include <sdf/Model.hh>
#include <string>
#include <vector>

#include "f1tenth_sim2d/world_model.h"
#include "sdf_messages.h"

namespace f1tenth_sim2d
{
/// What a URDF says and its conversion to SDF forgets: fixed joints vanish there, and with them their child links.
struct UrdfFacts
{
  struct LinkWithCollisions
  {
    std::string name;
    std::size_t collisions;
    bool can_vanish;  ///< no mass and not fixed to its parent: Gazebo and libsdformat leave such a link out
  };

  std::vector<std::string> links;
  std::vector<LinkWithCollisions> links_with_collisions;
  ignition::math::Pose3d base_footprint;  ///< in the frame of the root link
};

/// Name of the root element, "robot" or "sdf".
/// @throws LoadError with the line for text that is not XML
std::string rootElement(const std::string & xml, const std::string & source);

/// @throws LoadError for what urdfdom refuses, and for a robot without base_footprint
UrdfFacts readUrdf(const std::string & xml, const std::string & source, const SdfMessages & messages);

/// @throws LoadError if the conversion to SDF has dropped a collision element
void requireAllCollisions(const UrdfFacts & facts, const std::vector<Solid> & solids, const std::string & source);
}  // namespace f1tenth_sim2d
