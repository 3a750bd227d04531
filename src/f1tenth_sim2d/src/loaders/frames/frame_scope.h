#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>

#include "f1tenth_sim2d/geometry.h"
#include "loaders/xml/element.h"

namespace f1tenth_sim2d
{
/// A pose as given in SDF.
struct GivenPose
{
  Pose3 pose;
  std::string frame;  ///< in which it is given; empty: that of the model or world around it
  Element place{};
};

/// Everything with a pose in one model, or in the world: links, joints, nested models and frames, all by their names.
class FrameScope
{
public:
  /// Whether the name was free.
  bool add(const std::string & name, const GivenPose & pose);
  /// Frames of a nested model that has been added: "name::inner".
  void addNested(const std::string & name, std::shared_ptr<const FrameScope> frames);

  /// In the frame of this model or world.
  /// @param asked_by  the element that names it
  /// @throws LoadError for an unknown name, and for frames that are given in each other
  Pose3 poseOf(const std::string & name, const Element & asked_by) const;

  /// A given pose in the frame of this model or world.
  Pose3 resolved(const GivenPose & given) const { return poseOf(given.frame, given.place) * given.pose; }

private:
  struct Frame
  {
    GivenPose given;
    mutable bool is_being_resolved{false};
    mutable std::optional<Pose3> resolved{};
  };

  std::map<std::string, Frame> frames_;
  std::map<std::string, std::shared_ptr<const FrameScope>> nested_;
};
}  // namespace f1tenth_sim2d
