#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "f1tenth_sim2d/geometry.h"
#include "loaders/model/inertia.h"
#include "loaders/xml/element.h"

/// The links of a URDF as a tree of joints, as Gazebo sees it.
namespace f1tenth_sim2d
{
struct UrdfJoint
{
  Element element;
  std::string name;
  std::string type;
  std::string parent;
  std::string child;
  Pose3 origin;           ///< of the child, in the parent
  bool is_joined{false};  ///< fixed, and not to be preserved: parent and child become one link
};

struct UrdfLink
{
  Element element;
  std::string name;
  const UrdfJoint * joint{nullptr};  ///< to the parent; null: the root
  UrdfLink * parent{nullptr};
  std::vector<UrdfLink *> children{};  ///< in the order of the names of their joints
  Pose3 pose{};                        ///< in the root, joints at zero
  std::optional<Inertia> inertia{};    ///< in the root

  /// Whether it becomes part of its parent. Nothing becomes part of the world.
  bool isJoined() const { return joint && joint->is_joined && parent->name != "world"; }
  /// The link that it becomes part of; itself if it does not.
  const UrdfLink & whole() const { return isJoined() ? parent->whole() : *this; }
  /// Of this link and of those below that are joined with it; none if none of them has an inertia.
  std::optional<Inertia> joinedInertia() const;
};

class UrdfTree
{
public:
  /// @throws LoadError for a description that is no tree of links, and for what cannot be read
  explicit UrdfTree(const Element & robot);

  const std::map<std::string, UrdfLink> & links() const { return links_; }
  const UrdfLink & root() const { return *root_; }
  bool hasJoint(const std::string & name) const { return joints_.count(name) > 0; }

private:
  void connect(UrdfJoint & joint);
  void place(UrdfLink & link, const Pose3 & pose, std::size_t & count);

  std::map<std::string, UrdfLink> links_;
  std::map<std::string, UrdfJoint> joints_;
  UrdfLink * root_{nullptr};
};
}  // namespace f1tenth_sim2d
