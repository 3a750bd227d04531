#include "node/cars/sensor_outputs.h"

#include <map>
#include <typeindex>

#include "node/cars/sonar_output.h"

namespace f1tenth_sim2d
{
namespace
{
using MakeOutput = std::unique_ptr<Output> (*)(const CarHandle &, const SensorDescription &);

template <class Description, class SensorOutput>
std::pair<const std::type_index, MakeOutput> kind()
{
  return {typeid(Description), [](const CarHandle & car, const SensorDescription & sensor) -> std::unique_ptr<Output> {
            return std::make_unique<SensorOutput>(car, static_cast<const Description &>(sensor));
          }};
}

const std::map<std::type_index, MakeOutput> & kinds()
{
  static const std::map<std::type_index, MakeOutput> all{
    kind<SonarDescription, SonarOutput>(),
  };
  return all;
}
}  // namespace

OutputList sensorOutputs(const CarHandle & car)
{
  OutputList outputs;
  for (const auto & sensor : car.description().sensors) {
    const SensorDescription & description = *sensor;
    outputs.push_back(kinds().at(typeid(description))(car, description));
  }
  return outputs;
}
}  // namespace f1tenth_sim2d
