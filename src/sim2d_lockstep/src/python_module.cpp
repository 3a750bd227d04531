#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <ros/init.h>

#include "sim2d_lockstep/done_ledger.h"
#include "sim2d_lockstep/participant.h"

namespace py = pybind11;
using sim2d_lockstep::Participant;

namespace
{
// A rospy process has no roscpp node yet. rospy keeps its signal handlers.
void startRoscpp(const std::string & participant)
{
  if (!ros::isInitialized()) {
    const auto slash = participant.rfind('/');
    const std::string name = slash == std::string::npos ? participant : participant.substr(slash + 1);
    const std::string space = slash == std::string::npos ? "/" : participant.substr(0, slash);
    const ros::M_string remappings{{"__ns", space}};
    ros::init(remappings, name + sim2d_lockstep::kSecondHalf, ros::init_options::NoSigintHandler);
  }
}

std::unique_ptr<Participant> makeParticipant(const std::string & name, const std::vector<std::string> & after)
{
  const py::gil_scoped_release release;
  startRoscpp(name);
  return std::make_unique<Participant>(name, after);
}

py::object waitForPeriod(Participant & participant, double timeout)
{
  std::optional<ros::Time> stamp;
  {
    const py::gil_scoped_release release;
    stamp = participant.waitForPeriod(ros::WallDuration(timeout));
  }
  return stamp ? py::module_::import("genpy").attr("Time")(stamp->sec, stamp->nsec) : py::none();
}

ros::Time toTime(const py::handle & stamp)
{
  return {stamp.attr("secs").cast<std::uint32_t>(), stamp.attr("nsecs").cast<std::uint32_t>()};
}

void done(Participant & participant, const py::handle & stamp, const py::handle & until)
{
  const ros::Time time = toTime(stamp);
  const ros::Time next = until.is_none() ? ros::Time() : toTime(until);
  const py::gil_scoped_release release;
  participant.done(time, next);
}
}  // namespace

PYBIND11_MODULE(sim2d_lockstep, module)
{
  module.doc() = "The node's side of lockstep for Python nodes: wraps the C++ class Participant.";
  py::class_<Participant>(
    module, "Participant",
    "A node that is named in the simulator's `participants`. Works beside rospy in the same process.\n\n"
    "rospy sends messages on threads of its own and cannot be told to finish, unless the publisher is made with "
    "queue_size=None: only then is a message on its way before a `done` that follows it.")
    .def(
      py::init(&makeParticipant), py::arg("name"), py::arg("after") = std::vector<std::string>{},
      "name: the node's name without the leading slash. after: participants that act before this one in every "
      "period.\nRaises ValueError for a name that cannot be one.")
    .def(
      "wait_for_period", &waitForPeriod, py::arg("timeout"),
      "Block until the next period that has not been answered; other Python threads run meanwhile.\n\n"
      "timeout: wall seconds. Returns the period's stamp (genpy.Time), or None when the timeout has passed or roscpp "
      "shuts down. rospy's clock may still lag: use the stamp.")
    .def(
      "done", &done, py::arg("stamp"), py::arg("until") = py::none(),
      "Tell the simulator that this node has acted up to stamp.\n\n"
      "until: a node that acts more seldom than every period is not waited for, and wait_for_period() returns None, "
      "before the first period that ends then or later.")
    .def(
      "leave", &Participant::leave, py::call_guard<py::gil_scoped_release>(),
      "Leave for good: nobody waits for this participant again.");
}
