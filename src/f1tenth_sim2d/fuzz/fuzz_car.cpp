#include "f1tenth_sim2d/loaders.h"
#include "f1tenth_sim2d/simulation.h"
#include "fuzz_input.h"

/// A URDF or an SDF model: what loads is also put into an empty world and driven.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t * data, std::size_t size)
{
  using namespace f1tenth_sim2d;
  const std::string xml(reinterpret_cast<const char *>(data), size);
  return refuseOrLoad([&xml] {
    const CarDescription car = loadCar(xml, "robot1", "fuzz");
    Simulation simulation(emptyWorld());
    simulation.command(simulation.addCar(car, car.parameters, {}), {1.0, 0.1});
    simulation.step();
  });
}
