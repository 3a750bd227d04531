// What libFuzzer calls: the target that the build names.
#include "targets.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t * data, std::size_t size)
{
  f1tenth_sim2d::fuzz::F1TENTH_FUZZ_TARGET(data, size);
  return 0;
}
