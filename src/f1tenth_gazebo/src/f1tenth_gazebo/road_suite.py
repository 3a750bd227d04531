"""Laps of random roads, as a suite of f1tenth_judge."""

from pathlib import Path

from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.suites.suite import Suite, seeds, with_models


def _world(seed: int, folder: Path) -> Path:
    # Imported late: shapely takes longer than all else that listing the suites does.
    from f1tenth_gazebo.roads import RoadError, make_road, write_road

    try:
        *_, world = write_road(make_road(seed), folder / f"seed_{seed}")
    except (OSError, RoadError) as error:
        raise ScenarioError(f"road {seed}: {error}") from error
    return world


SUITE = Suite(
    text="a lap of a random road of `make_road --seed N`; both vehicle models; --cases are seeds",
    scenario="unseen_road",
    cases=lambda chosen, folder: with_models({f"{each:03}": _world(each, folder) for each in seeds(chosen)}),
    chosen="0:199",
)
