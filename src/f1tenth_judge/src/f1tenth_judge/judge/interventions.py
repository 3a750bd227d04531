"""Which interventions a scenario does not allow."""

import collections
from collections.abc import Iterable, Iterator
from typing import Optional

from f1tenth_judge.record.interventions import Intervention
from f1tenth_judge.scenario.interventions import DIRECTOR, PUSH
from f1tenth_judge.scenario.scenario import Scenario


def forbidden(scenario: Scenario, interventions: Iterable[Intervention]) -> Iterator[Intervention]:
    """Those that neither a permission nor a push of a box accounts for, in their order."""
    pushes = collections.Counter(box.name for box in scenario.boxes for _push in box.pushes)
    for each in interventions:
        if any(permission.allows(each.caller, each.kind) for permission in scenario.interventions):
            continue
        is_push = each.kind == PUSH.value and each.caller.strip("/") == DIRECTOR
        if is_push and pushes[each.model] > 0:
            pushes[each.model] -= 1
            continue
        yield each


def driver_behind(scenario: Scenario, intervention: Intervention) -> Optional[str]:
    """The car whose driver intervened: by the caller's namespace, or because there is only one.

    A jump, which nobody called, is the car's own.
    """
    if not intervention.caller:
        return intervention.model
    cars = [car.name for car in scenario.cars]
    by_name = next((car for car in cars if intervention.caller.startswith(f"/{car}/")), None)
    return by_name or (cars[0] if len(cars) == 1 else None)
