#pragma once

#include <string>
#include <vector>

#include "f1tenth_navigation_mgr/errors.h"
#include "f1tenth_navigation_mgr/goal.h"

/// The goals file: text; `#` starts a comment; an optional first line `frame_id: map`; then one goal per line, either
/// `x y yaw` or `x y z qx qy qz qw` (m, rad).
namespace f1tenth_navigation_mgr
{
/// @param known_frames  what `frame_id:` may name
/// @throws GoalsFileError `FILE:LINE: what is wrong` at the first wrong line, also for a file without goals
Goals LoadGoalsFile(const std::string & path, const std::vector<std::string> & known_frames = {"map"});
}  // namespace f1tenth_navigation_mgr
