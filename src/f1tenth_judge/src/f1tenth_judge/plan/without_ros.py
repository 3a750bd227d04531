"""What a run whose planners need no ROS 1 can do, and what it cannot."""

from collections.abc import Iterator

from f1tenth_judge.errors import NotApplicableError
from f1tenth_judge.plan.plan import Plan
from f1tenth_judge.scenario.scenario import Localization, Scenario


def check_without_ros(plan: Plan) -> None:
    """Refuse what needs nodes of ROS 1 beside planners of another kind.

    Raises:
        NotApplicableError: with the key.
    """
    others = [car for car in plan.scenario.cars if not car.driver.launch]
    if not others:
        return
    for car in plan.scenario.cars:
        if car.driver.launch:
            why = f"{car.name} is driven by a launch file of ROS 1 ({car.driver.name})"
            raise NotApplicableError(f"{why}, and {others[0].name} is not; one run has one kind")
    for found in _of_ros(plan.scenario):
        raise NotApplicableError(f"{found} is for planners that are launch files of ROS 1")


def _of_ros(scenario: Scenario) -> Iterator[str]:
    if scenario.localization is not Localization.STATIC:
        yield f"'localization: {scenario.localization.value}'"
    if scenario.has_events:
        yield "'faults' or 'pushes'"
    for car in scenario.cars:
        if car.dropped_beams:
            yield f"{car.name}: 'dropped_beams'"
        if car.input_faults:
            yield f"{car.name}: 'input_faults'"
