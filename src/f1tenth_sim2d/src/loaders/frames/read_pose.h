#pragma once

#include <string>

#include "loaders/frames/frame_scope.h"
#include "loaders/xml/warning_collector.h"

namespace f1tenth_sim2d
{
constexpr int kNewestSdfVersion = 109;

/// "1.6" is 106; 0 for anything but a version.
int versionIn(const std::string & text);

/// Version of the SDF document that contains an element. That of SDF in a URDF is 1.7.
int sdfVersion(const Element & element);

/// @throws LoadError unless the root element has a version from 1.3 to 1.9
void requireSdfVersion(const Element & root, WarningCollector & warnings);

/// The <pose> of an element.
/// @param frame  in which it is given unless it names one
/// @throws LoadError
GivenPose readPose(const Element & owner, const std::string & frame);

/// The <origin> of an element of a URDF.
/// @throws LoadError
Pose3 readOrigin(const Element & owner);
}  // namespace f1tenth_sim2d
