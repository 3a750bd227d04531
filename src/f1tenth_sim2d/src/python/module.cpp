#include "python/bindings.h"

PYBIND11_MODULE(_f1tenth_sim2d, module)
{
  module.doc() = "A fast and deterministic 2.5-D simulator of F1/10 cars. SI units; x forward, y left, yaw in rad.";
  f1tenth_sim2d::bindErrors(module);
  f1tenth_sim2d::bindVehicleParameters(module);
  f1tenth_sim2d::bindWorld(module);
  f1tenth_sim2d::bindCar(module);
  f1tenth_sim2d::bindSamples(module);
  f1tenth_sim2d::bindSimulation(module);
  f1tenth_sim2d::bindEnvironments(module);
}
