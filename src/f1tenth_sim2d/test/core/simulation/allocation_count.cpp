#include "allocation_count.h"

#include <cstdlib>
#include <new>

namespace
{
std::size_t count = 0;
std::size_t bytes = 0;
std::size_t failing = 0;
}  // namespace

void * operator new(std::size_t size)
{
  bytes += size;
  void * const memory = ++count == failing ? nullptr : std::malloc(size);
  if (memory != nullptr) {
    return memory;
  }
  throw std::bad_alloc();
}

void operator delete(void * memory) noexcept
{
  std::free(memory);
}
void operator delete(void * memory, std::size_t) noexcept
{
  std::free(memory);
}

namespace f1tenth_sim2d::test
{
std::size_t allocationCount()
{
  return count;
}

std::size_t allocatedBytes()
{
  return bytes;
}

void failAllocation(std::size_t number)
{
  failing = number == 0 ? 0 : count + number;
}
}  // namespace f1tenth_sim2d::test
