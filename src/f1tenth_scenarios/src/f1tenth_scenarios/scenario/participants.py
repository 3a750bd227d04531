"""Whom the simulator waits for in lockstep."""

from f1tenth_scenarios.scenario.scenario import Driver, Localization, Scenario

DIRECTOR = "scenario"
STARTER = "race_starter"
# Nodes that answer scans.
DRIVER_NODES = {Driver.COMMANDS: "command_driver", Driver.PURSUIT: "pure_pursuit"}


def participants(scenario: Scenario) -> list[str]:
    """The names of docs/lockstep.md that take part in a scenario; none without lockstep."""
    if not scenario.lockstep:
        return []
    names = [f"{car.name}/amcl" for car in scenario.cars if scenario.localization is Localization.AMCL]
    names += [name for car in scenario.cars for name in _of_car(car)]
    if any(car.driver is Driver.RACE for car in scenario.cars):
        names.append(STARTER)
    if scenario.has_events:
        names.append(DIRECTOR)
    return names


def _of_car(car):
    if car.driver is not Driver.RACE:
        return [car.name]
    nodes = ["move_base", "race_mgr"]
    nodes += ["beam_dropper"] if car.dropped_beams else []
    nodes += ["faulty_inputs"] if car.input_faults else []
    return [f"{car.name}/{node}" for node in nodes]
