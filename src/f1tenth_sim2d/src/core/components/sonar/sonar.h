#pragma once

#include "f1tenth_sim2d/component.h"

namespace f1tenth_sim2d
{
/// A sonar, or an infrared ranger: the distance to the nearest thing that one of its rays hits, m; its greatest range if
/// there is nothing.
class Sonar : public CopiedComponent<Sonar>
{
public:
  struct Options
  {
    RayFan rays;                 ///< from the sonar's position; range_max is the sonar's
    double range_min{0.0};       ///< m
    double noise_stddev{0.0};    ///< m
    double field_of_view{0.05};  ///< rad, as published; what is seen depends on the rays alone
    bool is_infrared{false};
  };

  Sonar(Mount mount, Options options);

  const Options & options() const { return options_; }
  std::vector<Channel> channels() const override;
  void sample(const Simulation & simulation, CarId car, double * numbers) const override;

private:
  Options options_;
};
}  // namespace f1tenth_sim2d
