"""Whom the simulator waits for in lockstep."""

from collections.abc import Iterable

from f1tenth_judge.places.packages import is_original
from f1tenth_judge.plan.plan import Plan
from f1tenth_judge.scenario.interventions import DIRECTOR
from f1tenth_judge.scenario.scenario import Localization

PROXY_DRIVER = "proxy_driver"
STARTER = "race_starter"
_STANDINS = ("amcl", "move_base")  # of whose nodes the original may be installed, under the same name
_BESIDE_DRIVER = (
    "amcl",
    "beam_dropper",
    "collision_detection",
    PROXY_DRIVER,
    "faulty_inputs",
    "map_to_odom",
    "robot_state_publisher",
)
# A Python node's roscpp half, with which it takes part in lockstep.
_SECOND_HALF = "_roscpp"


def participants(plan: Plan) -> list[str]:
    """The participants of a run, named as in docs/lockstep.md; none without lockstep."""
    scenario = plan.scenario
    if not scenario.lockstep:
        return []
    names = [f"{car.name}/amcl" for car in scenario.cars if scenario.localization is Localization.AMCL]
    names += [name for car in scenario.cars for name in _of_car(plan, car)]
    if plan.has_countdown:
        names.append(STARTER)
    if scenario.has_events:
        names.append(DIRECTOR)
    return names


def originals_among(names: Iterable[str]) -> list[str]:
    """The packages of nodes that should take part, but are the originals of our stand-ins and cannot."""
    packages = sorted({name.rpartition("/")[2] for name in names} & {*_STANDINS})
    return [each for each in packages if is_original(each)]


def has_proxy_driver(plan: Plan, car: str) -> bool:
    """Whether a proxy driver takes part for the car's driver, which knows nothing of lockstep."""
    return plan.scenario.lockstep and plan.cars[car].driver.participants is None


def driver_participants(plan: Plan, car: str) -> list[str]:
    """The participants that answer for the car's driver."""
    return plan.cars[car].driver.participants_of(car) or [f"{car}/{PROXY_DRIVER}"]


def named_nodes(plan: Plan, car: str) -> set[str]:
    """The nodes that the car's driver names as participants: it is nothing without them."""
    return set(plan.cars[car].driver.participants_of(car) or ()) - {car}


def driver_nodes_among(car: str, nodes: Iterable[str]) -> list[str]:
    """Those of some nodes that are the driver's of a car: all others in its namespace are ours."""
    beside = {f"{car}/{name}" for name in _BESIDE_DRIVER}
    named = (node for node in nodes if not node.endswith(_SECOND_HALF))
    return [node for node in named if node.startswith(f"{car}/") and node not in beside]


def _of_car(plan, car):
    names = driver_participants(plan, car.name)
    names += [f"{car.name}/beam_dropper"] if car.dropped_beams else []
    names += [f"{car.name}/faulty_inputs"] if car.input_faults else []
    return names
