#include "driver.h"

#include <move_base/control/navigator.h>
#include <workspace_support/errors.h>

#include <memory>
#include <utility>
#include <vector>

#include "arrays.h"
#include "control/racer.h"
#include "line/race_line_planner.h"

namespace py = pybind11;

namespace f1tenth_racer
{
namespace
{
// How an environment sees.
struct Senses
{
  double period;         // s, between observations
  double lidar_x;        // m, ahead of the rear axle
  double field_of_view;  // rad
  double range_max;      // m
};

class Driver
{
public:
  Driver(const Costmap & costmap, std::vector<Pose2> goals, const RacerOptions & options, const Senses & senses)
  : given_(costmap), costmap_(costmap), goals_(std::move(goals)), options_(options), senses_(senses)
  {
    if (goals_.empty()) {
      throw OptionError("goals: found 0, must be at least 1");
    }
    reset();
  }

  void reset()
  {
    costmap_ = given_;
    navigator_ = std::make_unique<Navigator>(
      NavigatorOptions{}, std::make_unique<RaceLinePlanner>(options_.planner), std::make_unique<Racer>(options_));
    time_ = 0.0;
    goal_.reset();
  }

  /// @return steering angle, rad, and speed, m/s
  std::pair<double, double> plan(const std::vector<float> & ranges, const CarState & car)
  {
    if (!navigator_->active()) {
      headForNext(car.pose);
    }
    navigator_->observe(scanOf(ranges, car.pose), costmap_);
    const CycleOutput output = navigator_->cycle({time_, car}, costmap_);
    time_ += senses_.period;
    const DriveCommand command = output.command.value_or(DriveCommand{});
    return {command.steeringAngle(options_.follower.limits.wheelbase), command.speed};
  }

private:
  // Goals repeat for ever; at first it is the nearest one that lies ahead.
  void headForNext(const Pose2 & car)
  {
    goal_ = goal_ ? (*goal_ + 1) % goals_.size() : firstAhead(car);
    std::vector<Pose2> next;
    for (std::size_t i = 1; i <= goals_.size(); ++i) {
      next.push_back(goals_[(*goal_ + i) % goals_.size()]);
    }
    navigator_->setGoal(goals_[*goal_], time_, std::move(next));
  }

  std::size_t firstAhead(const Pose2 & car) const
  {
    constexpr double kAhead = 1.0;  // m
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < goals_.size(); ++i) {
      nearest = distance(goals_[i], car) < distance(goals_[nearest], car) ? i : nearest;
    }
    return compose(inverse(car), goals_[nearest]).x > kAhead ? nearest : (nearest + 1) % goals_.size();
  }

  LaserScan scanOf(const std::vector<float> & ranges, const Pose2 & car) const
  {
    LaserScan scan;
    scan.angle_min = -0.5 * senses_.field_of_view;
    scan.angle_increment = senses_.field_of_view / static_cast<double>(ranges.size() - 1);
    scan.range_min = 0.06;
    scan.range_max = senses_.range_max;
    scan.ranges = ranges;
    scan.sensor = compose(car, {senses_.lidar_x, 0.0, 0.0});
    scan.time = time_ + senses_.period;  // the first one is later than 0
    return scan;
  }

  Costmap given_;
  Costmap costmap_;
  std::vector<Pose2> goals_;
  RacerOptions options_;
  Senses senses_;
  std::unique_ptr<Navigator> navigator_;
  double time_{0.0};
  std::optional<std::size_t> goal_;
};

std::pair<double, double> plan(Driver & driver, const py::dict & observation)
{
  for (const char * part : {"scan", "pose", "velocity"}) {
    if (!observation.contains(part)) {
      throw OptionError(std::string("observation: has no part '") + part + "'; needed: scan, pose, velocity");
    }
  }
  const auto ranges = observation["scan"].cast<std::vector<float>>();
  const auto velocity = observation["velocity"].cast<std::vector<double>>();
  if (ranges.size() < 2 || velocity.size() != 3) {
    throw OptionError(
      "observation: found " + std::to_string(ranges.size()) + " ranges and " + std::to_string(velocity.size()) +
      " velocities, must be at least 2 and 3");
  }
  return driver.plan(ranges, {toPose(observation["pose"].cast<Doubles>(), "pose"), velocity[0], velocity[2]});
}
}  // namespace

void bindDriver(py::module_ & module)
{
  py::class_<Driver>(module, "Racer", "Drives an environment of f1tenth_sim2d from goal to goal, round and round.")
    .def(
      py::init([](
                 const Costmap & costmap, const Doubles & goals, const RacerOptions & options, double period,
                 double lidar_x, double field_of_view, double range_max) {
        return Driver(costmap, toPoses(goals, "goals"), options, {period, lidar_x, field_of_view, range_max});
      }),
      py::arg("costmap"), py::arg("goals"), py::arg("options") = RacerOptions{}, py::arg("period") = 0.025,
      py::arg("lidar_x") = 0.0, py::arg("field_of_view") = 1.5 * M_PI, py::arg("range_max") = 10.0,
      "costmap: of the map. goals: (n, 3) poses of the base frame in driving order, m, rad. period: s between\n"
      "observations. lidar_x: m ahead of the base frame. field_of_view: rad. range_max: m. Raises OptionError.")
    .def("reset", &Driver::reset, "Forgets everything, before an episode.")
    .def(
      "plan", &plan, py::arg("observation"),
      "From the parts scan, pose and velocity of an observation to the steering angle, rad, and the speed, m/s: the\n"
      "action of an environment with normalized=False. To be called once per period. Raises OptionError.");
}
}  // namespace f1tenth_racer
