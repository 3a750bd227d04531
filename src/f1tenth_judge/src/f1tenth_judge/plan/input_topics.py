"""Under which names the inputs of a car pass from the simulator to its driver.

The simulator publishes them (`published_topics`), filters that fail at times may pass them on
(`filtered_topics`), a proxy driver may hold the scans back (`driver_topics`). Names without a slash in front
are in the namespace of the car.
"""

from f1tenth_judge.plan.participants import PROXY_DRIVER, has_proxy_driver
from f1tenth_judge.plan.plan import Plan
from f1tenth_judge.scenario.car import Car, Input
from f1tenth_judge.scenario.scenario import Localization

Topics = dict[Input, str]


def odometry(plan: Plan) -> str:
    """Which odometry the cars have: `perfect` or `wheel`."""
    return "wheel" if plan.scenario.localization is Localization.AMCL else "perfect"


def usual_topics(plan: Plan) -> Topics:
    """What the simulator publishes for an F1/10 car."""
    odometry_topic = "odom" if odometry(plan) == "wheel" else "perfect_odom"
    return {Input.SCAN: "scan", Input.ODOM: odometry_topic, Input.TF: "/tf"}


def published_topics(plan: Plan, car: Car) -> Topics:
    """What the simulator publishes for a car, which may have a description of its own."""
    description = plan.cars[car.name].description
    if description is None:
        return usual_topics(plan)
    odometry_topic = description.odometry_topic(plan.scenario.localization)
    own = {Input.SCAN: description.scan, Input.ODOM: odometry_topic}
    return usual_topics(plan) | {each: topic for each, topic in own.items() if topic}


def filtered_topics(plan: Plan, car: Car) -> Topics:
    """What is left of it where beams are dropped or inputs fail."""
    topics = published_topics(plan, car) | ({Input.SCAN: "scan_dropped"} if car.dropped_beams else {})
    return {each: f"{each.value}_faulty" if car.faults_of(each) else topic for each, topic in topics.items()}


def driver_topics(plan: Plan, car: Car) -> Topics:
    """What the driver of a car hears."""
    scan = {Input.SCAN: f"{PROXY_DRIVER}/scan"} if has_proxy_driver(plan, car.name) else {}
    return filtered_topics(plan, car) | scan


def absolute(namespace: str, topic: str) -> str:
    """The full name of a topic that may be in a namespace."""
    return topic if topic.startswith("/") else f"{namespace}/{topic}"
