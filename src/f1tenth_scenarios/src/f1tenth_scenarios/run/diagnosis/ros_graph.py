"""Who is connected how, by the master's word."""

import rosgraph

from f1tenth_scenarios.plan.participants import driver_nodes_among

_CALLER = "/scenario"


def driver_nodes(car: str) -> list[str]:
    """The nodes of a car's driver, those that send commands first; names without the leading slash."""
    try:
        publishers, subscribers, services = rosgraph.Master(_CALLER).getSystemState()
    except (rosgraph.MasterException, OSError):
        return []
    commanding = {f"/{car}/drive", f"/{car}/cmd_vel"}
    first = [node for topic, nodes in publishers if topic in commanding for node in nodes]
    known = {node for _, nodes in (*publishers, *subscribers, *services) for node in nodes}
    return driver_nodes_among(car, [node.lstrip("/") for node in dict.fromkeys([*first, *sorted(known)])])
