#pragma once

#include <istream>
#include <string>
#include <vector>

#include "f1tenth_navigation_mgr/goals_file.h"

namespace f1tenth_navigation_mgr
{
/// The goals in the text of a goals file.
/// @param name          what errors call the file
/// @param known_frames  what `frame_id:` may name
/// @throws GoalsFileError
Goals readGoals(std::istream & text, const std::string & name, const std::vector<std::string> & known_frames);
}  // namespace f1tenth_navigation_mgr
