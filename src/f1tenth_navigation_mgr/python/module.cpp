// The Python module f1tenth_navigation_mgr: the C++ classes in snake_case.
#include <pybind11/functional.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <memory>

#include "f1tenth_navigation_mgr/navigation_mgr.h"
#include "f1tenth_navigation_mgr/start_signal.h"
#include "ros_session.h"
#include "time_caster.h"

namespace py = pybind11;
using namespace f1tenth_navigation_mgr;

namespace
{
using ReleaseGil = py::call_guard<py::gil_scoped_release>;

void bindGoals(py::module_ & module)
{
  py::class_<Goal>(module, "Goal", "One pose for the car to reach: metres, a unit quaternion, and their frame.")
    .def(py::init(&PlanarGoal), py::arg("x"), py::arg("y"), py::arg("yaw"), py::arg("frame_id") = "map")
    .def_readwrite("frame_id", &Goal::frame_id)
    .def_readwrite("x", &Goal::x)
    .def_readwrite("y", &Goal::y)
    .def_readwrite("z", &Goal::z)
    .def_readwrite("qx", &Goal::qx)
    .def_readwrite("qy", &Goal::qy)
    .def_readwrite("qz", &Goal::qz)
    .def_readwrite("qw", &Goal::qw)
    .def_property_readonly("yaw", &Goal::Yaw, "rad, in (-pi, pi]")
    .def(
      "__eq__", [](const Goal & a, const Goal & b) { return a == b; }, py::is_operator())
    .def("__repr__", [](const Goal & goal) {
      return py::str("Goal(x={}, y={}, yaw={}, frame_id={!r})").format(goal.x, goal.y, goal.Yaw(), goal.frame_id);
    });

  module.def(
    "load_goals_file", &LoadGoalsFile, py::arg("path"), py::arg("known_frames") = std::vector<std::string>{"map"},
    "The goals of a goals file. Raises GoalsFileError, 'FILE:LINE: what is wrong'.");
}

void bindResults(py::module_ & module)
{
  py::enum_<GoalOutcome>(module, "GoalOutcome", "How a goal ended.")
    .value("SUCCEEDED", GoalOutcome::kSucceeded, "reached")
    .value("ABORTED", GoalOutcome::kAborted, "the planner gave up")
    .value("REJECTED", GoalOutcome::kRejected, "the planner did not take the goal")
    .value("PREEMPTED", GoalOutcome::kPreempted, "cancelled, by us or by another client's goal")
    .value("LOST", GoalOutcome::kLost, "the planner died, forgot the goal, fell silent or never took notice of it");

  py::class_<GoalResult>(module, "GoalResult", "A goal that is over.")
    .def_readonly("goal", &GoalResult::goal)
    .def_readonly("outcome", &GoalResult::outcome)
    .def_readonly("text", &GoalResult::text, "the planner's words; for LOST: what was missed")
    .def_readonly("sent", &GoalResult::sent, "ROS time")
    .def_readonly("ended", &GoalResult::ended, "ROS time at which this side learned of it");

  py::enum_<SpinResult>(module, "SpinResult", "What one spin() did.")
    .value("NOT_CONNECTED", SpinResult::kNotConnected, "nothing: no clock yet, or no action server")
    .value("DRIVING", SpinResult::kDriving, "checked the goal in flight: not over yet")
    .value("SENT", SpinResult::kSent, "sent the front of the queue")
    .value("REACHED", SpinResult::kReached, "the goal in flight was reached")
    .value("FAILED", SpinResult::kFailed, "the goal in flight ended otherwise")
    .value("QUEUE_EMPTY", SpinResult::kQueueEmpty, "found the queue empty, for the first time since it had goals")
    .value("IDLE", SpinResult::kIdle, "nothing: the queue is still empty");

  py::class_<Timeouts>(module, "Timeouts", "When to doubt the action server, in seconds; see timeouts.h.")
    .def(py::init<>())
    .def_readwrite("resend", &Timeouts::resend)
    .def_readwrite("acknowledge", &Timeouts::acknowledge)
    .def_readwrite("disconnect", &Timeouts::disconnect)
    .def_readwrite("silence", &Timeouts::silence)
    .def_readwrite("result", &Timeouts::result)
    .def_readwrite("reconnect", &Timeouts::reconnect);
}

void bindNavigationMgr(py::module_ & module)
{
  py::class_<NavigationMgr>(
    module, "NavigationMgr",
    "Sends a car's goals to its move_base, one after the other. robot: the car's namespace, '' for the node's own.")
    .def(
      py::init([](const std::string & robot, const Timeouts & timeouts) {
        ensureRos();
        return std::make_unique<NavigationMgr>(robot, timeouts);
      }),
      py::arg("robot"), py::arg("timeouts") = Timeouts{})
    .def(
      "load_goals", &NavigationMgr::LoadGoals, py::arg("path"),
      "Appends the goals of a file to the queue. Raises GoalsFileError, and the queue is then as it was.")
    .def("add_goal", &NavigationMgr::AddGoal, py::arg("goal"), "Appends one goal to the queue.")
    .def("clear_goals", &NavigationMgr::ClearGoals, "Drops the goals not yet sent; the goal in flight stays.")
    .def_property(
      "loop_mode", &NavigationMgr::LoopMode, &NavigationMgr::SetLoopMode,
      "In loop mode a reached goal goes to the back of the queue instead of leaving it.")
    .def(
      "spin", py::overload_cast<>(&NavigationMgr::Spin), ReleaseGil(),
      "Does at most one thing and says which; waits up to 10 ms of wall time for a message.")
    .def(
      "spin", py::overload_cast<const ros::Time &>(&NavigationMgr::Spin), py::arg("now"), ReleaseGil(),
      "The same without waiting, at the ROS time now (s): for lockstep.")
    .def("has_active_goal", &NavigationMgr::HasActiveGoal, "Whether a goal is in flight.")
    .def("size_goals_queue", &NavigationMgr::SizeGoalsQueue, "Goals not reached yet, with the one in flight.")
    .def("front_goals_queue", &NavigationMgr::FrontGoalsQueue, "The next Goal. Raises NavigationError without one.")
    .def(
      "check_goal_state", &NavigationMgr::CheckGoalState, ReleaseGil(),
      "Takes a goal that is over from the queue and says how it ended, as spin() does; IDLE without an active goal.")
    .def(
      "send_goal", &NavigationMgr::SendGoal, py::arg("goal"), ReleaseGil(),
      "Sends a goal, which becomes the front of the queue; SENT or NOT_CONNECTED. Raises NavigationError when another\n"
      "one is active.")
    .def(
      "wait_for_server",
      [](NavigationMgr & self, double timeout) { return self.WaitForServer(ros::WallDuration{timeout}); },
      py::arg("timeout"), ReleaseGil(),
      "Blocks until there is a clock and the action server is connected, at most timeout (wall s).")
    .def(
      "is_server_gone", &NavigationMgr::IsServerGone, ReleaseGil(),
      "Whether a goal is in flight whose server has been gone too long: the next spin() reports it as lost.")
    .def("cancel", &NavigationMgr::Cancel, ReleaseGil(), "Asks for the end of the goal in flight; spin() reports it.")
    .def_property_readonly("goal_in_flight", &NavigationMgr::GoalInFlight, "The Goal it drives to now, or None.")
    .def_property_readonly("goals_left", &NavigationMgr::GoalsLeft, "Goals not reached yet, with the one in flight.")
    .def_property_readonly(
      "queue", &NavigationMgr::Queue, "The Goals not reached yet, with the one in flight, in order.")
    .def_property_readonly("results", &NavigationMgr::Results, "A list of GoalResult, one per goal that is over.")
    .def_property_readonly("action_name", &NavigationMgr::ActionName, "'/robot1/move_base'")
    .def("on_goal_reached", &NavigationMgr::OnGoalReached, py::arg("callback"), "callback(GoalResult), inside spin().")
    .def("on_goal_failed", &NavigationMgr::OnGoalFailed, py::arg("callback"), "callback(GoalResult), inside spin().");
}

void bindStartSignal(py::module_ & module)
{
  py::class_<StartSignal>(module, "StartSignal", "Reads the countdown to the start of the race (std_msgs/Int32).")
    .def(
      py::init([](const std::string & topic, const std::string & starter) {
        ensureRos();
        return std::make_unique<StartSignal>(topic, starter);
      }),
      py::arg("topic") = "/time_to_start", py::arg("starter") = "",
      "starter: the only node whose announcements count, with the leading slash; empty: anybody's.")
    .def("seconds_left", &StartSignal::SecondsLeft, ReleaseGil(), "As last announced (s), or None. Does not block.")
    .def("has_started", &StartSignal::HasStarted, ReleaseGil(), "Whether the race is on; it stays on.");
}
}  // namespace

PYBIND11_MODULE(f1tenth_navigation_mgr, module)
{
  module.doc() = "Sends goals to move_base: the C++ library of this name.";
  const auto & error = py::register_exception<Error>(module, "NavigationError", PyExc_RuntimeError);
  py::register_exception<GoalsFileError>(module, "GoalsFileError", error);
  bindGoals(module);
  bindResults(module);
  bindNavigationMgr(module);
  bindStartSignal(module);
}
