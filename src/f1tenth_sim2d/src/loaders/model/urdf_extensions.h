#pragma once

#include <map>
#include <string>
#include <vector>

#include "f1tenth_sim2d/world_model.h"
#include "loaders/model/urdf_tree.h"
#include "loaders/xml/warning_collector.h"

namespace f1tenth_sim2d
{
/// The <gazebo> tags of a URDF, each where Gazebo puts it: those of links that are joined with others go to the link
/// that they become part of, after its own.
class UrdfExtensions
{
public:
  UrdfExtensions(const Element & robot, const UrdfTree & tree, WarningCollector & warnings);

  /// Extensions without reference: of the model.
  const std::vector<Element> & ofModel() const { return of_model_; }

  /// Extensions of a link that stays, and of those that become part of it.
  std::vector<Element> ofLink(const UrdfLink & link) const;

  /// Name of the material that they give all that is seen of a link itself; empty: none.
  std::string materialOf(const UrdfLink & link) const;

  /// Friction and bounce that the extensions of a link give one of its collision elements.
  /// @param solid  whose name is complete
  void apply(const UrdfLink & link, Solid & solid, WarningCollector & warnings) const;

private:
  void append(const UrdfLink & link, std::vector<Element> & extensions) const;

  std::vector<Element> of_model_;
  std::map<std::string, std::vector<Element>> by_reference_;
};
}  // namespace f1tenth_sim2d
