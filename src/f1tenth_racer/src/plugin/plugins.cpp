// What move_base loads: base_global_planner f1tenth_racer/RaceLineROS, base_local_planner f1tenth_racer/RacerROS.
#include <move_base/local_planner.h>
#include <move_base/planner_parameters.h>

#include <class_loader/class_loader.hpp>
#include <memory>

#include "control/racer.h"
#include "line/race_line_planner.h"
#include "racer_parameters.h"

namespace f1tenth_racer
{
class RaceLineROS : public GlobalPlannerPlugin
{
public:
  std::unique_ptr<GlobalPlanner> create(const PlannerSetup & setup) const override
  {
    const PlannerOptions options = readWayPlanner(setup);
    setup.parameters.check([&] { options.validate(); });
    return std::make_unique<RaceLinePlanner>(options);
  }
};

class RacerROS : public LocalPlannerPlugin
{
public:
  std::unique_ptr<LocalPlanner> create(const PlannerSetup & setup) const override
  {
    return std::make_unique<Racer>(readRacer(setup));
  }
};
}  // namespace f1tenth_racer

CLASS_LOADER_REGISTER_CLASS(f1tenth_racer::RaceLineROS, move_base::GlobalPlannerPlugin)
CLASS_LOADER_REGISTER_CLASS(f1tenth_racer::RacerROS, move_base::LocalPlannerPlugin)
