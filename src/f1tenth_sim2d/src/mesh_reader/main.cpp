// Reads a mesh file for the simulator: whatever breaks on it, a library that asserts or runs wild, breaks here.
//   f1tenth_sim2d_mesh_reader FILE
// Writes its parts to descriptor 3 and ends with 0; or writes there what is wrong with the file, and ends with 1.
#include <sys/resource.h>
#include <unistd.h>

#include <exception>
#include <fstream>
#include <string>

#include "loaders/shapes/child_process.h"
#include "mesh_reader/scene_parts.h"

namespace
{
/// @param hard  what the kernel enforces with SIGKILL, where `soft` is a signal that tells its cause
void limit(decltype(RLIMIT_CORE) what, rlim_t soft, rlim_t hard)
{
  const rlimit limits{soft, hard};
  ::setrlimit(what, &limits);
}
}  // namespace

int main(int, char ** arguments)
{
  using namespace f1tenth_sim2d;
  limit(RLIMIT_CORE, 0, 0);
  limit(RLIMIT_CPU, kCpuSecondsMax, kCpuSecondsMax + 1);
  ::alarm(kWallSecondsMax);
  std::ofstream output("/dev/fd/" + std::to_string(kOutputDescriptor), std::ios::binary);
  try {
    output << packed(readParts(arguments[1]));
    return 0;
  } catch (const std::exception & error) {
    output << error.what();
    return 1;
  }
}
