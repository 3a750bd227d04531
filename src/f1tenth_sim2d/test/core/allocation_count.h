#pragma once

#include <cstddef>

namespace f1tenth_sim2d::test
{
/// How often this program has called operator new.
std::size_t allocationCount();

/// Lets the call number `number` from now on fail as if memory were short; 0: none.
void failAllocation(std::size_t number);
}  // namespace f1tenth_sim2d::test
