#pragma once

#include <functional>
#include <string>

namespace f1tenth_sim2d
{
/// Calls work in a process of its own and returns its result. Whatever breaks, breaks there: a library
/// that asserts, runs wild or prints.
/// @throws Error with what work throws as an exception, or saying how its process ended
std::string resultOfChild(const std::function<std::string()> & work);
}  // namespace f1tenth_sim2d
