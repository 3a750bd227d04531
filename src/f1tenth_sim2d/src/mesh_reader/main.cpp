// Reads a mesh file for the simulator: whatever breaks on it, a library that asserts or runs wild, breaks here.
//   f1tenth_sim2d_mesh_reader FILE
// Writes its parts to descriptor 3 and ends with 0; or writes there what is wrong with the file, and ends with 1.
#include <sys/resource.h>
#include <unistd.h>

#include <cstdio>
#include <exception>
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

bool isWritten(const std::string & bytes)
{
  std::FILE * const output = ::fdopen(f1tenth_sim2d::kOutputDescriptor, "wb");
  return output != nullptr && std::fwrite(bytes.data(), 1, bytes.size(), output) == bytes.size() &&
         std::fflush(output) == 0;
}
}  // namespace

int main(int, char ** arguments)
{
  using namespace f1tenth_sim2d;
  limit(RLIMIT_CORE, 0, 0);
  limit(RLIMIT_CPU, kCpuSecondsMax, kCpuSecondsMax + 1);
  ::alarm(kWallSecondsMax);
  try {
    return isWritten(packed(readParts(arguments[1]))) ? 0 : 1;
  } catch (const std::exception & error) {
    isWritten(error.what());
    return 1;
  }
}
