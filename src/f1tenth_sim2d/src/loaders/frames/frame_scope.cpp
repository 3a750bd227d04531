#include "loaders/frames/frame_scope.h"

namespace f1tenth_sim2d
{
namespace
{
const std::string kSeparator = "::";

bool isTheScopeItself(const std::string & name)
{
  return name.empty() || name == "__model__" || name == "world" || name == "__root__";
}
}  // namespace

bool FrameScope::add(const std::string & name, const GivenPose & pose)
{
  return frames_.try_emplace(name, Frame{pose}).second;
}

void FrameScope::addNested(const std::string & name, std::shared_ptr<const FrameScope> frames)
{
  nested_.emplace(name, std::move(frames));
}

Pose3 FrameScope::poseOf(const std::string & name, const Element & asked_by) const
{
  const auto found = frames_.find(name);
  if (found == frames_.end()) {
    if (isTheScopeItself(name)) {
      return {};
    }
    const std::size_t separator = name.find(kSeparator);
    const std::string outer = name.substr(0, separator);
    const auto nested = nested_.find(outer);
    if (separator == std::string::npos || nested == nested_.end()) {
      asked_by.fail("names the frame '" + name + "', which is no link, joint, frame or model here");
    }
    return poseOf(outer, asked_by) * nested->second->poseOf(name.substr(separator + kSeparator.size()), asked_by);
  }
  const Frame & frame = found->second;
  if (!frame.resolved) {
    if (frame.is_being_resolved) {
      asked_by.fail("is given relative to '" + name + "', which is given relative to it");
    }
    frame.is_being_resolved = true;
    frame.resolved = resolved(frame.given);
  }
  return *frame.resolved;
}
}  // namespace f1tenth_sim2d
