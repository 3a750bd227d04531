#pragma once

#include <cstddef>

namespace f1tenth_sim2d::test
{
/// How often this program has called operator new.
std::size_t allocationCount();
}  // namespace f1tenth_sim2d::test
