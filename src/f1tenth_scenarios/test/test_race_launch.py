"""race.launch waits for those who drive and, with amcl, for those who localize."""

import pytest
import roslaunch.config
import roslaunch.xmlloader

from f1tenth_scenarios import places

LAUNCH = places.package_path(places.PACKAGE) / "launch"
PLANNER = LAUNCH / "drivers" / "gap_follower.launch"


@pytest.mark.parametrize(
    ("arguments", "participants"),
    [
        ((), ["robot1"]),
        ((f"planner2:={PLANNER}",), ["robot1", "robot2"]),
        (("localization:=amcl",), ["robot1/amcl", "robot1"]),
        (
            ("localization:=amcl", f"planner2:={PLANNER}"),
            ["robot1/amcl", "robot2/amcl", "robot1", "robot2"],
        ),
    ],
)
def test_lockstep_waits_for(arguments, participants):
    config = roslaunch.config.ROSLaunchConfig()
    loader = roslaunch.xmlloader.XmlLoader()
    loader.load(str(LAUNCH / "race.launch"), config, argv=list(arguments), verbose=False)
    assert config.params["/sim2d/participants"].value == participants
