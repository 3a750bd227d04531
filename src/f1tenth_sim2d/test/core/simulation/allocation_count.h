#pragma once

#include <cstddef>

namespace f1tenth_sim2d::test
{
/// How often this program has called operator new.
std::size_t allocationCount();

/// How many bytes it has asked for by that.
std::size_t allocatedBytes();

/// Lets the call number `number` from now on fail as if memory were short; 0: none.
void failAllocation(std::size_t number);
}  // namespace f1tenth_sim2d::test
