#pragma once

#include <string>

namespace f1tenth_sim2d
{
/// The whole life of the node after ros::init: reads its parameters, runs, writes the result file.
/// Whatever goes wrong is one line on stderr.
/// @return the exit code: 0 ended by request, 1 a mistake of our own, 2 bad input, 3 a participant fell silent
/// @param parameters  name of the parameter tree; empty: the node's private parameters
int runNode(const std::string & parameters);
}  // namespace f1tenth_sim2d
