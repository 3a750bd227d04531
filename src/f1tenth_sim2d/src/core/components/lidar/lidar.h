#pragma once

#include "f1tenth_sim2d/car_model.h"
#include "f1tenth_sim2d/component.h"

namespace f1tenth_sim2d
{
/// A lidar of a car as a component: its ranges as Simulation::scan() gives them.
class Lidar : public CopiedComponent<Lidar>
{
public:
  /// @param index  among the lidars of the car
  Lidar(const LidarDescription & lidar, std::size_t index);

  const LidarDescription & description() const { return description_; }
  std::size_t index() const { return index_; }
  std::vector<Channel> channels() const override;
  void sample(const Simulation & simulation, CarId car, double * numbers) const override;

private:
  LidarDescription description_;
  std::size_t index_;
};
}  // namespace f1tenth_sim2d
