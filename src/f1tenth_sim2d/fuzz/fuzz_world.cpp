#include "f1tenth_sim2d/loaders.h"
#include "f1tenth_sim2d/simulation.h"
#include "fuzz_input.h"

/// An SDF world: what loads is also put into a simulation and stepped.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t * data, std::size_t size)
{
  using namespace f1tenth_sim2d;
  const std::string path = writeFuzzFile("fuzz.world", data, size);
  return refuseOrLoad([&path] {
    const WorldDescription world = loadWorld(path);
    Simulation simulation(world);
    simulation.step();
  });
}
