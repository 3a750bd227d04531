"""lockstep_rtf_cpp, lockstep_rtf_py: a gap follower that answers each scan."""

import time

from f1tenth_bench.benchmark import Measured, benchmark
from f1tenth_bench.places import circuit_file, executable
from f1tenth_bench.ros.ros_run import RosRun, end

SECONDS = 10.0  # wall


@benchmark("lockstep_rtf_cpp", "sim s / s", at_least=60, of_messages=True)
def lockstep_rtf_cpp():
    """The driver is examples/gap_follower_node.cpp; wall time on circuit1."""
    return _real_time_factor("gap_follower")


@benchmark("lockstep_rtf_py", "sim s / s", at_least=20, of_messages=True)
def lockstep_rtf_py():
    """The driver is examples/gap_follower.py; wall time on circuit1."""
    return _real_time_factor("gap_follower.py")


def _real_time_factor(driver):
    with RosRun() as run:
        run.start([executable(driver)], "/robot1")
        run.wait_for_node("/robot1/gap_follower")
        sim2d = run.start_sim2d(circuit_file("circuit1"), lockstep=True, participants=["robot1"])
        run.wait_for_service("/gazebo/unpause_physics")
        time.sleep(SECONDS)
        end(sim2d)
        result = run.result()
    problem = result["error"]
    return Measured(result["sim_time"] / result["wall_time"], {"periods": result["periods"]}, problem)
