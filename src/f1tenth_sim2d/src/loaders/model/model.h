#pragma once

#include <limits>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "f1tenth_sim2d/world_model.h"
#include "loaders/frames/frame_scope.h"
#include "loaders/model/inertia.h"
#include "loaders/xml/element.h"
#include "loaders/xml/warning_collector.h"

/// What the description of a model contains, whether SDF or URDF: its parts, with all poses in the frame of the model.
namespace f1tenth_sim2d
{
struct SensorPart
{
  Element element;
  Pose3 pose;
};

struct LinkPart
{
  Element element;
  std::string name;
  Pose3 pose{};
  Inertia inertia{};
  std::vector<Solid> solids{};  ///< their names are those of the <collision> alone
  std::vector<Visual> visuals{};
  std::vector<SensorPart> sensors{};
};

struct JointPart
{
  Element element;
  std::string name;
  std::string type{};    ///< as SDF calls it
  std::string parent{};  ///< link; "world" is not in the model
  std::string child{};
  Pose3 pose{};
  Eigen::Vector3d axis{Eigen::Vector3d::Zero()};  ///< zero: none
  double lower{-std::numeric_limits<double>::infinity()};
  double upper{std::numeric_limits<double>::infinity()};
  double effort{std::numeric_limits<double>::infinity()};
  double velocity{std::numeric_limits<double>::infinity()};
};

struct Model
{
  Element element;
  std::string name;
  bool is_static{false};
  Pose3 pose;  ///< in the model or world around it
  std::vector<LinkPart> links;
  std::vector<JointPart> joints;
  std::vector<Model> models;  ///< nested in it
  std::vector<Element> plugins;
  std::vector<Element> transmissions;
  std::string root_link;
  std::map<std::string, Pose3> link_poses;  ///< of the links, and of those that fixed joints have joined with them

  Element include;  ///< that brought it, or none
  GivenPose given_pose;
  std::string placement_frame;  ///< of this model, whose pose is given; empty: the model's own
  std::shared_ptr<FrameScope> frames{std::make_shared<FrameScope>()};
};

/// Adds a nested model, and what is in it, to the frames of the model or world around it. One whose name is taken gets
/// a number behind it, with a warning.
/// @throws LoadError for a placement frame that is not there
void nestFrames(Model & nested, FrameScope & frames, WarningCollector & warnings);

/// The pose of a model that is the only one in its document, in the frame that it is put into.
/// @throws LoadError as nestFrames()
Pose3 ownPose(const Model & model);

/// Inertia of all links of a model, without those of nested ones, in the frame of the model.
Inertia inertiaOf(const Model & model);

/// The model without nested ones: their parts are its own, called "inner::name".
Model flattened(Model model);
}  // namespace f1tenth_sim2d
