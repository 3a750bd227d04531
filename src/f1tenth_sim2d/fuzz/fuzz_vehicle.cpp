#include "f1tenth_sim2d/vehicle_parameters.h"
#include "fuzz_input.h"

/// A car's YAML file.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t * data, std::size_t size)
{
  using namespace f1tenth_sim2d;
  const std::string path = writeFuzzFile("car.yaml", data, size);
  return refuseOrLoad([&path] { loadVehicleParameters(path); });
}
