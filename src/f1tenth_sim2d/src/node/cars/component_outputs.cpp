#include "node/cars/component_outputs.h"

#include <std_msgs/Float64MultiArray.h>

#include "node/cars/components/camera_output.h"
#include "node/cars/components/imu_output.h"
#include "node/cars/components/scan_output.h"
#include "node/cars/components/sonar_output.h"

namespace f1tenth_sim2d
{
namespace
{
template <class Kind, class Message>
std::unique_ptr<Output> makeIfIs(const CarHandle & car, const Component & component)
{
  const auto * const own = dynamic_cast<const Kind *>(&component);
  return own ? std::make_unique<Message>(car, *own) : nullptr;
}

/// The message of each kind of component.
constexpr std::unique_ptr<Output> (*kMessages[])(const CarHandle &, const Component &) = {
  makeIfIs<Lidar, ScanOutput>,
  makeIfIs<Sonar, SonarOutput>,
  makeIfIs<Imu, ImuOutput>,
  makeIfIs<Camera, CameraOutput>,
};

/// The numbers of a component of any kind.
class NumbersOutput : public MessageOutput<std_msgs::Float64MultiArray>
{
public:
  NumbersOutput(const CarHandle & car, const Component & component)
  : MessageOutput(car.advertise<std_msgs::Float64MultiArray>(component.mount().topic), component.mount().rate_hz),
    car_(car),
    component_(component)
  {
    for (const Channel & channel : component.channels()) {
      std_msgs::MultiArrayDimension dimension;
      dimension.label = channel.name;
      dimension.size = dimension.stride = static_cast<std::uint32_t>(channel.size);
      message_.layout.dim.push_back(dimension);
    }
    message_.data.resize(sampleSize(component));
  }

private:
  void fill(std_msgs::Float64MultiArray & message, SimTime /*now*/) override
  {
    component_.sample(car_.simulation, car_.id, message.data.data());
  }

  const CarHandle car_;
  const Component & component_;
};
}  // namespace

std::unique_ptr<Output> makeOutput(const CarHandle & car, const Component & component)
{
  for (const auto make : kMessages) {
    if (auto output = make(car, component)) {
      return output;
    }
  }
  return sampleSize(component) > 0 ? std::make_unique<NumbersOutput>(car, component) : nullptr;
}
}  // namespace f1tenth_sim2d
